//! Compiled functions against the interpreter, bit by bit.

use super::Straight;
use crate::code::{self, Code, Instruction, Operation};

fn noise() -> impl FnMut() -> f64 {
    let mut state = 9_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Every operation, each of what those before it have left.
fn all_operations() -> Code {
    let all = [
        Operation::Ratio,
        Operation::Pi,
        Operation::Add,
        Operation::Sub,
        Operation::Mul,
        Operation::Div,
        Operation::Neg,
        Operation::MulAdd,
        Operation::Sqrt,
    ];
    let inputs = 3;
    let mut instructions: Vec<Instruction> = (inputs..)
        .zip(all)
        .map(|(to, operation)| Instruction {
            operation,
            to,
            of: [if to == inputs { 0 } else { to - 1 }, to - 2, to - 3],
        })
        .collect();
    let next = inputs + all.len() as u32;
    instructions.push(Instruction { operation: Operation::SinCos, to: next, of: [2, next + 1, 0] });
    let outputs = (inputs..next + 2).collect();
    Code {
        instructions,
        ratios: vec![[1, 3]],
        outputs,
        registers: next as usize + 2,
        native: Default::default(),
    }
}

#[test]
fn code_has_the_bits_of_the_interpreter() {
    let (code, mut noise) = (all_operations(), noise());
    let native = Straight::compile(&code).expect("programs can be compiled here");
    for _ in 0..1000 {
        let mut own: Vec<f64> = (0..code.registers).map(|_| 100.0 * noise()).collect();
        let mut compiled = own.clone();
        code::run(&code.instructions, &code.ratios, &mut own);
        native.call(&mut compiled);
        let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
        assert_eq!(bits(&own), bits(&compiled), "{own:?}\n{compiled:?}");
    }
}
