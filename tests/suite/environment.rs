//! Environments are seen where they belong, in every number.

use crate::support::picture::{ball, draw};
use scanray::math::Scalar;
use scanray::{Bitmap, Cube, Filter, Fixed, Material, Object, Rgb, Sky, Texels, Vec3};

/// Runs the same check in every number.
macro_rules! in_every_number {
    ($check:ident) => {
        $check::<f32>(|x| x as f32, f64::from);
        $check::<Fixed>(Fixed::new, Fixed::to_f64);
        $check::<f64>(|x| x, |x| x);
    };
}

/// Is a face of a cube whose texels show the direction they are seen in.
struct Compass {
    axis: usize,
    side: f64,
}

const TEXELS: u32 = 9;

impl Texels for Compass {
    fn size(&self) -> [u32; 2] {
        [TEXELS; 2]
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let share = |i: u32| 2.0 * f64::from(i) / f64::from(TEXELS - 1) - 1.0;
        let (a, b) = (self.side * share(column), self.side * share(TEXELS - 1 - row));
        let mut direction = [a, b, b];
        direction[self.axis] = self.side;
        match self.axis {
            0 => (direction[1], direction[2]) = (a, b),
            1 => (direction[0], direction[2]) = (a, b),
            _ => (direction[0], direction[1]) = (a, b),
        }
        let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
        direction.map(|c| ((c / length + 1.0) * 127.5).round() as u8)
    }
}

static COMPASS: [Compass; 6] = [
    Compass { axis: 0, side: -1.0 },
    Compass { axis: 0, side: 1.0 },
    Compass { axis: 1, side: -1.0 },
    Compass { axis: 1, side: 1.0 },
    Compass { axis: 2, side: -1.0 },
    Compass { axis: 2, side: 1.0 },
];
static FACES: [Bitmap; 6] = [
    Bitmap::new(&COMPASS[0]),
    Bitmap::new(&COMPASS[1]),
    Bitmap::new(&COMPASS[2]),
    Bitmap::new(&COMPASS[3]),
    Bitmap::new(&COMPASS[4]),
    Bitmap::new(&COMPASS[5]),
];

#[test]
fn each_face_of_an_environment_is_seen_where_it_belongs_and_the_right_way_round() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let light = |share: f64| {
            let x = ((share + 1.0) / 2.0 + 0.055) / 1.055;
            if share < -0.92 { (share + 1.0) / 2.0 / 12.92 } else { x.powf(2.4) }
        };
        for filter in [Filter::Nearest, Filter::Bilinear] {
            let sky = Cube::new(&FACES).with_filter(filter);
            let allowed = if filter == Filter::Nearest { 0.15 } else { 0.03 };
            for i in 0..500 {
                let at = |step: f64| (f64::from(i) * step).fract() * 2.0 - 1.0;
                let Some((direction, _)) =
                    Vec3::new(make(at(0.618)), make(at(0.755)), make(at(0.324))).normalize()
                else {
                    continue;
                };
                let Rgb { r, g, b } = sky.color(direction);
                for (found, share) in [r, g, b].map(read).into_iter().zip(direction.to_array().map(read)) {
                    assert!((found - light(share)).abs() < allowed, "{found} toward {direction:?}");
                }
            }
        }
    }
    in_every_number!(check);
}

#[test]
fn an_environment_has_no_seams_between_its_faces() {
    fn check<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let sky = Cube::new(&FACES);
        let toward =
            |c: [f64; 3]| sky.color(Vec3::from_array(c.map(make)).normalize().expect("a direction").0);
        for edge in 0..12_usize {
            let axes = [[0, 1, 2], [0, 2, 1], [1, 2, 0]][edge % 3];
            let sides = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]][edge / 3];
            for along in -9..=9 {
                let beside = |first: f64, second: f64| {
                    let mut direction = [0.0; 3];
                    direction[axes[0]] = sides[0] * first;
                    direction[axes[1]] = sides[1] * second;
                    direction[axes[2]] = f64::from(along) * 0.11;
                    toward(direction)
                };
                let (here, there) = (beside(1.0, 0.999_9), beside(0.999_9, 1.0));
                let apart = [here.r - there.r, here.g - there.g, here.b - there.b].map(read);
                assert!(apart.iter().all(|apart| apart.abs() < 2e-3), "edge {edge} at {along}: {apart:?}");
            }
        }
    }
    in_every_number!(check);
}

#[test]
fn an_environment_is_seen_behind_things_and_in_mirrors() {
    let materials = [Material::matte(Rgb::BLACK).with_mirror(1.0)];
    let sky = Sky::Cube(Cube::new(&FACES));
    let picture = draw(&[Object::new(ball(1.0), 0)], &materials, sky);
    // Behind the ball lies -z, and in its middle +z is seen: blue is light of z.
    let (corner, middle) = (picture[0], picture[22 * 60 + 30]);
    assert!(corner.b < 0.05 && middle.b > 0.8, "{corner:?}, {middle:?}");
}
