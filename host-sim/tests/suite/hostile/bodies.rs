//! Bodies of any kind.

use super::liar::Liar;
use super::shelf::Shelf;
use super::surfaces::image;
use super::values::Values;
use host_sim::rounded::Rounded;
use scanray::{
    Cone, Cuboid, Displaced, FillRule, Gradient, Isosurface, Plane, Polygon, Shape, SmoothTriangle, Sphere,
    Triangle, Vec3,
};

/// Is any shape, a user's among them.
pub type Body<S> = Shape<S, Liar<S>>;

fn sphere<S: Rounded>(values: &mut Values<S>) -> Sphere<S> {
    Sphere::new(values.point(), values.radius())
}

fn cuboid<S: Rounded>(values: &mut Values<S>) -> Cuboid<S> {
    let (a, b) = (values.point(), values.point());
    if values.dice.one_in(10) {
        return Cuboid::new(a, b);
    }
    let low = Vec3::new(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z));
    Cuboid::new(low, Vec3::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z)))
}

fn cone<S: Rounded>(values: &mut Values<S>) -> Cone<S> {
    let apex_radius = if values.dice.one_in(2) { S::ZERO } else { values.radius() };
    let cone = Cone::new(values.point(), values.radius(), values.point(), apex_radius);
    if values.dice.one_in(2) { cone.open() } else { cone }
}

fn polygon<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Polygon<S> {
    let outline = values.dice.pick(&shelf.outlines);
    let own = Polygon::newell(outline).filter(|_| !values.dice.one_in(10));
    let normal = own.unwrap_or_else(|| values.direction());
    Polygon::new(outline, normal, values.dice.pick(&[FillRule::OddEven, FillRule::Winding]))
}

/// Answers how normals of a field are found.
pub fn gradient<S: Rounded>(values: &mut Values<S>) -> Gradient {
    values.dice.pick(&[Gradient::First, Gradient::Second])
}

pub fn body<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Body<S> {
    match values.dice.below(13) {
        0 => Shape::Plane(Plane::new(values.point(), values.direction())),
        1 => Shape::Triangle(Triangle::new(values.point(), values.point(), values.point())),
        2 | 3 => Shape::Cuboid(cuboid(values)),
        4 => Shape::Polygon(polygon(values, shelf)),
        5 | 6 => Shape::Cone(cone(values)),
        7 => Shape::SmoothTriangle(SmoothTriangle::new(values.dice.pick(&shelf.facets))),
        8 => Shape::Displaced(Displaced::new(sphere(values), image(values, shelf), values.radius())),
        9 => Shape::Mesh(values.dice.pick(&shelf.meshes)),
        10 => {
            let surface = Isosurface::new(values.dice.pick(&shelf.grids), values.between(0.0, 255.0));
            Shape::Isosurface(surface.with_gradient(gradient(values)))
        }
        11 if values.dice.one_in(4) => Shape::Custom(Liar::new(values)),
        _ => Shape::Sphere(sphere(values)),
    }
}
