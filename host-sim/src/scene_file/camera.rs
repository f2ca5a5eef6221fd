//! The camera of a scene file.
//!
//! To add a projection: a variant, and an arm in each of its two functions.

use super::value::{Point, UP, unless};
use crate::rounded::{Rounded, camera_in};
use scanray::{Scalar, Vec3};
use serde::{Deserialize, Serialize};

/// Is where the picture is taken from and how; its fields are those of the core's camera.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Centre of projection.
    pub eye: Point,
    /// Point that is looked at.
    pub center: Point,
    /// Direction that is up in the picture; by default along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<Point>,
    /// How it projects.
    pub projection: Projection,
    /// Depth before which nothing is seen; by default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub near: Option<f64>,
    /// Depth beyond which nothing is seen; by default as far as the number goes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub far: Option<f64>,
}

/// Names how a camera projects; its fields are those of the core's projection of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Projection {
    /// Pinhole with a window in the middle.
    Perspective {
        /// Angle between the lower and the upper edge, in degrees.
        fovy: f64,
    },
    /// Pinhole with a window anywhere on the near plane.
    Frustum {
        /// Left edge on the near plane.
        left: f64,
        /// Right edge on the near plane.
        right: f64,
        /// Lower edge on the near plane.
        bottom: f64,
        /// Upper edge on the near plane.
        top: f64,
    },
    /// Parallel rays from a window around the eye.
    Orthographic {
        /// Height of the window.
        height: f64,
    },
}

impl Projection {
    fn in_core(&self) -> scanray::Projection<f64> {
        match *self {
            Self::Perspective { fovy } => scanray::Projection::Perspective { fovy },
            Self::Frustum { left, right, bottom, top } => {
                scanray::Projection::Frustum { left, right, bottom, top }
            }
            Self::Orthographic { height } => scanray::Projection::Orthographic { height },
        }
    }

    fn of(projection: scanray::Projection<f64>) -> Option<Self> {
        Some(match projection {
            scanray::Projection::Perspective { fovy } => Self::Perspective { fovy },
            scanray::Projection::Frustum { left, right, bottom, top } => {
                Self::Frustum { left, right, bottom, top }
            }
            scanray::Projection::Orthographic { height } => Self::Orthographic { height },
            _ => return None,
        })
    }
}

impl Camera {
    /// Makes the core's camera, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Camera<S> {
        let points = [self.eye, self.center, self.up.unwrap_or(UP)].map(Vec3::from_array);
        let depths = [self.near.unwrap_or(f64::ZERO), self.far.unwrap_or(f64::FAR)];
        camera_in(&scanray::Camera::new(points, self.projection.in_core(), depths))
    }

    /// Takes a camera of the core; `None` for one that scene files do not know.
    pub fn of(camera: &scanray::Camera<f64>) -> Option<Self> {
        Some(Self {
            eye: camera.eye.to_array(),
            center: camera.center.to_array(),
            up: unless(UP, camera.up.to_array()),
            projection: Projection::of(camera.projection)?,
            near: unless(f64::ZERO, camera.near),
            far: unless(f64::FAR, camera.far),
        })
    }
}
