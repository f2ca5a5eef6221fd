//! Shapes in source. To add one: an arm, which the compiler asks for.

use super::literal::Literal;
use super::material::image;
use super::pool::Pool;
use super::volume::gradient;
use scanray::{FillRule, Isosurface, Shape, Sphere};

/// Writes a shape; `None` for one that there is no source for.
pub(super) fn shape<S: Literal>(shape: &Shape<S>, pool: &mut Pool<'_, S>) -> Option<String> {
    let v = S::vector;
    let text = match shape {
        Shape::Sphere(s) => format!("Sphere({})", sphere(s)),
        Shape::Plane(s) => format!("Plane(Plane::new({}, {}))", v(s.point), v(s.normal)),
        Shape::Triangle(s) => format!("Triangle(Triangle::new({}, {}, {}))", v(s.a), v(s.b), v(s.c)),
        Shape::Cuboid(s) => format!("Cuboid(Cuboid::new({}, {}))", v(s.low), v(s.high)),
        Shape::Polygon(s) => {
            let rule = match s.rule {
                FillRule::OddEven => "OddEven",
                FillRule::Winding => "Winding",
            };
            let outline = pool.outline(s.vertices);
            format!("Polygon(Polygon::new({outline}, {}, FillRule::{rule}))", v(s.normal))
        }
        Shape::Cone(s) => {
            let [base_radius, apex_radius] = [s.base_radius, s.apex_radius].map(S::number);
            let [base, apex] = [s.base, s.apex].map(v);
            let cone = format!("Cone::new({base}, {base_radius}, {apex}, {apex_radius})");
            if s.capped {
                format!("Cone({cone})")
            } else {
                format!("Cone(Cone {{ capped: false, ..{cone} }})")
            }
        }
        Shape::SmoothTriangle(s) => {
            format!("SmoothTriangle(SmoothTriangle::new({}))", pool.facet(s.vertices))
        }
        Shape::Displaced(s) => {
            let (ball, relief, height) = (sphere(&s.ball), image(&s.relief, pool), s.height.number());
            format!("Displaced(Displaced::new({ball}, {relief}, {height}))")
        }
        Shape::Mesh(mesh) => format!("Mesh({})", pool.mesh(mesh)?),
        Shape::Isosurface(s) => {
            let usual = Isosurface::new(s.grid, s.level);
            let set = if s.gradient == usual.gradient {
                String::new()
            } else {
                format!(".with_gradient({})", gradient(s.gradient))
            };
            format!("Isosurface(Isosurface::new({}, {}){set})", pool.grid(s.grid), s.level.number())
        }
        Shape::Custom(none) => match *none {},
    };
    Some(format!("Shape::{text}"))
}

fn sphere<S: Literal>(sphere: &Sphere<S>) -> String {
    format!("Sphere::new({}, {})", S::vector(sphere.center), sphere.radius.number())
}
