//! The door: the functions that a page calls.
//!
//! A page asks for [room](scanray_room), writes a request there as JSON and [asks](scanray_ask); the answer lies at
//! [`scanray_answer`], the pixels of a picture at [`scanray_pixels`]. What is written into the room of a file is
//! [handed over](scanray_hand) before the request to take it. Addresses hold until the next call.
// Names that a page can call by are what Rust counts as unsafe here: there is no other unsafe code.
#![allow(unsafe_code)]

use crate::desk::Desk;
use std::cell::RefCell;

/// Holds the desk and what crosses the door.
#[derive(Default)]
struct Door {
    desk: Desk,
    request: Vec<u8>,
    answer: Vec<u8>,
}

thread_local! {
    /// A page has one thread, and calls do not nest.
    static DOOR: RefCell<Door> = RefCell::default();
}

fn at_door<T>(act: impl FnOnce(&mut Door) -> T) -> T {
    DOOR.with_borrow_mut(act)
}

/// Makes room for a request of so many bytes and answers where.
#[unsafe(no_mangle)]
pub extern "C" fn scanray_room(bytes: usize) -> *mut u8 {
    at_door(|door| {
        door.request = vec![0; bytes];
        door.request.as_mut_ptr()
    })
}

/// Hands over what was written into the room: a file, which the next request takes.
#[unsafe(no_mangle)]
pub extern "C" fn scanray_hand() {
    at_door(|door| door.desk.hand(std::mem::take(&mut door.request)));
}

/// Does the request and answers how many bytes the answer has.
#[unsafe(no_mangle)]
pub extern "C" fn scanray_ask() -> usize {
    at_door(|door| {
        let answer = door.desk.ask(&door.request);
        // An answer is numbers, texts and lists of them, which all can be told in JSON.
        door.answer = serde_json::to_vec(&answer).unwrap_or_default();
        door.answer.len()
    })
}

/// Answers where the answer lies, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn scanray_answer() -> *const u8 {
    at_door(|door| door.answer.as_ptr())
}

/// Answers where the pixels of the last picture lie: red, green, blue and 255 of each.
#[unsafe(no_mangle)]
pub extern "C" fn scanray_pixels() -> *const u8 {
    at_door(|door| door.desk.pixels().as_ptr())
}
