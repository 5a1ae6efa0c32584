//! What an expert writes for a chain of n equal bars, lengths and masses 1, g over the length
//! given: straight-line LDLᵀ, and the recursion from the last bar to the first; sines inlined,
//! products and sums fused.

use core::fmt::Write;

const SINES: &str = include_str!("sines.rs");
const RECURSION: &str = include_str!("recursion.rs");

/// Operations of one bar in [`RECURSION`], counted in its text: fused ones as one.
const OPERATIONS_OF_A_BAR: usize = 42;

/// The recursion, and its operations.
pub fn recursion(bars: usize) -> (String, usize) {
    (format!("{SINES}\n{RECURSION}\nconst N: usize = {bars};\n"), OPERATIONS_OF_A_BAR * bars)
}

/// `M_ij = w_ij cos(θᵢ − θⱼ)`, `fᵢ = −Σ w_ij sin(θᵢ − θⱼ) ω²ⱼ − w_i g sin θᵢ`, w_ij the masses that
/// i and j both carry, n − j − ½ for i < j, n − i − ⅔ for i = j; eliminated from the last bar on.
pub fn ldl(bars: usize) -> (String, usize) {
    let mut text = Straight::default();
    for i in 0..bars {
        text.line(0, format!("let (s{i}, c{i}) = (s[{i}], c[{i}])"));
        text.line(1, format!("let v{i} = u[{i}] * u[{i}]"));
        text.line(1, format!("let f{i} = {:?} * self.gravity * s{i}", -(carried(bars, i))));
        text.line(0, format!("let m{i}_{i} = {:?}_f64", carried(bars, i) - 1.0 / 6.0));
    }
    for j in 0..bars {
        (0..j).for_each(|i| text.pair(i, j, carried(bars, j)));
    }
    (0..bars).rev().for_each(|k| text.eliminate(k));
    (0..bars).for_each(|k| text.substitute(k));
    (format!("{SINES}\n{}", text.function(bars)), text.operations)
}

/// Bars beyond bar i and half of it.
fn carried(bars: usize, i: usize) -> f64 {
    (bars - i) as f64 - 0.5
}

#[derive(Default)]
struct Straight {
    lines: String,
    operations: usize,
}

impl Straight {
    fn line(&mut self, operations: usize, text: String) {
        self.operations += operations;
        writeln!(self.lines, "        {text};").expect("text grows");
    }

    fn pair(&mut self, i: usize, j: usize, w: f64) {
        self.line(3, format!("let m{i}_{j} = {w:?} * c{i}.mul_add(c{j}, s{i} * s{j})"));
        self.line(3, format!("let h = {w:?} * s{i}.mul_add(c{j}, -(c{i} * s{j}))"));
        self.line(2, format!("let (f{i}, f{j}) = ((-h).mul_add(v{j}, f{i}), h.mul_add(v{i}, f{j}))"));
    }

    fn eliminate(&mut self, k: usize) {
        self.line(1, format!("let r{k} = 1.0 / m{k}_{k}"));
        for i in 0..k {
            self.line(1, format!("let l{i}_{k} = m{i}_{k} * r{k}"));
            self.line(1, format!("let f{i} = (-l{i}_{k}).mul_add(f{k}, f{i})"));
        }
        for i in 0..k {
            for j in i..k {
                self.line(1, format!("let m{i}_{j} = (-l{i}_{k}).mul_add(m{j}_{k}, m{i}_{j})"));
            }
        }
    }

    fn substitute(&mut self, k: usize) {
        self.line(1, format!("let a{k} = f{k} * r{k}"));
        for i in 0..k {
            self.line(1, format!("let a{k} = (-l{i}_{k}).mul_add(a{i}, a{k})"));
        }
        self.line(0, format!("a[{k}] = a{k}"));
    }

    fn function(&self, bars: usize) -> String {
        format!(
            "const N: usize = {bars};
impl Rhs {{
    #[inline(never)]
    pub fn rhs(&self, q: &[f64; N], u: &[f64; N], a: &mut [f64; N]) {{
        let (s, c) = sines(q);
{}    }}
}}
",
            self.lines
        )
    }
}
