//! Vectors in the plane, as values of a program.

use crate::program::{Id, Program};

/// x and y.
pub type Vector = [Id; 2];

/// v⊥ = (−y, x).
pub fn normal(program: &mut Program, [x, y]: Vector) -> Vector {
    [program.neg(y), x]
}

/// a · b.
pub fn dot(program: &mut Program, a: Vector, b: Vector) -> Id {
    program.dot(a.into_iter().zip(b))
}

/// a · b + c.
pub fn dot_add(program: &mut Program, a: Vector, b: Vector, c: Id) -> Id {
    let sum = program.mul_add(a[0], b[0], c);
    program.mul_add(a[1], b[1], sum)
}

/// k v + w.
pub fn scaled_add(program: &mut Program, k: Id, v: Vector, w: Vector) -> Vector {
    [0, 1].map(|axis| program.mul_add(k, v[axis], w[axis]))
}

/// v + w.
pub fn add(program: &mut Program, v: Vector, w: Vector) -> Vector {
    [0, 1].map(|axis| program.add(v[axis], w[axis]))
}

/// v − w.
pub fn sub(program: &mut Program, v: Vector, w: Vector) -> Vector {
    [0, 1].map(|axis| program.sub(v[axis], w[axis]))
}
