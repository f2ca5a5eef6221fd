//! PNG files: decoded or refused.
#![no_main]

use host_sim::scene_file::png_file;
use libfuzzer_sys::fuzz_target;
use std::io::Cursor;

/// Is the most texels that are decoded: images stay in memory as long as the program runs.
const MOST: u32 = 256;

fuzz_target!(|bytes: &[u8]| {
    match png_file::decode(Cursor::new(bytes), MOST) {
        Ok(bitmap) => assert!(bitmap.fits() && bitmap.size().iter().product::<u32>() <= MOST),
        Err(why) => assert!(!why.to_string().is_empty()),
    }
});
