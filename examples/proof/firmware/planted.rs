//! Defects for the inspection to find: an image without any proves nothing of an inspection that never finds one.
//!
//! The environment variable `SCANRAY_PLANTED` says whether the image has them.

use core::hint::black_box;

/// Calls the planted functions in an image that is built to have them.
pub fn call() {
    if matches!(option_env!("SCANRAY_PLANTED"), Some("yes")) {
        let (bytes, number) = (black_box([0; 4].as_slice()), black_box(1));
        black_box((index(bytes, number), overflow(number), division(number), unwrap(bytes)));
    }
}

#[inline(never)]
fn index(bytes: &[u8], at: usize) -> u8 {
    bytes[at]
}

#[inline(never)]
fn overflow(number: usize) -> usize {
    number + 1
}

#[inline(never)]
fn division(number: usize) -> usize {
    7 / number
}

#[inline(never)]
fn unwrap(bytes: &[u8]) -> u8 {
    *bytes.first().unwrap()
}
