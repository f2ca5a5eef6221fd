//! Files of the Neutral File Format: read or refused, and what is read can be written.
#![no_main]

use host_sim::scene_file::{SceneFile, write};
use libfuzzer_sys::fuzz_target;
use std::path::Path;

fuzz_target!(|bytes: &[u8]| {
    match SceneFile::parse(Path::new("x.nff"), bytes.to_vec()) {
        Ok(file) => drop(write(file.description()).expect("what was read can be written")),
        Err(complaint) => assert!(!complaint.to_string().is_empty()),
    }
});
