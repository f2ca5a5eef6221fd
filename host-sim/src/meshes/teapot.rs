//! The Utah teapot, by the numbers of its maker (M. Newell 1975), with the bottom that F. Crow gave it (1987).

use super::bezier::{Patch, tessellate};
use crate::bake::Indexed;

/// Is how often each of the 32 patches is cut along either side: 4 make several hundred triangles.
const CUTS: u16 = 4;

/// Lists what is turned on a lathe, the profiles of rim, body, lid and bottom: radius and height of four
/// control points, from the inside out and from the top down.
const PROFILES: [[[f64; 2]; 4]; 6] = [
    [[1.4, 2.4], [1.3375, 2.53125], [1.4375, 2.53125], [1.5, 2.4]],
    [[1.5, 2.4], [1.75, 1.875], [2.0, 1.35], [2.0, 0.9]],
    [[2.0, 0.9], [2.0, 0.45], [1.5, 0.225], [1.5, 0.15]],
    [[0.0, 3.15], [0.8, 3.15], [0.0, 2.85], [0.2, 2.7]],
    [[0.2, 2.7], [0.4, 2.55], [1.3, 2.55], [1.3, 2.4]],
    [[1.5, 0.15], [1.5, 0.075], [1.425, 0.0], [0.0, 0.0]],
];

/// Is how far out the inner control points of a quarter are, of the radius: nearly a circle's 0.5523.
const ROUND: f64 = 0.56;

/// Lists the halves of handle and spout toward the viewer: rows of four control points from the plane of
/// symmetry out to the side and back; along, across, height.
const SIDES: [Patch; 4] = [
    [
        [[-1.6, 0.0, 2.025], [-1.6, -0.3, 2.025], [-1.5, -0.3, 2.25], [-1.5, 0.0, 2.25]],
        [[-2.3, 0.0, 2.025], [-2.3, -0.3, 2.025], [-2.5, -0.3, 2.25], [-2.5, 0.0, 2.25]],
        [[-2.7, 0.0, 2.025], [-2.7, -0.3, 2.025], [-3.0, -0.3, 2.25], [-3.0, 0.0, 2.25]],
        [[-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8]],
    ],
    [
        [[-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8]],
        [[-2.7, 0.0, 1.575], [-2.7, -0.3, 1.575], [-3.0, -0.3, 1.35], [-3.0, 0.0, 1.35]],
        [[-2.5, 0.0, 1.125], [-2.5, -0.3, 1.125], [-2.65, -0.3, 0.9375], [-2.65, 0.0, 0.9375]],
        [[-2.0, 0.0, 0.9], [-2.0, -0.3, 0.9], [-1.9, -0.3, 0.6], [-1.9, 0.0, 0.6]],
    ],
    [
        [[1.7, 0.0, 1.425], [1.7, -0.66, 1.425], [1.7, -0.66, 0.6], [1.7, 0.0, 0.6]],
        [[2.6, 0.0, 1.425], [2.6, -0.66, 1.425], [3.1, -0.66, 0.825], [3.1, 0.0, 0.825]],
        [[2.3, 0.0, 2.1], [2.3, -0.25, 2.1], [2.4, -0.25, 2.025], [2.4, 0.0, 2.025]],
        [[2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4]],
    ],
    [
        [[2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4]],
        [[2.8, 0.0, 2.475], [2.8, -0.25, 2.475], [3.525, -0.25, 2.49375], [3.525, 0.0, 2.49375]],
        [[2.9, 0.0, 2.475], [2.9, -0.15, 2.475], [3.45, -0.15, 2.5125], [3.45, 0.0, 2.5125]],
        [[2.8, 0.0, 2.4], [2.8, -0.15, 2.4], [3.2, -0.15, 2.4], [3.2, 0.0, 2.4]],
    ],
];

/// Makes the teapot, upright along y, its spout toward high x, standing on y = 0.
pub fn teapot() -> Indexed {
    let turned = PROFILES.iter().flat_map(|profile| (0..4).map(|quarter| turn(profile, quarter)));
    let halves = SIDES.iter().flat_map(|half| [*half, mirrored(half)]);
    let upright = |[along, across, height]: [f64; 3]| [along, height, -across];
    let patches: Vec<Patch> = turned.chain(halves).map(|patch| patch.map(|row| row.map(upright))).collect();
    tessellate(&patches, CUTS)
}

/// Turns a profile through a quarter of a circle.
fn turn(profile: &[[f64; 2]; 4], quarter: u32) -> Patch {
    profile.map(|[radius, height]| {
        // The widest ring of the knob alone has other ones.
        let inner = if [radius, height] == [0.8, 3.15] { 0.45 } else { ROUND * radius };
        [[radius, 0.0], [radius, -inner], [inner, -radius], [0.0, -radius]].map(|mut place| {
            (0..quarter).for_each(|_| place = [place[1], -place[0]]);
            [place[0], place[1], height]
        })
    })
}

/// Answers the other half of what is the same on either side.
fn mirrored(half: &Patch) -> Patch {
    half.map(|row| {
        let [a, b, c, d] = row.map(|[along, across, height]| [along, -across, height]);
        [d, c, b, a]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_teapot_is_seen_from_outside() {
        let pot = teapot();
        let outward = pot.triangles.iter().filter(|triangle| {
            let [a, b, c] = triangle.map(|corner| pot.places[usize::from(corner)]);
            let edge = |to: [f64; 3], axis: usize| to[axis] - a[axis];
            let normal: [f64; 3] = std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                edge(b, j) * edge(c, k) - edge(b, k) * edge(c, j)
            });
            let given = pot.normals[usize::from(triangle[0])];
            normal.iter().zip(given).map(|(a, b)| a * b).sum::<f64>() > 0.0
        });
        assert_eq!(outward.count(), pot.triangles.len(), "normals and triangles look the same way");
        // The body's outermost corner looks outward.
        let rim = pot.places.iter().zip(&pot.normals).filter(|(place, _)| (place[1] - 1.35).abs() < 0.3);
        for (place, normal) in rim.filter(|(place, _)| place[0].abs() < 0.5 && place[2] > 1.7) {
            assert!(normal[2] > 0.0, "{place:?} {normal:?}");
        }
    }
}
