use super::note::What;
use crate::scene_file::shape::Shape;
use crate::scene_file::value::Point;

/// Makes a ball; none of no radius.
pub(super) fn sphere(center: Point, radius: f64, note: &mut impl FnMut(What)) -> Option<Shape> {
    if radius == 0.0 {
        note(What::Nothing);
        return None;
    }
    if radius < 0.0 {
        note(What::Inside);
    }
    Some(Shape::Sphere { center, radius: radius.abs() })
}

/// Makes an open cone or cylinder; none without a way between its ends or without any radius.
pub(super) fn cone([base, apex]: [Point; 2], radii: [f64; 2], note: &mut impl FnMut(What)) -> Option<Shape> {
    if base == apex || radii == [0.0; 2] {
        note(What::Nothing);
        return None;
    }
    if radii.iter().any(|radius| *radius < 0.0) {
        note(What::Inside);
    }
    let [base_radius, apex_radius] = radii.map(f64::abs);
    Some(Shape::Cone { base, base_radius, apex, apex_radius, capped: Some(false) })
}
