//! What stands in a scene.

use super::number::{Maker, Triple, difference, number, outer, sum, triple, unit};
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use scanray::{
    Cone, Cuboid, FillRule, Plane, Polygon, Scalar, Shape, SmoothTriangle, Sphere, Triangle, Vertex,
};

#[derive(Clone, Debug)]
pub enum Form {
    Sphere(Triple, f64),
    Plane(Triple, Triple),
    Triangle([Triple; 3]),
    Cuboid(Triple, Triple),
    Polygon(Outline),
    Cone { ends: [Triple; 2], radii: [f64; 2], capped: bool },
    Smooth { corners: [Triple; 3], tilts: [Triple; 3] },
}

/// Is a polygon by two edges of its plane and the places of its corners along them.
#[derive(Clone, Debug)]
pub struct Outline {
    center: Triple,
    edges: [Triple; 2],
    places: Vec<[f64; 2]>,
    rule: FillRule,
}

fn outline() -> impl Strategy<Value = Outline> {
    // Quarters times 1/64 are exact as well, so that the corners are in one plane in every number.
    let quarter = || (-4..=4_i32).prop_map(|n| f64::from(n) / 4.0);
    let places = vec([number(-2.5, 2.5), number(-2.5, 2.5)], 3..8);
    let rule = prop_oneof![Just(FillRule::OddEven), Just(FillRule::Winding)];
    let edge = move || [quarter(), quarter(), quarter()];
    (triple(-3.0, 3.0), [edge(), edge()], places, rule).prop_map(|(center, edges, places, rule)| Outline {
        center,
        edges,
        places,
        rule,
    })
}

pub fn form() -> impl Strategy<Value = Form> {
    let center = || triple(-3.0, 3.0);
    let corner = move || (center(), triple(-2.5, 2.5)).prop_map(|(c, offset)| sum(c, offset));
    // Between the multiples of 1/64, so that no plane holds a face of a box.
    let level = number(-4.0, -2.0).prop_map(|y| [0.0, y + 1.0 / 128.0, 0.0]);
    let tilt = triple(-0.25, 0.25).prop_map(|t| sum(t, [0.0, 1.0, 0.0]));
    let radii = [number(0.0, 1.5), number(0.0, 1.5)];
    let cone = ([center(), center()], radii, prop::bool::ANY).prop_map(|(ends, radii, capped)| Form::Cone {
        ends,
        radii,
        capped,
    });
    let smooth = (uniform3(corner()), uniform3(triple(-0.5, 0.5)))
        .prop_map(|(corners, tilts)| Form::Smooth { corners, tilts });
    prop_oneof![
        2 => outline().prop_map(Form::Polygon),
        2 => cone,
        2 => smooth,
        3 => (center(), number(0.25, 1.75)).prop_map(|(c, radius)| Form::Sphere(c, radius)),
        1 => (level, tilt).prop_map(|(point, normal)| Form::Plane(point, normal)),
        2 => uniform3(corner()).prop_map(Form::Triangle),
        2 => (center(), triple(0.25, 2.0)).prop_map(|(low, size)| Form::Cuboid(low, sum(low, size))),
    ]
}

impl Form {
    /// Answers the box around a body that could be of glass.
    pub fn body(&self) -> Option<[Triple; 2]> {
        match *self {
            Self::Sphere(center, radius) => {
                Some([-radius, radius].map(|reach| center.map(|along| along + reach)))
            }
            Self::Cuboid(low, high) => Some([low, high]),
            Self::Cone { ends: [base, apex], radii: [wide, narrow], capped: true } => {
                let reach = wide.max(narrow);
                let bound = |choose: fn(f64, f64) -> f64, reach: f64| {
                    std::array::from_fn(|axis| choose(base[axis], apex[axis]) + reach)
                };
                Some([bound(f64::min, -reach), bound(f64::max, reach)])
            }
            _ => None,
        }
    }
}

impl<S: Scalar> Maker<S> {
    fn polygon(&self, outline: &Outline) -> Polygon<S> {
        let Outline { center, edges: [e, f], ref places, rule } = *outline;
        let corner = |[p, q]: &[f64; 2]| {
            self.vector(std::array::from_fn(|axis| center[axis] + p * e[axis] + q * f[axis]))
        };
        let vertices: Vec<_> = places.iter().map(corner).collect();
        Polygon::new(vertices.leak(), self.vector(outer(e, f)), rule)
    }

    fn smooth(&self, corners: [Triple; 3], tilts: [Triple; 3]) -> SmoothTriangle<S> {
        let [a, b, c] = corners;
        let flat = unit(outer(difference(b, a), difference(c, a)));
        let vertex = |i: usize| {
            let normal = self.vector(unit(sum(flat, tilts[i])));
            let [u, v, _] = [[0.0, 0.5, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]][i].map(self.0);
            Vertex::new(self.vector(corners[i]), normal, [u, v])
        };
        SmoothTriangle::new(Box::leak(Box::new([vertex(0), vertex(1), vertex(2)])))
    }

    pub fn shape(&self, form: &Form) -> Shape<S> {
        match *form {
            Form::Sphere(center, radius) => Shape::Sphere(Sphere::new(self.vector(center), self.0(radius))),
            Form::Plane(point, normal) => Shape::Plane(Plane::new(self.vector(point), self.vector(normal))),
            Form::Triangle(corners) => {
                let [a, b, c] = corners.map(|corner| self.vector(corner));
                Shape::Triangle(Triangle::new(a, b, c))
            }
            Form::Polygon(ref outline) => Shape::Polygon(self.polygon(outline)),
            Form::Cone { ends: [base, apex], radii: [wide, narrow], capped } => {
                let (base, apex) = (self.vector(base), self.vector(apex));
                let cone = Cone::new(base, self.0(wide), apex, self.0(narrow));
                Shape::Cone(if capped { cone } else { cone.open() })
            }
            Form::Smooth { corners, tilts } => Shape::SmoothTriangle(self.smooth(corners, tilts)),
            Form::Cuboid(low, high) => Shape::Cuboid(Cuboid::new(self.vector(low), self.vector(high))),
        }
    }
}
