/// Leaves first: what the bars beyond bar i need at its last end for an acceleration x is A x + p;
/// bar i adds its own and loses what its turning takes, `A' = A + 1 − u uᵀ/d`, u = (A + ½) n, d =
/// n·A n + ⅓ (R. Featherstone, *Rigid Body Dynamics Algorithms*, 2008, § 7.3).
impl Rhs {
    #[inline(never)]
    pub fn rhs(&self, q: &[f64; N], u: &[f64; N], a: &mut [f64; N]) {
        let (sin, cos) = sines(q);
        let (mut turn_x, mut turn_y, mut own) = ([0.0; N], [0.0; N], [0.0; N]);
        let (mut xx, mut xy, mut yy, mut px, mut py) = (0.0f64, 0.0f64, 0.0f64, 0.0f64, 0.0f64);
        for i in (0..N).rev() {
            let (s, c) = (sin[i], cos[i]);
            let square = u[i] * u[i];
            let (ex, ey) = (square * s, -square * c);
            let (hx, hy) = (xx.mul_add(c, xy * s), xy.mul_add(c, yy * s));
            let r = 1.0 / hx.mul_add(c, hy.mul_add(s, 1.0 / 3.0));
            let (x, y) = (0.5f64.mul_add(c, hx), 0.5f64.mul_add(s, hy));
            let (bx, by) = (
                (-xx).mul_add(ex, (-xy).mul_add(ey, px)),
                (-xy).mul_add(ex, (-yy).mul_add(ey, py)),
            );
            let t = c.mul_add(bx, s * by);
            let (lx, ly) = (x * r, y * r);
            (turn_x[i], turn_y[i], own[i]) = (lx, ly, t * r);
            (xx, xy, yy) =
                ((-lx).mul_add(x, xx + 1.0), (-lx).mul_add(y, xy), (-ly).mul_add(y, yy + 1.0));
            px = (-lx).mul_add(t, (-0.5f64).mul_add(ex, bx));
            py = (-ly).mul_add(t, (-0.5f64).mul_add(ey, by));
        }
        let (mut x, mut y) = (0.0, self.gravity);
        for i in 0..N {
            let turn = -turn_x[i].mul_add(x, turn_y[i].mul_add(y, own[i]));
            let square = u[i] * u[i];
            x = cos[i].mul_add(turn, (-square).mul_add(sin[i], x));
            y = sin[i].mul_add(turn, square.mul_add(cos[i], y));
            a[i] = turn;
        }
    }
}
