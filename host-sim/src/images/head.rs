//! A head as a scanner would see it, made of ellipsoids: skin and fat around muscle around bone.

use scanray::volume::Voxels;

/// Is how many voxels there are along x, y and z.
pub(super) const SIDES: [u16; 3] = [48, 60, 56];

/// Is where voxel (0, 0, 0) stands and how far they are apart: x to the right, y up, z toward the face.
const LOW: [f64; 3] = [-0.846, -1.06, -0.98];
const SPACING: [f64; 3] = [0.036, 0.0365, 0.0365];

/// Is the values of the tissues.
const AIR: f64 = 0.0;
const FAT: f64 = 80.0;
const MUSCLE: f64 = 135.0;
const BONE: f64 = 230.0;

type Point = [f64; 3];

/// Answers about how far a point lies outside an ellipsoid.
fn ellipsoid(p: Point, center: Point, radii: Point) -> f64 {
    let norm = |q: Point| q.iter().map(|c| c * c).sum::<f64>().sqrt();
    let scaled: Point = [0, 1, 2].map(|i| (p[i] - center[i]) / radii[i]);
    let slope: Point = [0, 1, 2].map(|i| scaled[i] / radii[i]);
    norm(scaled) * (norm(scaled) - 1.0) / norm(slope).max(1e-9)
}

/// Answers a point with its left half folded over the right one.
fn folded([x, y, z]: Point) -> Point {
    [x.abs(), y, z]
}

/// Answers about how far a point lies outside the skin.
fn skin(p: Point) -> f64 {
    let q = folded(p);
    let parts = [
        ellipsoid(p, [0.0, 0.27, -0.12], [0.66, 0.70, 0.78]),
        ellipsoid(p, [0.0, -0.22, 0.22], [0.50, 0.62, 0.54]),
        // Nose, lips and chin; ears; neck.
        ellipsoid(p, [0.0, -0.17, 0.80], [0.10, 0.18, 0.14]),
        ellipsoid(p, [0.0, -0.44, 0.70], [0.20, 0.07, 0.08]),
        ellipsoid(p, [0.0, -0.69, 0.58], [0.22, 0.14, 0.17]),
        ellipsoid(q, [0.68, 0.02, -0.12], [0.06, 0.19, 0.12]),
        ellipsoid(p, [0.0, -0.95, -0.12], [0.36, 0.90, 0.36]),
    ];
    let shape = parts.into_iter().fold(f64::INFINITY, f64::min);
    // Cut off below the chin.
    shape.max(-0.98 - p[1])
}

/// Answers about how far a point lies outside the bones.
fn bone(p: Point) -> f64 {
    let q = folded(p);
    let cranium = ellipsoid(p, [0.0, 0.27, -0.12], [0.59, 0.63, 0.71]);
    let brain = ellipsoid(p, [0.0, 0.27, -0.12], [0.49, 0.53, 0.61]);
    let brow = ellipsoid(q, [0.20, 0.16, 0.48], [0.24, 0.09, 0.16]);
    let cheek = ellipsoid(q, [0.30, -0.12, 0.40], [0.15, 0.10, 0.16]).min(ellipsoid(
        q,
        [0.44, -0.09, 0.22],
        [0.06, 0.07, 0.26],
    ));
    let upper_jaw = ellipsoid(p, [0.0, -0.25, 0.40], [0.27, 0.25, 0.27]);
    let eye = ellipsoid(q, [0.20, 0.02, 0.60], [0.145, 0.125, 0.26]);
    let orbit = ellipsoid(q, [0.20, 0.02, 0.56], [0.20, 0.18, 0.30]).max(p[2] - 0.60);
    let nose = ellipsoid(q, [0.035, -0.17, 0.66], [0.065, 0.13, 0.17]);
    let face = brow.min(upper_jaw).min(cheek).min(orbit).max(-eye).max(-nose);
    let skull = cranium.max(-eye).max(-brain);
    skull.min(face).min(jaw(q)).min(teeth(p)).min(spine(p))
}

/// Answers about how far a point lies outside the lower jaw: an arch with its two branches up to the ears.
fn jaw(q: Point) -> f64 {
    let outer = ellipsoid(q, [0.0, -0.60, 0.16], [0.36, 0.13, 0.46]);
    let inner = ellipsoid(q, [0.0, -0.60, 0.06], [0.25, 0.40, 0.42]);
    let branch = ellipsoid(q, [0.35, -0.38, 0.06], [0.07, 0.27, 0.13]);
    outer.max(-inner).min(branch)
}

/// Answers about how far a point lies outside two rows of teeth.
fn teeth(p: Point) -> f64 {
    let (forward, up) = (p[2] - 0.33, (p[1] + 0.475).abs());
    let arch = ((p[0] / 0.235).hypot(forward / 0.28) - 1.0).abs() * 0.25;
    // Thinner between neighbours, and where the rows meet.
    let groove = 0.025 * (p[0].atan2(forward) * 5.5).cos().powi(8);
    let thickness = 0.05 - groove - (0.03 - up).max(0.0);
    (arch - thickness).max(up - 0.07).max(-forward)
}

/// Answers about how far a point lies outside the spine: a column with a joint every fifth of a unit.
fn spine(p: Point) -> f64 {
    let waist = 0.02 * (p[1] * 30.0).sin();
    (p[0].hypot(p[2] + 0.16) - 0.105 - waist).max(p[1] + 0.35).max(-0.73 - p[1])
}

fn tissue(p: Point) -> f64 {
    let depth = -skin(p);
    if depth < 0.0 {
        AIR
    } else if bone(p) < 0.0 {
        BONE
    } else if depth < 0.055 {
        FAT
    } else {
        MUSCLE
    }
}

/// Computes the voxels: each the mean of the tissues around it, as a scanner sees them.
pub(super) fn voxels() -> Vec<u8> {
    const PARTS: u32 = 4;
    /// Is how many voxels a mean is taken over along each axis.
    const WIDTH: f64 = 2.4;
    let offset = |i: u32| (f64::from(i) + 0.5) / f64::from(PARTS) * WIDTH - WIDTH / 2.0;
    let mean = |voxel: [u16; 3]| {
        let part = |n: u32| {
            let parts = [n % PARTS, n / PARTS % PARTS, n / PARTS / PARTS];
            tissue([0, 1, 2].map(|i| LOW[i] + (f64::from(voxel[i]) + offset(parts[i])) * SPACING[i]))
        };
        let count = PARTS.pow(3);
        ((0..count).map(part).sum::<f64>() / f64::from(count)).round() as u8
    };
    places(SIDES).map(mean).collect()
}

/// Computes the smallest and the largest value of each block.
pub(super) fn blocks() -> Vec<u8> {
    let voxels = Voxels::new(SIDES, voxels().leak());
    places(voxels.block_sides()).flat_map(|block| voxels.extremes(block)).collect()
}

/// Lists the places of a grid, x fastest.
fn places([columns, rows, slices]: [u16; 3]) -> impl Iterator<Item = [u16; 3]> {
    (0..slices).flat_map(move |z| (0..rows).flat_map(move |y| (0..columns).map(move |x| [x, y, z])))
}
