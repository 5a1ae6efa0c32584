//! What the page calls: `input(length)` gives the place of a request of so many bytes; once it is written there `call()` answers
//! it; the answer is at `output()`, `output_length()` bytes long.

use core::cell::RefCell;

use crate::{State, answer};

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUTPUT: RefCell<String> = const { RefCell::new(String::new()) };
    static STATE: RefCell<State> = RefCell::default();
}

/// Where a request of so many bytes is to be written.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.resize(length, 0);
        input.as_mut_ptr()
    })
}

/// Answers what is written there.
#[unsafe(no_mangle)]
pub extern "C" fn call() {
    let request = INPUT.with_borrow(|input| String::from_utf8_lossy(input).into_owned());
    let told = STATE.with_borrow_mut(|state| answer(state, &request));
    OUTPUT.set(told);
}

/// Where the answer begins.
#[unsafe(no_mangle)]
pub extern "C" fn output() -> *const u8 {
    OUTPUT.with_borrow(|output| output.as_ptr())
}

/// How long it is.
#[unsafe(no_mangle)]
pub extern "C" fn output_length() -> usize {
    OUTPUT.with_borrow(String::len)
}
