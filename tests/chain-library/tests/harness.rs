//! The library called from Python, where there is one, and its accelerations in the equations of motion.

use std::path::PathBuf;
use std::process::Command;

use liftoff_chain::BARS;

/// Where cargo puts the shared library that it builds for a test.
fn library() -> PathBuf {
    let program = std::env::current_exe().expect("a test runs");
    program.with_file_name(format!(
        "{}liftoff_chain{}",
        std::env::consts::DLL_PREFIX,
        std::env::consts::DLL_SUFFIX
    ))
}

/// The largest |Σ_j w_kj (cos(θk − θj) αj + sin(θk − θj) ω²j) + w_k g sin θk| over the sum of its terms' sizes, w_kj the masses
/// that k and j both carry: n − max(k, j) − ½, n − k − ⅔ for k = j.
fn residual(q: &[f64], u: &[f64], a: &[f64]) -> f64 {
    let carried = |k: usize| (BARS - k) as f64 - 0.5;
    let row = |k: usize| {
        let weight = carried(k) * 9.81 * q[k].sin();
        (0..BARS).fold((weight, weight.abs()), |(sum, size), j| {
            let w = carried(k.max(j)) - if j == k { 1.0 / 6.0 } else { 0.0 };
            let (sin, cos) = (q[k] - q[j]).sin_cos();
            let term = w * (cos * a[j] + sin * u[j] * u[j]);
            (sum + term, size + term.abs())
        })
    };
    (0..BARS).map(row).map(|(sum, size)| sum.abs() / size).fold(0.0, f64::max)
}

/// The condition of the mass matrix grows with the square of the number of bars.
const TOLERANCE: f64 = (BARS * BARS) as f64 * f64::EPSILON;

#[test]
fn python_calls_it() {
    let harness = concat!(env!("CARGO_MANIFEST_DIR"), "/harness.py");
    let Ok(output) = Command::new("python3").arg(harness).arg(library()).output() else {
        eprintln!("skipped: no python3");
        return;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("numbers");
    let a: Vec<f64> = text.split_whitespace().map(|number| number.parse().expect("a number")).collect();
    assert_eq!(a.len(), BARS);
    let q: Vec<f64> = (0..BARS).map(|k| 0.1 * k as f64).collect();
    let error = residual(&q, &[1.0; BARS], &a);
    assert!(error <= TOLERANCE, "{error:e}");
}

/// In place too: accelerations over the angles.
#[test]
#[allow(unsafe_code, reason = "a C function takes pointers")]
fn writes_over_what_it_reads() {
    let (q, u) = ([0.7; BARS], [0.5; BARS]);
    let (mut a, mut over) = ([0.0; BARS], q);
    // SAFETY: arrays of BARS doubles.
    unsafe { liftoff_chain::rhs(q.as_ptr(), u.as_ptr(), a.as_mut_ptr()) };
    // SAFETY: the same, the last being the first.
    unsafe { liftoff_chain::rhs(over.as_ptr(), u.as_ptr(), over.as_mut_ptr()) };
    assert_eq!(a, over);
    assert!(residual(&q, &u, &a) <= TOLERANCE);
}

const CALLER: &str = r#"
#include "chain.h"
#include <stdio.h>

int main(void)
{
    const chain_parameters p = {1.0, 1.0, 9.81};
    chain_constants k;
    double state[CHAIN_STATE], rates[CHAIN_STATE];
    int i;
    for (i = 0; i < CHAIN_STATE; i++)
        state[i] = i < CHAIN_COORDINATES ? 0.1*i : 1.0;
    chain_constants_of(&p, NULL, &k);
    chain_free_derivative(&k, state, rates);
    for (i = CHAIN_COORDINATES; i < CHAIN_STATE; i++)
        printf("%.17g\n", rates[i]);
    return 0;
}
"#;

/// The same chain as source for C, called from C.
#[test]
fn its_source_for_c_computes_the_same() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("chain-in-c");
    std::fs::create_dir_all(&folder).expect("a folder");
    let declaration = <liftoff_chain::Chain as liftoff::BarSystem>::LAYOUT.declaration;
    let analysis = liftoff_codegen::analyse(declaration.parse().expect("tokens")).expect("a model");
    for file in liftoff_codegen::export::c(&analysis) {
        std::fs::write(folder.join(file.name), file.text).expect("a file");
    }
    std::fs::write(folder.join("caller.c"), CALLER).expect("a file");
    let mut cc = Command::new("cc");
    cc.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "caller.c", "chain.c", "-lm"]);
    let compiled = cc.current_dir(&folder).output().expect("a compiler");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = Command::new(folder.join("a.out")).output().expect("the caller");
    let text = String::from_utf8(output.stdout).expect("numbers");
    let a: Vec<f64> = text.lines().map(|number| number.parse().expect("a number")).collect();
    assert_eq!(a.len(), BARS);
    let q: Vec<f64> = (0..BARS).map(|k| 0.1 * k as f64).collect();
    let error = residual(&q, &[1.0; BARS], &a);
    assert!(error <= TOLERANCE, "{error:e}");
}
