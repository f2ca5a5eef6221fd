use super::note::What;
use crate::scene_file::shape::{FillRule, Shape, Vertex};
use crate::scene_file::value::Point;
use earcut::Earcut;
use scanray::{Polygon, Vec3};

/// Is the sine of the angle between two edges below which three corners lie on a line: twice what the core takes
/// in any number, so that rounding to it changes nothing.
const SLIVER: f64 = 1.0 / 32_768.0;

/// Is the share of its extent by which a corner may miss a polygon's plane: half of what the core takes.
const FLAT: f64 = 1.0 / 2048.0;

/// Is the cosine between a corner's normal and that of its plane below which it lies in the plane.
const LEVEL: f64 = 1.0 / 1024.0;

/// Makes a polygon; none of corners on a line, and triangles of one that is not flat.
///
/// An outline that crosses itself surrounds what is inside by the odd-even rule (E. Haines, *Point in Polygon
/// Strategies*, in Graphics Gems IV, 1994).
pub(super) fn polygon(corners: &[Point], note: &mut impl FnMut(What)) -> Vec<Shape> {
    let points: Vec<_> = corners.iter().map(|corner| Vec3::from_array(*corner)).collect();
    let Some(normals) = normals(&points) else {
        note(What::Sliver);
        return vec![];
    };
    if let [a, b, c] = *corners {
        return vec![Shape::Triangle { a, b, c }];
    }
    if let Some(normal) = normals.iter().find(|normal| is_flat(&points, **normal)) {
        let (vertices, normal) = (corners.to_vec(), normal.to_array());
        return vec![Shape::Polygon { vertices, normal, rule: FillRule::OddEven }];
    }
    note(What::Bent);
    let triangle = |(triangle, _): ([usize; 3], _)| {
        let [a, b, c] = triangle.map(|corner| corners[corner]);
        Shape::Triangle { a, b, c }
    };
    cut(&points, normals[0], note).into_iter().map(triangle).collect()
}

/// Makes the smooth triangles of a patch.
///
/// The side from which its corners run anticlockwise is outside; a normal that points to the other is turned
/// over.
pub(super) fn patch(corners: &[(Point, Point)], note: &mut impl FnMut(What)) -> Vec<Shape> {
    let points: Vec<_> = corners.iter().map(|(point, _)| Vec3::from_array(*point)).collect();
    let Some(normals) = normals(&points) else {
        note(What::Sliver);
        return vec![];
    };
    let triangles = cut(&points, normals[0], note);
    let smooth = |(triangle, outward): ([usize; 3], Vec3<f64>)| {
        let [a, b, c] = triangle.map(|corner| {
            let (point, normal) = corners[corner];
            let normal = outward_of(Vec3::from_array(normal), outward, note).to_array();
            Vertex { point, normal, texture: [0.0; 2] }
        });
        Shape::SmoothTriangle { a, b, c }
    };
    triangles.into_iter().map(smooth).collect()
}

/// Answers vectors across some corners, best first; none where they all lie on a line.
///
/// The first three corners have a normal too, for where the outline runs around as much area one way as the
/// other.
fn normals(points: &[Vec3<f64>]) -> Option<[Vec3<f64>; 2]> {
    let (first, rest) = points.split_first()?;
    let of_three = rest.windows(2).find_map(|pair| normal([*first, pair[0], pair[1]]))?;
    Some([Polygon::newell(points).unwrap_or(of_three), of_three])
}

/// Answers the unit normal of a triangle, on the side from which its corners run anticlockwise.
fn normal([a, b, c]: [Vec3<f64>; 3]) -> Option<Vec3<f64>> {
    let ((e, _), (f, _)) = ((b - a).normalize()?, (c - a).normalize()?);
    let (normal, sine) = e.cross(f).normalize()?;
    (sine > SLIVER).then_some(normal)
}

fn is_flat(points: &[Vec3<f64>], across: Vec3<f64>) -> bool {
    let Some((normal, _)) = across.normalize() else { return false };
    let from_first = || points.iter().map(|point| *point - points[0]);
    let extent = from_first().fold(0.0_f64, |most, way| most.max(way.largest()));
    from_first().all(|way| way.dot(normal).abs() <= extent * FLAT)
}

/// Cuts an outline into triangles that run around as it does; answers their corners' places and unit normals.
fn cut(points: &[Vec3<f64>], across: Vec3<f64>, note: &mut impl FnMut(What)) -> Vec<([usize; 3], Vec3<f64>)> {
    let mut corners: Vec<usize> = (0..points.len()).collect();
    if points.len() > 3 {
        Earcut::new().earcut(points.iter().map(|point| seen_along(across, *point)), &[], &mut corners);
    }
    let mut triangles = vec![];
    for triangle in corners.chunks_exact(3) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
        match normal([a, b, c].map(|corner| points[corner])) {
            Some(normal) if normal.dot(across) >= 0.0 => triangles.push(([a, b, c], normal)),
            Some(normal) => triangles.push(([a, c, b], -normal)),
            None => note(What::Piece),
        }
    }
    triangles
}

/// Drops a point onto the two axes that a direction runs least along.
fn seen_along(direction: Vec3<f64>, Vec3 { x, y, z }: Vec3<f64>) -> [f64; 2] {
    let [along_x, along_y, along_z] = direction.to_array().map(f64::abs);
    if along_x >= along_y && along_x >= along_z {
        [y, z]
    } else if along_y >= along_z {
        [z, x]
    } else {
        [x, y]
    }
}

/// Answers a corner's unit normal on the outward side of its triangle.
fn outward_of(normal: Vec3<f64>, outward: Vec3<f64>, note: &mut impl FnMut(What)) -> Vec3<f64> {
    let unit = normal.normalize().map_or(Vec3::ZERO, |(unit, _)| unit);
    let cosine = unit.dot(outward);
    if cosine.abs() < LEVEL {
        note(What::Level);
        outward
    } else if cosine < 0.0 {
        note(What::Turned);
        -unit
    } else {
        unit
    }
}
