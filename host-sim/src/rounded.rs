//! Numbers that values of `f64` are rounded to.

use scanray::{Camera, Fixed, Projection, Scalar, Vec3};

/// Is a number that a value can be rounded to, as the gallery's constants are.
pub trait Rounded: Scalar {
    /// Rounds a value to this number.
    fn round(value: f64) -> Self;
}

impl Rounded for f32 {
    fn round(value: f64) -> Self {
        value as f32
    }
}

impl Rounded for Fixed {
    fn round(value: f64) -> Self {
        Self::new(value)
    }
}

impl Rounded for f64 {
    fn round(value: f64) -> Self {
        value
    }
}

/// Rounds a camera to a number: a camera of the gallery to the very one the gallery has there.
pub fn camera_in<S: Rounded>(camera: &Camera<f64>) -> Camera<S> {
    let point = |p: Vec3<f64>| Vec3::from_array(p.to_array().map(S::round));
    let far = if camera.far == f64::FAR { S::FAR } else { S::round(camera.far) };
    let projection = match camera.projection {
        Projection::Frustum { left, right, bottom, top } => {
            let [left, right, bottom, top] = [left, right, bottom, top].map(S::round);
            Projection::Frustum { left, right, bottom, top }
        }
        Projection::Orthographic { height } => Projection::Orthographic { height: S::round(height) },
        Projection::Perspective { fovy } => Projection::Perspective { fovy: S::round(fovy) },
        // The enum is open to the core's future; a projection unknown here is refused by the core
        // because its angle is 0.
        _ => Projection::Perspective { fovy: S::ZERO },
    };
    let points = [point(camera.eye), point(camera.center), point(camera.up)];
    Camera::new(points, projection, [S::round(camera.near), far])
}
