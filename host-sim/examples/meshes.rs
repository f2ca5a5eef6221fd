//! Computes the meshes of the gallery and writes them where the core includes them from.

use std::path::Path;
use std::{fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/gallery/meshes");
    for (name, bytes) in host_sim::meshes::all() {
        fs::write(folder.join(name), &bytes)?;
        let counts: Vec<u32> = bytes
            .chunks(4)
            .take(3)
            .map(|count| count.iter().rev().fold(0, |n, byte| n << 8 | u32::from(*byte)))
            .collect();
        println!(
            "{name}: {} corners, {} triangles, {} nodes, {} bytes",
            counts[0],
            counts[1],
            counts[2],
            bytes.len()
        );
    }
    Ok(())
}
