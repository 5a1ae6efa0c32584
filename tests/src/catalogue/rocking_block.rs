//! Entry 8: Housner's block, b broad and h high, tan α = b/h, on rough corners.

/// What a plastic impact on the other corner leaves of the rate: 1 − (3/2) sin² α.
pub fn rate_kept(breadth: f64, height: f64) -> f64 {
    1.0 - 1.5 * breadth * breadth / (breadth * breadth + height * height)
}

/// φ̇² about a corner after rest at φ₀: mgR(cos(α − φ₀) − cos(α − φ)) against ½ (4/3) m R² φ̇².
pub fn rate_squared(breadth: f64, height: f64, gravity: f64, start: f64, phi: f64) -> f64 {
    let (alpha, radius) = ((breadth / height).atan(), 0.5 * breadth.hypot(height));
    // cos(α − φ₀) − cos(α − φ) as a product
    let drop = 2.0 * (0.5 * (2.0 * alpha - phi - start)).sin() * (0.5 * (start - phi)).sin();
    1.5 * gravity / radius * drop
}
