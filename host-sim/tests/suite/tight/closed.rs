//! Rays into closed meshes: none gets through.

use crate::hostile::dice::Dice;
use host_sim::bake::{Accel, Bounds};
use host_sim::rounded::Rounded;
use scanray::ray::{Interval, Ray};
use scanray::{Corners, Fixed, Intersect, Mesh, Normals, Shape, SmoothTriangle, Triangle, Vec3, Vertex};
use std::collections::HashMap;
use std::f64::consts::TAU;

type Point = [f64; 3];

/// Is a closed surface, with points that it surrounds.
struct Closed {
    name: &'static str,
    places: Vec<Point>,
    triangles: Vec<[u16; 3]>,
    inside: Vec<Point>,
}

fn cube() -> Closed {
    let places = (0..8).map(|i| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * 2.0 - 1.0)).collect();
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = squares.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    Closed { name: "cube", places, triangles, inside: vec![[0.0; 3], [0.5, -0.25, 0.75], [0.9, 0.9, 0.9]] }
}

/// Makes a ball of an octahedron whose triangles are cut into four, so often.
fn ball(cuts: usize) -> Closed {
    let mut places: Vec<Point> = [0, 1, 2]
        .iter()
        .flat_map(|axis| [1.0, -1.0].map(|sign| std::array::from_fn(|i| if i == *axis { sign } else { 0.0 })))
        .collect();
    let corner = |signs: usize| [signs & 1, 2 + (signs >> 1 & 1), 4 + (signs >> 2 & 1)].map(|n| n as u16);
    let mut triangles: Vec<[u16; 3]> = (0..8).map(corner).collect();
    for _ in 0..cuts {
        let mut middles: HashMap<[u16; 2], u16> = HashMap::new();
        let mut middle = |a: u16, b: u16| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let sum: Point =
                    std::array::from_fn(|i| places[usize::from(a)][i] + places[usize::from(b)][i]);
                let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
                places.push(sum.map(|x| x / length));
                (places.len() - 1) as u16
            })
        };
        let cut = |[a, b, c]: [u16; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(cut).collect();
    }
    Closed { name: "ball", places, triangles, inside: vec![[0.0; 3], [0.3, 0.4, -0.5], [-0.7, 0.1, 0.0]] }
}

/// Makes a tube around a trefoil knot.
fn knot() -> Closed {
    const RINGS: u16 = 120;
    const SIDES: u16 = 12;
    let curve = |t: f64| [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()];
    let along =
        |t: f64| [t.cos() + 4.0 * (2.0 * t).cos(), 4.0 * (2.0 * t).sin() - t.sin(), -3.0 * (3.0 * t).cos()];
    let turn = |ring: u16| TAU * f64::from(ring) / f64::from(RINGS);
    let mut places = vec![];
    for ring in 0..RINGS {
        let (center, way) = (curve(turn(ring)), along(turn(ring)));
        let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, z] = way.map(|x| x / length);
        let across = (1.0 - z * z).sqrt();
        let out = [-z * x / across, -z * y / across, across];
        let side = [y * out[2] - z * out[1], z * out[0] - x * out[2], x * out[1] - y * out[0]];
        for corner in 0..SIDES {
            let (sine, cosine) = (TAU * f64::from(corner) / f64::from(SIDES)).sin_cos();
            places.push(std::array::from_fn(|i| center[i] + 0.5 * (out[i] * cosine + side[i] * sine)));
        }
    }
    let at = |ring: u16, corner: u16| ring % RINGS * SIDES + corner % SIDES;
    let square = |(ring, corner): (u16, u16)| {
        let [a, b, c, d] =
            [at(ring, corner), at(ring + 1, corner), at(ring + 1, corner + 1), at(ring, corner + 1)];
        [[a, c, b], [a, d, c]]
    };
    let squares = (0..RINGS).flat_map(|ring| (0..SIDES).map(move |corner| (ring, corner)));
    let triangles = squares.flat_map(square).collect();
    Closed { name: "knot", places, triangles, inside: (0..RINGS).map(|ring| curve(turn(ring))).collect() }
}

impl Closed {
    /// Answers the same body in another size, elsewhere.
    fn placed(mut self, name: &'static str, scale: f64, shift: f64) -> Self {
        let place = |point: &mut Point| *point = point.map(|x| x * scale + shift);
        self.places.iter_mut().chain(&mut self.inside).for_each(place);
        Self { name, ..self }
    }

    fn rounded<S: Rounded>(&self) -> Vec<Vec3<S>> {
        self.places.iter().map(|place| Vec3::from_array(place.map(S::round))).collect()
    }

    fn mesh<S: Rounded>(&self, accel: Accel) -> Shape<S> {
        let corners = |t: &[u16; 3]| t.map(|corner| self.places[usize::from(corner)]);
        let bounds: Vec<Bounds> = self.triangles.iter().map(|t| Bounds::around(corners(t))).collect();
        let places = Corners::Exact(self.rounded().leak());
        let triangles = self.triangles.clone().leak();
        let mesh = Mesh::new(triangles, places, Normals::Flat, accel.build(&bounds).leak());
        let mesh: &'static Mesh<S> = Box::leak(Box::new(mesh));
        assert_eq!(mesh.check(), Ok(()));
        Shape::Mesh(mesh)
    }

    /// Answers its triangles as shapes of their own, by turns flat and smooth.
    fn shapes<S: Rounded>(&self) -> Vec<Shape<S>> {
        let places = self.rounded();
        let shape = |(number, corners): (usize, &[u16; 3])| {
            let [a, b, c] = corners.map(|corner| places[usize::from(corner)]);
            if number % 2 == 0 {
                return Shape::Triangle(Triangle::new(a, b, c));
            }
            let vertices = [a, b, c].map(|place| Vertex::new(place, Vec3::ZERO, [S::ZERO; 2]));
            Shape::SmoothTriangle(SmoothTriangle::new(Box::leak(Box::new(vertices))))
        };
        self.triangles.iter().enumerate().map(shape).collect()
    }

    /// Counts rays from inside that meet nothing: of as many that go anywhere, and of as many that are aimed at
    /// corners and edges, to the last digit.
    fn misses<S: Rounded>(&self, shapes: &[Shape<S>], rays: usize) -> [usize; 2] {
        let places = self.rounded();
        let mut dice = Dice::of(5);
        let mut gets_through = |aimed: bool| {
            let from = Vec3::from_array(dice.pick(&self.inside).map(S::round));
            let [a, b, _] = dice.pick(&self.triangles).map(|corner| places[usize::from(corner)]);
            let any_share = dice.share();
            let share = dice.pick(&[0.0, 0.5, any_share]);
            let any = Vec3::from_array(std::array::from_fn(|_| S::round(2.0 * dice.share() - 1.0)));
            let at = a.add_scaled(b - a, S::round(share)) - from;
            let Some((direction, _)) = (if aimed { at } else { any }).normalize() else { return false };
            let ray = Ray::new(from, direction);
            !shapes.iter().any(|shape| shape.intersect(&ray, &Interval::AHEAD).is_some())
        };
        [false, true].map(|aimed| (0..rays).filter(|_| gets_through(aimed)).count())
    }
}

/// Asserts that of so many rays none gets through, whatever finds the triangles, and says how many do.
#[track_caller]
fn assert_tight<S: Rounded>(number: &str, body: &Closed, accels: &[Accel], rays: usize) {
    for accel in accels {
        let [any, aimed] = body.misses::<S>(&[body.mesh(*accel)], rays);
        let what = format!("{number}, {}, {accel:?}", body.name);
        println!("{what}: {any} of {rays} rays get through, and {aimed} of {rays} aimed at an edge");
        assert_eq!([any, aimed], [0, 0], "{what}");
    }
}

fn assert_all_tight<S: Rounded>(number: &str, rays: usize) {
    for body in [cube(), ball(4), knot()] {
        assert_tight::<S>(number, &body, &Accel::ALL, rays);
    }
    let elsewhere = [
        ball(4).placed("small ball", 0.1, 0.0),
        ball(4).placed("small ball far out", 0.1, 100.0),
        knot().placed("large knot", 10.0, 0.0),
        knot().placed("knot far out", 1.0, 500.0),
        cube().placed("huge cube", 500.0, 0.0),
    ];
    for body in elsewhere {
        assert_tight::<S>(number, &body, &[Accel::Bvh], rays);
    }
}

#[test]
fn no_ray_gets_through_a_closed_mesh_whatever_its_hierarchy() {
    assert_all_tight::<f32>("f32", 1000);
    assert_all_tight::<Fixed>("fixed", 1000);
}

#[test]
#[ignore = "a hundred thousand rays for each mesh and hierarchy take minutes"]
fn none_of_a_hundred_thousand_rays_gets_through_a_closed_mesh() {
    assert_all_tight::<f32>("f32", 100_000);
    assert_all_tight::<Fixed>("fixed", 100_000);
}

#[test]
fn no_ray_gets_between_triangles_that_share_corners_and_no_mesh() {
    for body in [cube(), ball(2), ball(2).placed("small ball far out", 0.1, 100.0)] {
        assert_eq!(body.misses::<f32>(&body.shapes(), 1000), [0, 0], "{}", body.name);
        assert_eq!(body.misses::<Fixed>(&body.shapes(), 1000), [0, 0], "{}", body.name);
    }
}
