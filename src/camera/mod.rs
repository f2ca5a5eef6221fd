//! Cameras: which ray belongs to which pixel.

mod fan;
mod frame;
mod row;
mod section;
mod turn;

pub use fan::Fan;
pub use frame::{CameraError, Frame};
pub use row::{Row, RowRay};

use crate::math::{Scalar, Vec3};

/// Names how a [`Camera`] projects.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Projection<S = f32> {
    /// Pinhole with a window in the middle (row C1; gluPerspective).
    Perspective {
        /// Angle between the lower and the upper edge, in degrees, above 0 and below 180.
        fovy: S,
    },
    /// Pinhole with a window anywhere on the near plane, mirrored where an edge passes its
    /// opposite (row C2; glFrustum).
    Frustum {
        /// Left edge on the near plane.
        left: S,
        /// Right edge on the near plane.
        right: S,
        /// Lower edge on the near plane.
        bottom: S,
        /// Upper edge on the near plane.
        top: S,
    },
    /// Parallel rays from a window around the eye (row C3).
    Orthographic {
        /// Height of the window; its width follows from the picture's shape.
        height: S,
    },
}

/// Is where the picture is taken from and how.
///
/// The width of the picture follows from its height and its pixels, which are square, but for
/// [`Projection::Frustum`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<S = f32> {
    /// Centre of projection.
    pub eye: Vec3<S>,
    /// Point that is looked at.
    pub center: Vec3<S>,
    /// Direction that is up in the picture, of any length.
    pub up: Vec3<S>,
    /// How it projects.
    pub projection: Projection<S>,
    /// Depth along the line of sight before which nothing is seen (row C4).
    pub near: S,
    /// Depth along the line of sight beyond which nothing is seen (row C4).
    pub far: S,
}

impl<S: Scalar> Camera<S> {
    /// Makes a camera of any projection: eye, center and up, then the depths it sees between.
    pub const fn new(
        [eye, center, up]: [Vec3<S>; 3],
        projection: Projection<S>,
        [near, far]: [S; 2],
    ) -> Self {
        Self { eye, center, up, projection, near, far }
    }

    /// Makes a pinhole camera with an angle between lower and upper edge of `fovy` degrees.
    pub const fn perspective(eye: Vec3<S>, center: Vec3<S>, up: Vec3<S>, fovy: S) -> Self {
        Self::new([eye, center, up], Projection::Perspective { fovy }, [S::ZERO, S::FAR])
    }

    /// Makes a pinhole camera of eye, center and up, a window on the near plane given by its left,
    /// right, lower and upper edge, and the near and far depth.
    pub const fn frustum(points: [Vec3<S>; 3], window: [S; 4], depths: [S; 2]) -> Self {
        let [left, right, bottom, top] = window;
        Self::new(points, Projection::Frustum { left, right, bottom, top }, depths)
    }

    /// Makes a camera with parallel rays and a window of this height.
    pub const fn orthographic(eye: Vec3<S>, center: Vec3<S>, up: Vec3<S>, height: S) -> Self {
        Self::new([eye, center, up], Projection::Orthographic { height }, [S::ZERO, S::FAR])
    }

    /// Sets the depths between which something is seen.
    pub const fn with_clip(mut self, near: S, far: S) -> Self {
        self.near = near;
        self.far = far;
        self
    }
}
