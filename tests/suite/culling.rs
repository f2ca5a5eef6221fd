//! Spans and what is remembered of shadows leave out only what no ray meets: the picture is that of
//! brute force, bit for bit, in every number.

use crate::support::film;
use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use scanray::hit::{Crossing, Surface};
use scanray::ray::{Interval, Ray};
use scanray::render::Quality;
use scanray::trace::{Candidates, Packet, Pending, Tracer};
use scanray::{
    AtEdges, Camera, Cone, Cuboid, Fault, FillRule, Fixed, Intersect, Jittered, Light, Material, Object,
    Plane, Polygon, Projection, Renderer, Rgb, Scalar, Scene, Settings, Shape, Sky, SmoothTriangle, Sphere,
    Triangle, Uniform, Vec3, Vertex, Workspace,
};

const COLUMNS: u32 = 40;
const ROWS: u32 = 14;
const DEPTH: u8 = 2;

type Point = [f64; 3];

#[derive(Clone, Debug)]
enum Plain {
    Ball(Point, f64),
    Box(Point, Point),
    Corner(Point, Point, Point),
    Floor(Point, Point),
    Outline { center: Point, edges: [Point; 2], places: Vec<[f64; 2]>, rule: FillRule },
    Cone { ends: [Point; 2], radii: [f64; 2], capped: bool },
    Smooth([Point; 3]),
}

fn point(size: f64) -> impl Strategy<Value = Point> {
    [-size..size, -size..size, -size..size]
}

fn outline() -> impl Strategy<Value = Plain> {
    let rule = prop_oneof![Just(FillRule::OddEven), Just(FillRule::Winding)];
    let places = prop::collection::vec([-2.0..2.0, -2.0..2.0], 3..9);
    (point(8.0), [point(2.0), point(2.0)], places, rule)
        .prop_map(|(center, edges, places, rule)| Plain::Outline { center, edges, places, rule })
}

fn cone() -> impl Strategy<Value = Plain> {
    (point(8.0), point(4.0), [0.0..2.5, 0.0..2.5], prop::bool::ANY).prop_map(|(base, way, radii, capped)| {
        let apex = [0, 1, 2].map(|axis| base[axis] + way[axis]);
        Plain::Cone { ends: [base, apex], radii, capped }
    })
}

fn shape() -> impl Strategy<Value = Plain> {
    prop_oneof![
        3 => (point(8.0), 0.05..5.0).prop_map(|(c, r)| Plain::Ball(c, r)),
        1 => (point(8.0), point(3.0)).prop_map(|(a, e)| Plain::Box(a, e.map(|e| e.abs() + 0.05))),
        1 => (point(8.0), point(5.0), point(5.0)).prop_map(|(a, e, f)| Plain::Corner(a, e, f)),
        1 => outline(),
        1 => cone(),
        1 => (point(8.0), point(5.0), point(5.0)).prop_map(|(a, e, f)| Plain::Smooth([a, e, f])),
        1 => (point(8.0), point(1.0)).prop_map(|(p, n)| Plain::Floor(p, n)),
        // A floor below most things, as scenes have it: shadows fall on it in long outlines.
        1 => (-8.0..0.0).prop_map(|y| Plain::Floor([0.0, y, 0.0], [0.0, 1.0, 0.0])),
    ]
}

#[derive(Clone, Debug)]
struct View {
    eye: Point,
    center: Point,
    up: Point,
    projection: [f64; 5],
    near: f64,
    lights: [Point; 2],
}

fn view() -> impl Strategy<Value = View> {
    let projection = [0.0..3.0, 5.0..150.0, -3.0..3.0, 0.1..3.0, 0.1..3.0];
    // Half of the eyes are so near that shapes lie around and behind them.
    let eye = prop_oneof![point(3.0), point(12.0)];
    let near = prop_oneof![Just(0.0), 0.1..3.0];
    (eye, point(6.0), point(1.0), projection, near, [point(12.0), point(12.0)]).prop_map(
        |(eye, center, up, projection, near, lights)| View { eye, center, up, projection, near, lights },
    )
}

fn vector<S: Scalar>(number: fn(f64) -> S, [x, y, z]: Point) -> Vec3<S> {
    Vec3::new(number(x), number(y), number(z))
}

fn cross([a, b, c]: Point, [x, y, z]: Point) -> Point {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Answers the corners of a polygon by two edges of its plane.
fn corners<S: Scalar>(
    number: fn(f64) -> S,
    center: Point,
    [e, f]: [Point; 2],
    places: &[[f64; 2]],
) -> Vec<Vec3<S>> {
    let corner = |[p, q]: &[f64; 2]| vector(number, [0, 1, 2].map(|i| center[i] + p * e[i] + q * f[i]));
    places.iter().map(corner).collect()
}

/// Makes a triangle whose normals lean outward, away from its middle.
fn smooth<S: Scalar>(number: fn(f64) -> S, [a, e, f]: [Point; 3]) -> SmoothTriangle<S> {
    let normal = cross(e, f);
    let vertex = |[p, q]: [f64; 2]| {
        let point = [0, 1, 2].map(|i| a[i] + p * e[i] + q * f[i]);
        let lean = [0, 1, 2].map(|i| normal[i] + (p - 0.3) * e[i] + (q - 0.3) * f[i]);
        let length = lean.iter().map(|c| c * c).sum::<f64>().sqrt();
        Vertex::new(vector(number, point), vector(number, lean.map(|c| c / length)), [number(0.0); 2])
    };
    let vertices = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(vertex);
    SmoothTriangle::new(Box::leak(Box::new(vertices)))
}

fn build<S: Scalar>(number: fn(f64) -> S, shape: &Plain) -> Shape<S> {
    let v = |p: &Point| vector(number, *p);
    match shape {
        Plain::Ball(center, radius) => Shape::Sphere(Sphere::new(v(center), number(*radius))),
        Plain::Box(low, extent) => Shape::Cuboid(Cuboid::new(v(low), v(low) + v(extent))),
        Plain::Corner(a, e, f) => Shape::Triangle(Triangle::new(v(a), v(a) + v(e), v(a) + v(f))),
        Plain::Outline { center, edges, places, rule } => {
            let normal = vector(number, cross(edges[0], edges[1]));
            // Never freed: a test is soon over.
            let vertices = corners(number, *center, *edges, places).leak();
            Shape::Polygon(Polygon::new(vertices, normal, *rule))
        }
        Plain::Cone { ends: [base, apex], radii: [wide, narrow], capped } => {
            let cone = Cone::new(v(base), number(*wide), v(apex), number(*narrow));
            Shape::Cone(if *capped { cone } else { cone.open() })
        }
        Plain::Smooth(corners) => Shape::SmoothTriangle(smooth(number, *corners)),
        Plain::Floor(point, normal) => Shape::Plane(Plane::new(v(point), v(normal))),
    }
}

fn camera<S: Scalar>(number: fn(f64) -> S, view: &View) -> Camera<S> {
    let [kind, fovy, left, width, height] = view.projection;
    let n = number;
    let projection = if kind < 1.0 {
        Projection::Perspective { fovy: n(fovy) }
    } else if kind < 2.0 {
        Projection::Orthographic { height: n(3.0 * height) }
    } else {
        // Every other off-centre window is mirrored.
        let (left, right) = if kind < 2.5 { (left, left + width) } else { (left + width, left) };
        Projection::Frustum { left: n(left), right: n(right), bottom: n(-0.3 * height), top: n(0.7 * height) }
    };
    let points = [view.eye, view.center, view.up].map(|p| vector(number, p));
    Camera::new(points, projection, [n(if kind < 2.0 { view.near } else { view.near.max(0.5) }), n(100.0)])
}

/// Is what a scene of some shapes is made of.
type Parts<S> = (Vec<Object<S>>, Vec<Material<S>>, [Light<S>; 2]);

fn parts<S: Scalar>(number: fn(f64) -> S, shapes: &[Plain], view: &View) -> Parts<S> {
    let tint = |i: usize| number((i % 7 + 1) as f64 / 8.0);
    let materials: Vec<Material<S>> = (0..shapes.len())
        .map(|i| {
            let matte = Material::matte(Rgb::new(tint(i), tint(i + 3), tint(i + 5)));
            matte.with_mirror(number(0.5)).with_specular(Rgb::gray(number(0.5)), 9)
        })
        .collect();
    let objects: Vec<Object<S>> =
        (0..).zip(shapes).map(|(i, shape)| Object::new(build(number, shape), i)).collect();
    let [lamp, sun] = view.lights.map(|p| vector(number, p));
    let lights =
        [Light::point(lamp, Rgb::gray(number(0.7))), Light::directional(sun, Rgb::gray(number(0.4)))];
    (objects, materials, lights)
}

/// Draws with and without culling, and answers what differs first.
fn differs<S: Scalar>(number: fn(f64) -> S, shapes: &[Plain], view: &View) -> Option<String> {
    let (objects, materials, lights) = parts(number, shapes, view);
    let scene = Scene::new(&objects, &materials, &lights).with_sky(Sky::Solid(Rgb::gray(number(0.2))));
    let camera = camera(number, view);
    let (size, settings) = (Size::new(COLUMNS, ROWS), Settings::new().with_depth(DEPTH));
    let mut workspace = Workspace::<S, [u8; 2], 0, 2>::new();
    // A scene that is refused has no picture to compare.
    let mut renderer = Renderer::new(&scene, &camera, size, settings, &mut workspace).ok()?;
    let frame = camera.frame(COLUMNS, ROWS).ok()?;
    let mut pending = [Pending::NONE; DEPTH as usize];
    let mut brute = Tracer::new(&scene, &mut pending);
    for y in 0..ROWS {
        let mut culled = Vec::new();
        renderer.trace_row(y, 0..COLUMNS, &mut (), |_, light| culled.push(light)).ok()?;
        for ((x, primary), light) in (0..COLUMNS).zip(frame.row(y, 0)).zip(culled) {
            let ray = std::iter::once((primary.ray, primary.interval));
            let mut packet = Packet::new();
            let whole = brute.radiance(&mut packet, ray, Candidates::all(&scene), &mut ())[0];
            if light != whole {
                return Some(format!("pixel {x}, {y}: {light:?}, by brute force {whole:?}"));
            }
        }
    }
    None
}

/// Is a shape of which nobody knows where it is: every ray asks it.
struct Boundless<S: 'static>(Shape<S>);

impl<S: Scalar> Intersect<S> for Boundless<S> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.0.intersect(ray, interval)
    }

    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.0.intersect_leaving(ray, interval)
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        self.0.surface(ray, crossing)
    }

    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        self.0.occludes(ray, interval)
    }

    fn is_convex(&self) -> bool {
        self.0.is_convex()
    }

    fn check(&self) -> Result<(), Fault> {
        self.0.check()
    }
}

/// Draws with several rays a pixel, with and without culling, and answers the first pixel that differs.
fn samples_differ<S: Scalar>(
    number: fn(f64) -> S,
    shapes: &[Plain],
    view: &View,
    quality: impl Quality,
) -> Option<String> {
    let (objects, materials, lights) = parts(number, shapes, view);
    let boundless: Vec<_> =
        objects.iter().map(|o| Object::new(Shape::Custom(Boundless(o.shape)), o.material)).collect();
    let camera = camera(number, view);
    camera.frame(COLUMNS, ROWS).ok()?;
    let settings = Settings::new().with_depth(0).with_quality(quality);
    let scene = Scene::new(&objects, &materials, &lights);
    scene.check().ok()?;
    let culled = film(&scene, &camera, [COLUMNS, ROWS], settings, &mut ());
    let whole = Scene::new(&boundless, &materials, &lights);
    let whole = film(&whole, &camera, [COLUMNS, ROWS], settings, &mut ());
    let place = culled.iter().zip(&whole).position(|(a, b)| a != b)?;
    Some(format!("pixel {place}: {:?}, unculled {:?}", culled[place], whole[place]))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn culling_never_changes_a_sampled_picture_in_f32(shapes in prop::collection::vec(shape(), 1..40), view in view()) {
        prop_assert_eq!(samples_differ(|x| x as f32, &shapes, &view, Jittered(2)), None);
        prop_assert_eq!(samples_differ(|x| x as f32, &shapes, &view, AtEdges(Uniform(2))), None);
    }

    #[test]
    fn culling_never_changes_a_sampled_picture_in_fixed_point(shapes in prop::collection::vec(shape(), 1..40), view in view()) {
        prop_assert_eq!(samples_differ(Fixed::new, &shapes, &view, Uniform(3)), None);
        prop_assert_eq!(samples_differ(Fixed::new, &shapes, &view, AtEdges(Jittered(2))), None);
    }

    #[test]
    fn culling_never_changes_a_lit_picture_in_f32(shapes in prop::collection::vec(shape(), 1..40), view in view()) {
        prop_assert_eq!(differs(|x| x as f32, &shapes, &view), None);
    }

    #[test]
    fn culling_never_changes_a_lit_picture_in_fixed_point(shapes in prop::collection::vec(shape(), 1..40), view in view()) {
        prop_assert_eq!(differs(Fixed::new, &shapes, &view), None);
    }
}

#[test]
fn more_balls_than_are_noted_or_listed_still_cast_all_their_shadows() {
    let balls = (0..150).map(|i| {
        let (column, row) = (f64::from(i % 15), f64::from(i / 15));
        Plain::Ball([column - 7.0, 1.0 + 0.1 * row, -row], 0.35)
    });
    let shapes: Vec<Plain> = std::iter::once(Plain::Floor([0.0; 3], [0.0, 1.0, 0.0])).chain(balls).collect();
    let view = View {
        eye: [0.0, 3.0, 6.0],
        center: [0.0, 0.5, -3.0],
        up: [0.0, 1.0, 0.0],
        projection: [0.0, 60.0, 0.0, 1.0, 1.0],
        near: 0.0,
        lights: [[3.0, 9.0, 2.0], [-1.0, 1.0, 0.5]],
    };
    assert_eq!(differs(|x| x as f32, &shapes, &view), None);
    assert_eq!(differs(Fixed::new, &shapes, &view), None);
}
