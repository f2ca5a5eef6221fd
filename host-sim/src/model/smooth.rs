//! Normals for the corners of triangles that have none.

use super::vector::{area, dot, unit};
use super::{Corner, Model};
use std::collections::HashMap;

/// Is how many triangles around a place count: in a file where very many meet in one, all pairs of them would
/// take too long.
const MOST: usize = 1024;

/// Gives each corner that has none the normal of a surface which is smooth but for edges sharper than an
/// angle in degrees: the mean of the normals, by area, of those triangles around the place that are inclined
/// to its own by no more than that (H. Gouraud 1971).
pub fn smooth(model: &mut Model, degrees: f64) {
    let around = faces_around(model);
    let least = degrees.to_radians().cos();
    for triangle in model.parts.iter_mut().flat_map(|part| &mut part.triangles) {
        let Some(own) = unit(area(triangle.map(|corner| corner.place))) else { continue };
        for corner in triangle.iter_mut().filter(|corner| corner.normal.is_none()) {
            let faces = around.get(&key(corner)).map_or(&[][..], |faces| faces);
            let near =
                faces.iter().filter(|face| unit(**face).is_some_and(|face| dot(face, own) >= least - 1e-9));
            let sum = near.fold([0.0; 3], |sum, face| std::array::from_fn(|axis| sum[axis] + face[axis]));
            corner.normal = Some(unit(sum).unwrap_or(own));
        }
    }
}

/// Lists the normals of the triangles around each place, by area.
fn faces_around(model: &Model) -> HashMap<[u64; 3], Vec<[f64; 3]>> {
    let mut around: HashMap<[u64; 3], Vec<[f64; 3]>> = HashMap::new();
    for triangle in model.parts.iter().flat_map(|part| &part.triangles) {
        let face = area(triangle.map(|corner| corner.place));
        for corner in triangle {
            let faces = around.entry(key(corner)).or_default();
            if faces.len() < MOST {
                faces.push(face);
            }
        }
    }
    around
}

fn key(corner: &Corner) -> [u64; 3] {
    // Minus zero is zero.
    corner.place.map(|value| (value + 0.0).to_bits())
}

#[cfg(test)]
mod tests {
    use super::super::{Paint, Part};
    use super::*;

    /// Makes two squares that meet along the z axis at an angle, each of two triangles.
    fn roof(degrees: f64) -> Model {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let square = |x: f64, y: f64, turned: bool| {
            let places = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [x, y, 1.0], [x, y, 0.0]];
            let corner = |i: usize| Corner { place: places[i], ..Corner::default() };
            [[0, 1, 2], [0, 2, 3]].map(|[a, b, c]| if turned { [a, c, b] } else { [a, b, c] }.map(corner))
        };
        let triangles = [square(1.0, 0.0, false), square(-cosine, -sine, true)].concat();
        Model {
            name: String::new(),
            parts: vec![Part { material: 0, triangles }],
            paints: vec![Paint::default()],
        }
    }

    fn normals(model: &Model) -> Vec<[f64; 3]> {
        model.parts[0].triangles.iter().flatten().filter_map(|corner| corner.normal).collect()
    }

    #[test]
    fn an_edge_less_sharp_than_the_angle_is_rounded_and_a_sharper_one_stays() {
        let mut flat = roof(30.0);
        smooth(&mut flat, 29.0);
        assert!(normals(&flat)[..6].iter().all(|normal| dot(*normal, [0.0, 1.0, 0.0]) > 1.0 - 1e-12));
        let mut round = roof(30.0);
        smooth(&mut round, 31.0);
        let half = 15_f64.to_radians();
        let ridge = normals(&round)[0];
        assert!(dot(ridge, [-half.sin(), half.cos(), 0.0]) > 1.0 - 1e-12, "{ridge:?}");
    }

    #[test]
    fn normals_that_are_given_stay() {
        let mut model = roof(10.0);
        model.parts[0].triangles[0][0].normal = Some([1.0, 0.0, 0.0]);
        smooth(&mut model, 60.0);
        assert_eq!(normals(&model)[0], [1.0, 0.0, 0.0]);
    }
}
