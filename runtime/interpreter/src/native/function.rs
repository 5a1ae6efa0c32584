//! Compiled functions. Their memory is kept as long as the program runs, as names are.
//!
//! Measured (`cargo bench -p liftoff-tests --features jit --bench speed --
//! interpreted`): see the book. Calling what is compiled is the only unsafe code of this crate. It
//! is sound because
//!
//! - a pointer is taken from Cranelift once its function is finished, and the module that owns its
//!   memory is never freed;
//! - the functions read and write nothing but `registers[r]` for registers r of the code that they
//!   were compiled from, all less than its count, and `left`, `right`, `kept`, `sums` at columns
//!   less than its count: both are asserted before every call;
//! - they call nothing but `sin_cos`, which writes to two such registers.

use core::mem::transmute;

use cranelift_codegen::settings::{self, Configurable};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{Linkage, Module, default_libcall_names};
use liftoff_core::scalar::Real;
use liftoff_core::series::Row;

use super::writer::{FunctionWriter, SIN_COS};
use crate::code::Code;
use crate::series::SeriesCode;

type StraightFunction = extern "C" fn(*mut f64);
type OrderFunction = extern "C" fn(*mut f64, *mut f64, *mut f64, *const [f64; 2], *const f64, f64, f64);

/// Code as a function of its registers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Straight {
    function: StraightFunction,
    registers: usize,
}

impl Straight {
    /// None where this processor, or what runs on it, does not let programs be compiled.
    pub fn compile(code: &Code) -> Option<Self> {
        if !code.is_native() {
            return None;
        }
        let pointer = compiled(1, 0, |writer| super::straight::write(writer, code))?;
        // The signature is the one that `compiled` declares for one pointer and no number.
        #[allow(unsafe_code, reason = "the module's proof")]
        let function = unsafe { transmute::<*const u8, StraightFunction>(pointer) };
        Some(Self { function, registers: code.registers })
    }

    /// Computes the outputs' registers from those of constants and inputs.
    pub fn call(&self, registers: &mut [f64]) {
        assert!(registers.len() >= self.registers);
        (self.function)(registers.as_mut_ptr());
    }
}

/// One order n > 0 of a series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Order {
    function: OrderFunction,
    registers: usize,
    columns: usize,
}

impl Order {
    /// None where it cannot be compiled.
    pub fn compile(code: &SeriesCode) -> Option<Self> {
        if !code.is_native() {
            return None;
        }
        let pointer = compiled(5, 2, |writer| super::series::write(writer, code))?;
        // The signature is the one that `compiled` declares for five pointers and two numbers.
        #[allow(unsafe_code, reason = "the module's proof")]
        let function = unsafe { transmute::<*const u8, OrderFunction>(pointer) };
        Some(Self { function, registers: code.registers, columns: code.columns })
    }

    /// Computes the registers of an order from those of the state's coefficients.
    pub fn call(&self, registers: &mut [f64], row: Row<'_, f64>, n: usize) {
        let Row { left, right, kept, sums } = row;
        let columns = [left.len(), right.len(), kept.len(), sums.len()];
        assert!(registers.len() >= self.registers && columns.iter().all(|&count| count >= self.columns));
        let (order, part) = (n as f64, <f64 as Real>::ratio(1, n as i64));
        let (left, right) = (left.as_mut_ptr(), right.as_mut_ptr());
        (self.function)(registers.as_mut_ptr(), left, right, kept.as_ptr(), sums.as_ptr(), order, part);
    }
}

/// A function of so many pointers and numbers.
fn compiled(
    pointers: usize,
    numbers: usize,
    write: impl FnOnce(&mut FunctionWriter<'_>),
) -> Option<*const u8> {
    let mut flags = settings::builder();
    flags.set("opt_level", "speed").ok()?;
    flags.set("is_pic", "false").ok()?;
    flags.set("use_colocated_libcalls", "false").ok()?;
    let target = cranelift_native::builder().ok()?.finish(settings::Flags::new(flags)).ok()?;
    let mut builder = JITBuilder::with_isa(target, default_libcall_names());
    builder.symbol(SIN_COS, sin_cos as *const u8);
    let mut module = JITModule::new(builder);
    let mut context = module.make_context();
    FunctionWriter::signature(&module, &mut context.func.signature, pointers, numbers);
    let name = module.declare_function("compiled", Linkage::Local, &context.func.signature).ok()?;
    FunctionWriter::function(&mut module, &mut context, write)?;
    module.define_function(name, &mut context).ok()?;
    module.finalize_definitions().ok()?;
    let pointer = module.get_finalized_function(name);
    // Its memory is not freed.
    core::mem::forget(module);
    Some(pointer)
}

/// What compiled code calls: as in the interpreter.
extern "C" fn sin_cos(x: f64, sin: &mut f64, cos: &mut f64) {
    (*sin, *cos) = Real::sin_cos(x);
}
