//! The functions that the page calls, on the memory of the module.
//!
//! The page reserves room for a request and its numbers, fills both, makes the call,
//! and reads the parts of the answer. Each address is valid until the next call.

#![expect(unsafe_code, reason = "exporting a name is `unsafe`; no code here is")]

use std::cell::RefCell;

use crate::Reply;

/// Room for the request: its text, and the bytes of its numbers.
type Request = [Vec<u8>; 2];

/// The answer's text, the names of its lists with their lengths, the bytes of all
/// numbers, and the pixels.
type Parts = [Vec<u8>; 4];

thread_local! {
    static REQUEST: RefCell<Request> = RefCell::default();
    static PARTS: RefCell<Parts> = RefCell::default();
}

/// Reserves `length` bytes for part 0 or 1 of the request; returns their address.
#[unsafe(no_mangle)]
extern "C" fn reserve(part: usize, length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        request[part] = vec![0; length];
        request[part].as_mut_ptr()
    })
}

/// Answers the request; false if the answer is the text of an error.
pub fn answer_request(call: impl Fn(&str, &[f64]) -> Result<Reply, String>) -> bool {
    let answer = REQUEST.with_borrow(|[text, numbers]| {
        let bytes = numbers.as_chunks::<8>().0.iter();
        let numbers: Vec<_> = bytes.map(|number| f64::from_le_bytes(*number)).collect();
        call(&String::from_utf8_lossy(text), &numbers)
    });
    let is_answered = answer.is_ok();
    PARTS.set(parts(answer.unwrap_or_else(Reply::text)));
    is_answered
}

fn parts(answer: Reply) -> Parts {
    let lists = answer.numbers.iter();
    let names: Vec<_> = lists
        .clone()
        .map(|(name, numbers)| format!("{name} {}", numbers.len()))
        .collect();
    let numbers = lists.flat_map(|(_, numbers)| numbers);
    [
        answer.text.into_bytes(),
        names.join("\n").into_bytes(),
        numbers.flat_map(|number| number.to_le_bytes()).collect(),
        answer.pixels,
    ]
}

/// The address of a part of the answer.
#[unsafe(no_mangle)]
extern "C" fn part(part: usize) -> *const u8 {
    PARTS.with_borrow(|parts| parts[part].as_ptr())
}

/// The length of a part of the answer, in bytes.
#[unsafe(no_mangle)]
extern "C" fn part_length(part: usize) -> usize {
    PARTS.with_borrow(|parts| parts[part].len())
}
