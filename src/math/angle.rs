use super::{Scalar, Wide};

/// Answers tan(angle / 2) of an angle in degrees, 0 to below 180; up to 120 degrees within 2e-5 in fixed
/// point up to 120 degrees, 1e-6 of it in `f32` and 2e-15 of it in `f64`.
///
/// A camera takes its angle once a frame, so the formula may be slow: a quarter of the angle goes
/// through Lambert's continued fraction (Lambert 1761), then `tan 2a = 2 t / (1 - t t)`.
pub fn tan_half<S: Scalar>(degrees: S) -> S {
    let quarter = S::narrow(degrees.mul_wide(S::PI).scale(1, 4 * 180));
    double_angle(lambert(quarter))
}

/// Answers the cosine of an angle in degrees, 0 to 180, within 3e-16, at compile time for a constant.
///
/// By the power series `1 - x^2 / 2 (1 - x^2 / 12 (1 - ...))` (Newton 1669): up to a right angle its
/// eleventh term is the last that counts. For numbers of scenes, not for pixels.
pub const fn cosine(degrees: f64) -> f64 {
    if degrees > 90.0 {
        return -cosine_of_acute(180.0 - degrees);
    }
    cosine_of_acute(degrees)
}

const fn cosine_of_acute(degrees: f64) -> f64 {
    let x = degrees * (core::f64::consts::PI / 180.0);
    let (mut sum, mut n) = (1.0, 22);
    while n > 0 {
        sum = 1.0 - sum * (x * x / (n * (n - 1)) as f64);
        n -= 2;
    }
    sum
}

/// Answers tan a = a / (1 - a^2 / (3 - a^2 / (5 - ...))), for a below 0.8.
fn lambert<S: Scalar>(a: S) -> S {
    let square = a * a;
    let mut tail = S::from_i32(15);
    for odd in [13, 11, 9, 7, 5, 3, 1] {
        tail = S::from_i32(odd) - square.ratio(tail);
    }
    a.ratio(tail)
}

fn double_angle<S: Scalar>(tangent: S) -> S {
    (tangent + tangent).ratio(S::ONE - tangent * tangent)
}
