//! Numbers that every number type of the core can hold exactly.

use proptest::array::uniform3;
use proptest::prelude::*;
use scanray::{Rgb, Scalar, Vec3};

pub type Triple = [f64; 3];

/// Answers multiples of 1/64, which are the same in `f32` and in fixed point.
pub fn number(low: f64, high: f64) -> impl Strategy<Value = f64> + Clone {
    let steps = |value: f64| (value * 64.0) as i32;
    (steps(low)..=steps(high)).prop_map(|n| f64::from(n) / 64.0)
}

pub fn triple(low: f64, high: f64) -> impl Strategy<Value = Triple> + Clone {
    uniform3(number(low, high))
}

pub fn sum(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|axis| a[axis] + b[axis])
}

pub fn difference(a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub fn outer([a, b, c]: Triple, [x, y, z]: Triple) -> Triple {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub fn unit(v: Triple) -> Triple {
    v.map(|component| component / inner(v, v).sqrt())
}

pub fn inner(a: Triple, b: Triple) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

/// Makes a recipe's things of a number type.
pub struct Maker<S>(pub fn(f64) -> S);

impl<S: Scalar> Maker<S> {
    pub fn vector(&self, t: Triple) -> Vec3<S> {
        Vec3::from_array(t.map(self.0))
    }

    pub fn color(&self, t: Triple) -> Rgb<S> {
        let [r, g, b] = t.map(self.0);
        Rgb::new(r, g, b)
    }
}
