//! What makes the same check run in every number.

use scanray::hit::Crossing;
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{Intersect, Vec3};

/// Runs the functions of the same names in the module `checks` in every number.
macro_rules! in_every_number {
    ($($name:ident),+ $(,)?) => {
        $(#[test]
        fn $name() {
            checks::$name(|x| x as f32, f64::from);
            checks::$name(scanray::Fixed::new, scanray::Fixed::to_f64);
            checks::$name(|x| x, |x| x);
        })+
    };
}

/// Makes vectors and rays of plain numbers, and plain numbers of answers.
pub struct Kit<S>(pub fn(f64) -> S, pub fn(S) -> f64);

impl<S: Scalar> Kit<S> {
    pub fn v(&self, x: f64, y: f64, z: f64) -> Vec3<S> {
        Vec3::new((self.0)(x), (self.0)(y), (self.0)(z))
    }

    pub fn at(&self, [x, y, z]: [f64; 3]) -> Vec3<S> {
        self.v(x, y, z)
    }

    pub fn plain(&self, v: Vec3<S>) -> [f64; 3] {
        v.to_array().map(self.1)
    }

    pub fn ray(&self, origin: [f64; 3], toward: [f64; 3]) -> Ray<S> {
        let (direction, _) = self.at(toward).normalize().expect("a direction");
        Ray::new(self.at(origin), direction)
    }

    /// Makes the ray from one point through another.
    pub fn ray_at(&self, origin: [f64; 3], target: [f64; 3]) -> Ray<S> {
        let (direction, _) = (self.at(target) - self.at(origin)).normalize().expect("two points");
        Ray::new(self.at(origin), direction)
    }

    pub fn t(&self, hit: Option<Crossing<S>>) -> Option<f64> {
        hit.map(|hit| (self.1)(hit.t))
    }

    /// Answers the distance of the nearest crossing ahead.
    pub fn seen(&self, shape: &impl Intersect<S>, ray: &Ray<S>) -> Option<f64> {
        self.t(shape.intersect(ray, &Interval::AHEAD))
    }

    #[track_caller]
    pub fn assert_near(&self, value: Option<f64>, expected: f64) {
        let value = value.expect("a hit");
        assert!((value - expected).abs() < 1e-4, "{value} instead of {expected}");
    }

    #[track_caller]
    pub fn assert_vector(&self, v: Vec3<S>, expected: [f64; 3]) {
        let near = self.plain(v).into_iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
        assert!(near, "{v:?} instead of {expected:?}");
    }
}

pub fn ahead<S: Scalar>() -> Interval<S> {
    Interval::AHEAD
}

/// Answers numbers from -1/2 to 1/2, scattered evenly: the `i`th of one of six sequences.
pub fn scattered(i: u32, sequence: usize) -> f64 {
    let steps = [0.618_034, 0.754_878, 0.324_718, 0.541_196, 0.217_157, 0.879_385];
    (f64::from(i) * steps[sequence]).fract() - 0.5
}

/// Answers a point of a cube of side 2 in the origin, from the first or the last three sequences.
pub fn scattered_point(i: u32, last: bool) -> [f64; 3] {
    let first = if last { 3 } else { 0 };
    [0, 1, 2].map(|axis| 2.0 * scattered(i, first + axis))
}
