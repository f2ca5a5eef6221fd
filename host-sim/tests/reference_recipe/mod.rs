//! Recipes of scenes: plain numbers that every number type of the core can hold exactly.

use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;
use scanray::gallery::View;
use scanray::{
    Camera, Checker, Cone, Cuboid, FillRule, Light, Material, Object, Plane, Polygon, Projection, Rgb,
    Scalar, Scene, Settings, Shape, Sky, SmoothTriangle, Sphere, Texture, Triangle, Vec3, Vertex,
};

type Triple = [f64; 3];

#[derive(Clone, Debug)]
enum Form {
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
struct Outline {
    center: Triple,
    edges: [Triple; 2],
    places: Vec<[f64; 2]>,
    rule: FillRule,
}

#[derive(Clone, Debug)]
struct Finish {
    colors: [Triple; 2],
    tiles: Option<f64>,
    specular: f64,
    shininess: u16,
    mirror: f64,
    flat: bool,
}

#[derive(Clone, Debug)]
enum Window {
    Perspective(f64),
    Frustum([f64; 4]),
    Orthographic(f64),
}

#[derive(Clone, Debug)]
struct Lens {
    points: [Triple; 3],
    window: Window,
    clip: [f64; 2],
}

/// Is a scene before it has a number type.
#[derive(Clone, Debug)]
pub struct Recipe {
    objects: Vec<(Form, Finish)>,
    lights: Vec<(bool, Triple, Triple)>,
    sky: [Triple; 2],
    ambient: f64,
    lens: Lens,
    depth: u8,
}

/// Answers multiples of 1/64, which are the same in `f32` and in fixed point.
fn number(low: f64, high: f64) -> impl Strategy<Value = f64> + Clone {
    let steps = |value: f64| (value * 64.0) as i32;
    (steps(low)..=steps(high)).prop_map(|n| f64::from(n) / 64.0)
}

fn triple(low: f64, high: f64) -> impl Strategy<Value = Triple> + Clone {
    uniform3(number(low, high))
}

fn sum(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|axis| a[axis] + b[axis])
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

fn form() -> impl Strategy<Value = Form> {
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

fn finish() -> impl Strategy<Value = Finish> {
    let tiles = prop_oneof![2 => Just(None), 1 => number(0.5, 3.0).prop_map(Some)];
    let colors = [triple(0.0, 1.0), triple(0.0, 1.0)];
    (colors, tiles, number(0.0, 1.0), 1_u16..80, number(-0.5, 0.9), prop::bool::weighted(0.1)).prop_map(
        |(colors, tiles, specular, shininess, mirror, flat)| {
            // Below 0 is none: a third of all.
            Finish { colors, tiles, specular, shininess, mirror: mirror.max(0.0), flat }
        },
    )
}

fn window() -> impl Strategy<Value = Window> {
    let edge = || number(0.25, 1.0);
    let edges = [edge(), edge(), edge(), edge()].prop_map(|[l, r, b, t]| [-l, r, -b, t + 0.5]);
    prop_oneof![
        number(20.0, 90.0).prop_map(Window::Perspective),
        edges.prop_map(Window::Frustum),
        number(3.0, 9.0).prop_map(Window::Orthographic),
    ]
}

fn lens() -> impl Strategy<Value = Lens> {
    // Somewhere around the things, not among them, whichever way up.
    let eye = (triple(-2.0, 2.0), 0..3_usize, prop::bool::ANY).prop_map(|(mut eye, axis, other)| {
        eye[axis] += if other { 7.0 } else { -7.0 };
        eye
    });
    let points = (eye, triple(-1.0, 1.0), triple(-1.0, 1.0)).prop_map(|(eye, center, up)| [eye, center, up]);
    let clip = (number(0.5, 6.0), number(8.0, 100.0)).prop_map(|(near, far)| [near, far]);
    (points, window(), clip).prop_map(|(points, window, clip)| Lens { points, window, clip })
}

/// Answers any scene of a few things.
pub fn recipe() -> impl Strategy<Value = Recipe> {
    let light = (prop::bool::ANY, triple(-8.0, 8.0), triple(0.0, 1.0));
    let sky = [triple(0.0, 1.0), triple(0.0, 1.0)];
    let things = (vec((form(), finish()), 1..7), vec(light, 0..4));
    (things, sky, number(0.0, 0.5), lens(), 0_u8..4).prop_map(
        |((objects, lights), sky, ambient, lens, depth)| Recipe {
            objects,
            lights,
            sky,
            ambient,
            lens,
            depth,
        },
    )
}

/// Makes a recipe's things of a number type.
struct Maker<S>(fn(f64) -> S);

impl<S: Scalar> Maker<S> {
    fn vector(&self, t: Triple) -> Vec3<S> {
        Vec3::from_array(t.map(self.0))
    }

    fn color(&self, t: Triple) -> Rgb<S> {
        let [r, g, b] = t.map(self.0);
        Rgb::new(r, g, b)
    }

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

    fn shape(&self, form: &Form) -> Shape<S> {
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

    fn material(&self, finish: &Finish) -> Material<S> {
        let [even, odd] = finish.colors.map(|color| self.color(color));
        let texture = match finish.tiles {
            Some(tiles) => Texture::Checker(Checker::new(even, odd, self.0(tiles))),
            None => Texture::Solid(even),
        };
        let mut material = Material::textured(texture)
            .with_specular(Rgb::gray(self.0(finish.specular)), finish.shininess)
            .with_mirror(self.0(finish.mirror));
        if finish.flat {
            material.model = scanray::Model::Flat;
        }
        material
    }

    fn light(&self, (distant, place, color): &(bool, Triple, Triple)) -> Light<S> {
        let (place, color) = (self.vector(*place), self.color(*color));
        if *distant { Light::directional(place, color) } else { Light::point(place, color) }
    }

    fn camera(&self, lens: &Lens) -> Camera<S> {
        let projection = match lens.window {
            Window::Perspective(fovy) => Projection::Perspective { fovy: self.0(fovy) },
            Window::Frustum(edges) => {
                let [left, right, bottom, top] = edges.map(self.0);
                Projection::Frustum { left, right, bottom, top }
            }
            Window::Orthographic(height) => Projection::Orthographic { height: self.0(height) },
        };
        Camera::new(lens.points.map(|p| self.vector(p)), projection, lens.clip.map(self.0))
    }
}

fn difference(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn outer([a, b, c]: Triple, [x, y, z]: Triple) -> Triple {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(v: Triple) -> Triple {
    v.map(|component| component / inner(v, v).sqrt())
}

fn inner(a: Triple, b: Triple) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

/// Answers how steeply a direction meets a plane: the sine of the angle between them.
fn steepness(direction: Triple, normal: Triple) -> f64 {
    inner(direction, normal).abs() / (inner(direction, direction) * inner(normal, normal)).sqrt()
}

impl Recipe {
    /// Tells whether light from infinity runs almost along an endless plane.
    ///
    /// It would then be the plane's shadow that falls from thousands of units away, beyond the end
    /// of a fixed-point number.
    pub fn light_grazes_a_plane(&self) -> bool {
        let planes = self.objects.iter().filter_map(|(form, _)| match form {
            Form::Plane(_, normal) => Some(*normal),
            _ => None,
        });
        let distant = || self.lights.iter().filter(|(distant, ..)| *distant).map(|(_, toward, _)| *toward);
        planes.into_iter().any(|normal| distant().any(|toward| steepness(toward, normal) < 1.0 / 32.0))
    }

    /// Makes the scene in a number type. Its lists are never freed: a test is soon over.
    pub fn view<S: Scalar>(&self, number: fn(f64) -> S) -> View<S> {
        let maker = Maker(number);
        let object = |(i, (form, _)): (usize, &(Form, Finish))| Object::new(maker.shape(form), i as u16);
        let objects: Vec<_> = self.objects.iter().enumerate().map(object).collect();
        let materials: Vec<_> = self.objects.iter().map(|(_, finish)| maker.material(finish)).collect();
        let lights: Vec<_> = self.lights.iter().map(|light| maker.light(light)).collect();
        let [nadir, zenith] = self.sky.map(|color| maker.color(color));
        let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
        View {
            name: "random",
            about: "a scene nobody chose",
            scene: Scene::new(objects.leak(), materials.leak(), lights.leak())
                .with_ambient(Rgb::gray(number(self.ambient)))
                .with_sky(Sky::Gradient { up, nadir, zenith }),
            camera: maker.camera(&self.lens),
            settings: Settings::new().with_depth(self.depth),
            size: [0; 2],
        }
    }
}
