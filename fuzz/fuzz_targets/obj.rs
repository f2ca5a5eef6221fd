//! OBJ files and their libraries, one behind the other with a zero between: read or refused.
#![no_main]

use host_sim::obj;
use libfuzzer_sys::fuzz_target;
use std::path::Path;

fuzz_target!(|bytes: &[u8]| {
    let text = String::from_utf8_lossy(bytes);
    let (model, library) = text.split_once('\0').unwrap_or((&text, ""));
    match obj::parse(Path::new("/nowhere/x.obj"), model, &mut |_| Ok(library.to_owned())) {
        Ok(model) => drop(model.count()),
        Err(mistake) => assert!(!mistake.to_string().is_empty()),
    }
});
