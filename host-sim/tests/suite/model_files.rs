//! A model with all that a file of one may hold, computed: a vase turned on a lathe, on a chequered cloth.

use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::Path;

/// Is the outline of the vase: distances from its axis and heights, from the foot up.
const OUTLINE: [[f64; 2]; 11] = [
    [0.0, 0.0],
    [0.5, 0.0],
    [0.55, 0.1],
    [0.35, 0.3],
    [0.6, 0.75],
    [0.85, 1.2],
    [0.8, 1.65],
    [0.5, 2.0],
    [0.36, 2.25],
    [0.42, 2.45],
    [0.55, 2.55],
];

/// Counts the corners around the axis.
const SIDES: usize = 32;

/// Is the materials of the model.
pub const LIBRARY: &str = "\
# Glaze and cloth
newmtl glaze
Kd 0.05 0.25 0.55
Ks 0.6 0.6 0.6
Ka 0.05 0.25 0.55
Ns 60
illum 2

newmtl cloth
Kd 1 1 1
map_Kd cloth.png
";

/// Writes the model: the vase with normals, the cloth with texture coordinates.
pub fn vase() -> String {
    let mut text = String::from("# A vase on a cloth\nmtllib vase.mtl\no vase\nusemtl glaze\n");
    for [radius, height] in OUTLINE {
        for side in 0..SIDES {
            let (sine, cosine) = (TAU * side as f64 / SIDES as f64).sin_cos();
            let _ = writeln!(text, "v {:.6} {height} {:.6}", 10.0 + radius * cosine, radius * sine);
        }
    }
    for ring in 0..OUTLINE.len() {
        // Across the way from the ring below to the ring above.
        let [below, above] = [ring.saturating_sub(1), (ring + 1).min(OUTLINE.len() - 1)].map(|i| OUTLINE[i]);
        let (out, up) = (above[1] - below[1], below[0] - above[0]);
        for side in 0..SIDES {
            let (sine, cosine) = (TAU * side as f64 / SIDES as f64).sin_cos();
            let _ = writeln!(text, "vn {:.6} {up:.6} {:.6}", out * cosine, out * sine);
        }
    }
    for ring in 1..OUTLINE.len() {
        for side in 0..SIDES {
            let at = |ring: usize, side: usize| ring * SIDES + side % SIDES + 1;
            let corners = [at(ring - 1, side), at(ring, side), at(ring, side + 1), at(ring - 1, side + 1)];
            let corners = corners.map(|corner| format!("{corner}//{corner}"));
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
    }
    text += "o cloth\nusemtl cloth\nv 8.2 0 -1.8\nv 11.8 0 -1.8\nv 11.8 0 1.8\nv 8.2 0 1.8\n";
    text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\ns off\nf -4/1 -1/4 -2/3 -3/2\n";
    text
}

/// Writes the model, its library and its image into a folder.
pub fn write(folder: &Path) {
    std::fs::write(folder.join("vase.obj"), vase()).unwrap();
    std::fs::write(folder.join("vase.mtl"), LIBRARY).unwrap();
    let cloth = image::RgbImage::from_fn(16, 16, |x, y| {
        image::Rgb(if (x / 2 + y / 2) % 2 == 0 { [230, 220, 200] } else { [170, 60, 40] })
    });
    cloth.save(folder.join("cloth.png")).unwrap();
}
