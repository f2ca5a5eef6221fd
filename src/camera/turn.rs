use super::Camera;
use crate::math::{Scalar, Wide, tan_half};

impl<S: Scalar> Camera<S> {
    /// Answers this camera carried around its center by `step` of the `steps` equal steps of a whole turn.
    ///
    /// The eye goes about the axis `up` through `center`, counter-clockwise as seen from the tip of `up`,
    /// so to the camera's own right; all else stays. The answer depends on `step` modulo `steps` alone, and for 0 it is this very camera: a turn
    /// of `steps` pictures ends on the bits it began with, however often it goes round. 0 steps count as 1.
    ///
    /// With r for 1 + the distance between eye and center, the eye is where it should be within r * 5e-6
    /// in fixed point, r * 3e-7 in `f32` and r * 2e-15 in `f64`. Only `+ - * /` are used: the bits are
    /// the same on every chip.
    ///
    /// ```
    /// use scanray::{Camera, Vec3};
    /// let front = Camera::perspective(
    ///     Vec3::new(0.0, 1.0, 5.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.0), 40.0);
    /// assert!((front.turned(1, 4).eye.x - 5.0_f32).abs() < 1e-5);
    /// assert_eq!(front.turned(4, 4), front);
    /// ```
    pub fn turned(&self, step: u32, steps: u16) -> Self {
        let steps = i32::from(steps.max(1));
        let step = (step % steps.unsigned_abs()) as i32;
        let Some((axis, _)) = self.up.normalize().filter(|_| step > 0) else { return *self };
        let [cosine, sine] = circle(step, steps);
        // Rodrigues' formula: what lies along the axis stays, what stands across it turns.
        let arm = self.eye - self.center;
        let along = axis * axis.dot(arm);
        let across = arm - along;
        let turned = across.mul_wide(cosine) + axis.cross(across).mul_wide(sine);
        Self { eye: self.center + along + turned.narrow(), ..*self }
    }
}

/// Answers cosine and sine of `step` of `steps` steps around the unit circle.
///
/// Whole numbers fold the circle to its first eighth, so that opposite steps are opposite to the bit.
fn circle<S: Scalar>(step: i32, steps: i32) -> [S; 2] {
    let (quarter, rest) = (4 * step / steps, 4 * step % steps);
    let [cosine, sine] = if 2 * rest <= steps {
        eighth(rest, steps)
    } else {
        let [cosine, sine] = eighth(steps - rest, steps);
        [sine, cosine]
    };
    match quarter {
        0 => [cosine, sine],
        1 => [-sine, cosine],
        2 => [-cosine, -sine],
        _ => [sine, -cosine],
    }
}

/// Answers cosine and sine of `rest / steps` of a right angle, at most half of it.
///
/// With t = tan(a / 2) they are (1 - t t) / (1 + t t) and 2 t / (1 + t t): a point of the circle for any
/// t, so that an error of t is one along the circle and the distance stays.
fn eighth<S: Scalar>(rest: i32, steps: i32) -> [S; 2] {
    let degrees = S::narrow(S::from_i32(90).mul_wide(S::ONE).scale(rest, steps));
    let tangent = tan_half(degrees);
    let (one, square) = (S::ONE.mul_wide(S::ONE), tangent.mul_wide(tangent));
    [one - square, (tangent + tangent).mul_wide(S::ONE)].map(|part| S::div(part, one + square))
}
