//! Triangles that share their corners, in pieces of no more than a mesh can number.

use super::vector::{area, sub, unit};
use super::{Corner, Model};
use crate::bake::octahedron::{self, fold};
use crate::bake::steps::Steps;
use std::collections::HashMap;

/// Is how many triangles and how many corners a mesh can number.
const MOST: usize = u16::MAX as usize;

/// Is how corners are told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Packing {
    /// In 16 bits a coordinate and four bytes a normal.
    Packed(Steps),
    /// As they are.
    Exact,
}

/// Is triangles of one material that share their corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Place of the material in the model's list.
    pub material: usize,
    /// Numbers of the corners of each triangle.
    pub triangles: Vec<[u16; 3]>,
    /// Where the corners are.
    pub places: Vec<[f64; 3]>,
    /// Unit normals at the corners; none where the piece is flat.
    pub normals: Vec<[f64; 3]>,
    /// Texture coordinates of the corners; none where the piece has none.
    pub texture: Vec<[f64; 2]>,
}

/// Is what tells corners apart.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Key {
    place: [u64; 3],
    normal: Option<[u64; 3]>,
    texture: Option<[u64; 2]>,
}

impl Packing {
    fn key(&self, corner: &Corner) -> Key {
        let bits = |value: f64| (value + 0.0).to_bits();
        let texture = corner.texture.map(|texture| texture.map(bits));
        match self {
            Self::Packed(grid) => Key {
                place: grid.steps(corner.place).map(u64::from),
                normal: corner.normal.map(|normal| {
                    let [u, v] = fold(normal);
                    [u as u64, v as u64, 0]
                }),
                texture,
            },
            Self::Exact => Key {
                place: corner.place.map(bits),
                normal: corner.normal.map(|normal| normal.map(bits)),
                texture,
            },
        }
    }

    /// Answers where a corner is, told in this way.
    pub fn place(&self, place: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Packed(grid) => grid.place(grid.steps(place)),
            Self::Exact => place,
        }
    }

    /// Answers by how many degrees the normals of pieces are off at most.
    pub fn normal_error(&self, pieces: &[Piece]) -> f64 {
        match self {
            Self::Packed(_) => {
                let normals = pieces.iter().flat_map(|piece| &piece.normals);
                normals.map(|normal| octahedron::error(*normal)).fold(0.0, f64::max)
            }
            Self::Exact => 0.0,
        }
    }

    /// Tells whether a triangle has hardly any area: its height is less than 1e-6 of its longest side.
    fn is_degenerate(&self, triangle: &[Corner; 3]) -> bool {
        let places = triangle.map(|corner| self.place(corner.place));
        let square = |v: [f64; 3]| v.iter().map(|value| value * value).sum::<f64>();
        let [a, b, c] = places;
        let longest = [sub(b, a), sub(c, b), sub(a, c)].map(square).into_iter().fold(0.0, f64::max);
        square(area(places)) <= 1e-12 * longest * longest
    }
}

/// Makes pieces of a model, and counts the triangles that are left out because they have no area.
pub fn pieces(model: &Model, packing: &Packing) -> (Vec<Piece>, usize) {
    let (mut pieces, mut dropped) = (vec![], 0);
    for part in &model.parts {
        let mut numbers = HashMap::new();
        let mut piece = Piece { material: part.material, ..Piece::default() };
        for triangle in &part.triangles {
            if packing.is_degenerate(triangle) {
                dropped += 1;
                continue;
            }
            let triangle = triangle.map(unit_normal);
            if piece.triangles.len() == MOST || piece.places.len() + 3 > MOST {
                pieces.push(std::mem::take(&mut piece));
                piece.material = part.material;
                numbers.clear();
            }
            let corners = triangle
                .map(|corner| *numbers.entry(packing.key(&corner)).or_insert_with(|| piece.add(&corner)));
            piece.triangles.push(corners);
        }
        pieces.extend(Some(piece).filter(|piece| !piece.triangles.is_empty()));
    }
    (pieces, dropped)
}

/// Scales a corner's normal to unit length; one without length is none, but there must be one where others
/// are.
fn unit_normal(corner: Corner) -> Corner {
    Corner { normal: corner.normal.map(|normal| unit(normal).unwrap_or([0.0, 1.0, 0.0])), ..corner }
}

impl Piece {
    /// Adds a corner, and answers its number.
    fn add(&mut self, corner: &Corner) -> u16 {
        self.places.push(corner.place);
        self.normals.extend(corner.normal);
        self.texture.extend(corner.texture);
        (self.places.len() - 1) as u16
    }

    /// Answers where the corners of a triangle are, told in a way.
    pub fn corners(&self, triangle: [u16; 3], packing: &Packing) -> [[f64; 3]; 3] {
        triangle.map(|number| packing.place(self.places[usize::from(number)]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Paint, Part};
    use super::*;
    use crate::bake::Bounds;

    fn model(triangles: Vec<[Corner; 3]>) -> Model {
        Model {
            name: String::new(),
            parts: vec![Part { material: 0, triangles }],
            paints: vec![Paint::default()],
        }
    }

    /// Makes a strip of triangles along x, each with corners of its own.
    fn strip(count: usize) -> Model {
        let corner = |i: usize| Corner { place: [i as f64, (i % 2) as f64, 0.0], ..Corner::default() };
        model((0..count).map(|i| [corner(i), corner(i + 1), corner(i + 2)]).collect())
    }

    #[test]
    fn triangles_share_their_corners() {
        let (pieces, dropped) = pieces(&strip(10), &Packing::Exact);
        assert_eq!((pieces[0].triangles.len(), pieces[0].places.len(), dropped), (10, 12, 0));
    }

    #[test]
    fn a_corner_with_two_normals_is_two_corners() {
        let mut model = strip(2);
        for (triangle, normal) in model.parts[0].triangles.iter_mut().zip([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
        {
            triangle.iter_mut().for_each(|corner| corner.normal = Some(normal));
        }
        assert_eq!(pieces(&model, &Packing::Exact).0[0].places.len(), 6);
    }

    #[test]
    fn what_is_too_much_for_a_mesh_becomes_several_that_hold_all() {
        let model = strip(150_000);
        let grid = Steps::over(&Bounds { low: [0.0; 3], high: [200_000.0, 1.0, 1.0] });
        let (pieces, dropped) = pieces(&model, &Packing::Exact);
        assert_eq!(pieces.iter().map(|piece| piece.triangles.len()).sum::<usize>(), 150_000);
        assert!(pieces.len() == 3 && pieces.iter().all(|piece| piece.places.len() <= MOST));
        assert_eq!(dropped, 0);
        // Told in steps three units wide some triangles have no area left.
        assert!(super::pieces(&model, &Packing::Packed(grid)).1 > 0);
    }

    #[test]
    fn triangles_without_area_are_left_out_and_counted() {
        let mut model = strip(3);
        model.parts[0].triangles[1][2].place = model.parts[0].triangles[1][0].place;
        let (pieces, dropped) = pieces(&model, &Packing::Exact);
        assert_eq!((pieces[0].triangles.len(), dropped), (2, 1));
    }
}
