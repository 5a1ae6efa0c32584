use liftoff_core::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};

pub struct Rhs(<Chain as BarSystem>::Constants<f64>);

struct Call<'a> {
    rhs: &'a Rhs,
    q: &'a [f64; N],
    u: &'a [f64; N],
    a: &'a mut [f64; N],
}

impl PhaseVisitor<Chain, f64> for Call<'_> {
    type Output = ();

    #[inline(always)]
    fn visit<const D: usize>(self, phase: Phase<Chain, f64, D>) {
        let mut state = [0.0; D];
        state[..N].copy_from_slice(self.q);
        state[N..2 * N].copy_from_slice(self.u);
        let rates = (phase.derivative)(&self.rhs.0, &phase.set, &state);
        self.a.copy_from_slice(&rates[N..2 * N]);
    }
}

impl Rhs {
    pub fn prepare(g: f64) -> Self {
        Self(Chain { m: 1.0, l: 1.0, g }.constants())
    }

    #[inline(never)]
    pub fn rhs(&self, q: &[f64; N], u: &[f64; N], a: &mut [f64; N]) {
        Chain::phase(ContactSet::EMPTY, Form::Reduced, Call { rhs: self, q, u, a })
    }
}
