//! Entry 13: slider-crank with the crank at φ = ωt: sin ψ = −(r/l) sin φ, x = r cos φ + l cos ψ.
//! The torque that keeps the crank steady is what changes T = ½ ω² G(φ): ½ ω² G′.

/// Masses of crank, rod and piston, lengths of crank and rod.
#[derive(Clone, Copy, Debug)]
pub struct SliderCrank {
    /// Of crank, rod and piston.
    pub masses: [f64; 3],
    /// Of the crank.
    pub crank: f64,
    /// Of the rod.
    pub rod: f64,
}

impl SliderCrank {
    /// ψ and its first two derivatives by φ.
    fn rod_angle(&self, phi: f64) -> [f64; 3] {
        let (sin, cos) = phi.sin_cos();
        let ratio = self.crank / self.rod;
        let psi = (-ratio * sin).asin();
        let first = -ratio * cos / psi.cos();
        let second = (ratio * sin + first * first * psi.sin()) / psi.cos();
        [psi, first, second]
    }

    /// Position of the piston and its first two derivatives by φ.
    pub fn piston(&self, phi: f64) -> [f64; 3] {
        let (sin, cos) = phi.sin_cos();
        let [psi, first, second] = self.rod_angle(phi);
        let (r, l) = (self.crank, self.rod);
        let bend = -l * (psi.cos() * first * first + psi.sin() * second);
        [r * cos + l * psi.cos(), -r * sin - l * psi.sin() * first, -r * cos + bend]
    }

    /// Torque of the drive at the rate ω.
    pub fn torque(&self, phi: f64, omega: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let (r, l) = (self.crank, self.rod);
        let [_, rod, piston] = self.masses;
        let [_, turn, bend] = self.rod_angle(phi);
        let [_, rate, rise] = self.piston(phi);
        // the rod's centre is midway between its ends, its inertia m l²/12
        let centre = [0.5 * (rate - r * sin), 0.5 * r * cos];
        let change = [0.5 * (rise - r * cos), -0.5 * r * sin];
        let rod_part = centre[0] * change[0] + centre[1] * change[1] + l * l / 12.0 * turn * bend;
        omega * omega * (rod * rod_part + piston * rate * rise)
    }
}
