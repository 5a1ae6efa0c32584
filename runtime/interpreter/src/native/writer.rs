//! Arithmetic on registers, each loaded when it is first read.

use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, FuncRef, InstBuilder, MemFlags, Signature, Value, types};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::JITModule;
use cranelift_module::{Linkage, Module};
use std::collections::BTreeMap;

use crate::code::Register;

/// What the function is called that sines and cosines are computed by.
pub(super) const SIN_COS: &str = "liftoff_sin_cos";

/// Bytes of a number.
const SIZE: i32 = 8;

/// A function while it is written.
pub(super) struct FunctionWriter<'a> {
    pub builder: FunctionBuilder<'a>,
    /// The arguments of the function; the first is that of the registers.
    pub arguments: Vec<Value>,
    sin_cos: FuncRef,
    known: BTreeMap<Register, Value>,
}

impl<'a> FunctionWriter<'a> {
    /// Declares so many pointers and numbers.
    pub fn signature(module: &JITModule, signature: &mut Signature, pointers: usize, numbers: usize) {
        let pointer = module.target_config().pointer_type();
        signature.params.extend((0..pointers).map(|_| AbiParam::new(pointer)));
        signature.params.extend((0..numbers).map(|_| AbiParam::new(types::F64)));
    }

    /// Writes a function without branches.
    pub fn function(
        module: &mut JITModule,
        context: &mut Context,
        write: impl FnOnce(&mut FunctionWriter<'_>),
    ) -> Option<()> {
        let pointer = AbiParam::new(module.target_config().pointer_type());
        let mut signature = module.make_signature();
        signature.params.extend([AbiParam::new(types::F64), pointer, pointer]);
        let sin_cos = module.declare_function(SIN_COS, Linkage::Import, &signature).ok()?;
        let sin_cos = module.declare_func_in_func(sin_cos, &mut context.func);
        let mut memory = FunctionBuilderContext::new();
        let mut builder = FunctionBuilder::new(&mut context.func, &mut memory);
        let block = builder.create_block();
        builder.append_block_params_for_function_params(block);
        builder.switch_to_block(block);
        builder.seal_block(block);
        let arguments = builder.block_params(block).to_vec();
        let mut writer = FunctionWriter { builder, arguments, sin_cos, known: BTreeMap::new() };
        write(&mut writer);
        writer.builder.ins().return_(&[]);
        writer.builder.finalize();
        Some(())
    }

    /// A number of what an argument points to.
    pub fn load(&mut self, argument: usize, place: usize) -> Value {
        let at = self.arguments[argument];
        self.builder.ins().load(types::F64, MemFlags::trusted(), at, SIZE * place as i32)
    }

    /// Writes one there.
    pub fn store(&mut self, argument: usize, place: usize, value: Value) {
        let at = self.arguments[argument];
        self.builder.ins().store(MemFlags::trusted(), value, at, SIZE * place as i32);
    }

    /// The number in a register.
    pub fn load_register(&mut self, register: Register) -> Value {
        if let Some(&known) = self.known.get(&register) {
            return known;
        }
        let value = self.load(0, register as usize);
        self.known.insert(register, value);
        value
    }

    /// From now on it is in the register; in memory only if it is kept.
    pub fn set(&mut self, register: Register, value: Value) {
        self.known.insert(register, value);
    }

    /// Writes the registers that are read once the function has returned.
    pub fn keep(&mut self, registers: impl IntoIterator<Item = Register>) {
        for register in registers {
            let value = self.load_register(register);
            self.store(0, register as usize, value);
        }
    }

    /// a · b + c, rounded as where this crate was compiled for.
    pub fn mul_add(&mut self, a: Value, b: Value, c: Value) -> Value {
        if cfg!(target_feature = "fma") {
            return self.builder.ins().fma(a, b, c);
        }
        let product = self.builder.ins().fmul(a, b);
        self.builder.ins().fadd(product, c)
    }

    /// The sine and the cosine of a number, which go to these registers.
    pub fn sin_cos(&mut self, x: Value, [sin, cos]: [Register; 2]) {
        let base = self.arguments[0];
        let [to_sin, to_cos] = [sin, cos]
            .map(|register| self.builder.ins().iadd_imm(base, i64::from(SIZE) * i64::from(register)));
        self.builder.ins().call(self.sin_cos, &[x, to_sin, to_cos]);
        for register in [sin, cos] {
            let value = self.load(0, register as usize);
            self.set(register, value);
        }
    }

    pub fn number(&mut self, value: f64) -> Value {
        self.builder.ins().f64const(value)
    }
}
