use super::{Camera, Projection, Row};
use crate::math::{Scalar, Vec3, Wide, WideVec3, tan_half};
use core::fmt;

/// Tells what is wrong with a [`Camera`] or the picture it is to take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CameraError {
    /// A value is not a number or too large for the number type.
    OutOfRange,
    /// Eye and center are the same point, or up points along the line of sight.
    NoDirection,
    /// The angle is not between 0 and 180 degrees, or a side of the window is 0.
    NoWindow,
    /// Near is negative, 0 for a frustum, or not before far.
    NoDepth,
    /// The picture has no pixels, or more than 32767 along a side.
    BadSize,
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfRange => "camera: a value is not a number or too large for the number type",
            Self::NoDirection => "camera: eye and center coincide, or up points along the line of sight",
            Self::NoWindow => {
                "camera: the window has no extent, or the angle is not between 0 and 180 degrees"
            }
            Self::NoDepth => "camera: near must be at least 0 (above 0 for a frustum) and before far",
            Self::BadSize => "camera: a picture must have 1 to 32767 pixels along each side",
        })
    }
}

impl core::error::Error for CameraError {}

/// Is a camera made ready for a picture of a certain size: its axes and its window in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<S: Scalar> {
    /// Where the picture is taken from.
    pub eye: Vec3<S>,
    /// Line of sight, unit length.
    pub forward: Vec3<S>,
    pub(crate) near: S,
    pub(crate) far: S,
    pub(super) parallel: bool,
    /// Whether near or far hide anything.
    pub(super) clipped: bool,
    pub(super) size: [i32; 2],
    /// The upper left corner of the window from the eye, and its sides to the right and downward.
    pub(super) corner: WideVec3<S>,
    pub(super) right: WideVec3<S>,
    pub(super) down: WideVec3<S>,
}

/// Is a window at depth 1 (perspective) or at the eye (parallel): left, right, bottom, top.
type Window<S> = [S; 4];

/// Makes a row's or column's number one whose double fits.
pub(super) fn index(n: u32) -> i32 {
    n.min(i16::MAX as u32) as i32
}

fn times<S: Scalar>(value: S, numerator: i32, denominator: i32) -> S {
    S::narrow(value.mul_wide(S::ONE).scale(numerator, denominator))
}

fn window<S: Scalar>(camera: &Camera<S>, [columns, rows]: [i32; 2]) -> Result<Window<S>, CameraError> {
    let centered = |height: S| {
        let (half_width, half_height) = (times(height, columns, 2 * rows), times(height, 1, 2));
        [-half_width, half_width, -half_height, half_height]
    };
    match camera.projection {
        Projection::Perspective { fovy } => {
            if !(fovy > S::ZERO && fovy < S::from_i32(180)) {
                return Err(CameraError::NoWindow);
            }
            let half = tan_half(fovy);
            Ok(centered(half + half))
        }
        Projection::Frustum { left, right, bottom, top } => {
            if camera.near <= S::ZERO {
                return Err(CameraError::NoDepth);
            }
            let at_depth_one = |edge: S| S::div(edge.mul_wide(S::ONE), camera.near.mul_wide(S::ONE));
            Ok([left, right, bottom, top].map(at_depth_one))
        }
        Projection::Orthographic { height } => Ok(centered(height)),
    }
}

fn check_values<S: Scalar>(camera: &Camera<S>) -> Result<(), CameraError> {
    let extent = match camera.projection {
        Projection::Perspective { fovy } => [fovy, fovy, fovy, fovy],
        Projection::Frustum { left, right, bottom, top } => [left, right, bottom, top],
        Projection::Orthographic { height } => [height, height, height, height],
    };
    let points = [camera.eye, camera.center, camera.up];
    if !(points.iter().all(|p| p.in_range()) && extent.iter().all(|e| e.in_range())) {
        Err(CameraError::OutOfRange)
    } else if camera.near >= S::ZERO && camera.near < camera.far {
        Ok(())
    } else {
        Err(CameraError::NoDepth)
    }
}

/// Answers the unit vector across two directions; `None` where they are parallel.
fn across<S: Scalar>(up: Vec3<S>, ze: Vec3<S>) -> Option<Vec3<S>> {
    // Unit length first, so that a long `up` cannot saturate the product.
    let (unit, sine) = up.normalize()?.0.cross(ze).normalize()?;
    (sine > S::PARALLEL).then_some(unit)
}

impl<S: Scalar> Camera<S> {
    /// Makes the camera ready for a picture of so many columns and rows.
    ///
    /// `ze = unit(eye - center)`, `xe = unit(up x ze)`, `ye = ze x xe` (row C1).
    ///
    /// # Errors
    /// What is wrong with the camera or the size.
    pub fn frame(&self, columns: u32, rows: u32) -> Result<Frame<S>, CameraError> {
        check_values(self)?;
        let side = |n: u32| i16::try_from(n).ok().filter(|n| *n > 0).map(i32::from);
        let (Some(columns), Some(rows)) = (side(columns), side(rows)) else {
            return Err(CameraError::BadSize);
        };
        let [left, right, bottom, top] = window(self, [columns, rows])?;
        if ![left, right, bottom, top].iter().all(|edge| edge.in_range()) {
            return Err(CameraError::OutOfRange);
        }
        if left == right || bottom == top {
            return Err(CameraError::NoWindow);
        }
        let (ze, _) = (self.eye - self.center).normalize().ok_or(CameraError::NoDirection)?;
        let xe = across(self.up, ze).ok_or(CameraError::NoDirection)?;
        let ye = ze.cross(xe);
        let parallel = matches!(self.projection, Projection::Orthographic { .. });
        let depth = if parallel { WideVec3::ZERO } else { ze.mul_wide(-S::ONE) };
        Ok(Frame {
            eye: self.eye,
            forward: -ze,
            near: self.near,
            far: self.far,
            parallel,
            clipped: self.near > S::ZERO || self.far < S::FAR,
            size: [columns, rows],
            corner: depth + xe.mul_wide(left) + ye.mul_wide(top),
            right: xe.mul_wide(right - left),
            down: ye.mul_wide(bottom - top),
        })
    }
}

impl<S: Scalar> Frame<S> {
    /// Answers the rays of row `y`, counted from the top, beginning with column `x`.
    ///
    /// Rows and columns beyond the picture follow on; those beyond 32767 are taken as that.
    pub fn row(&self, y: u32, x: u32) -> Row<'_, S> {
        Row::new(self, self.row_start(y), index(x))
    }

    /// Answers where all rays start, if they start at one point.
    pub fn one_eye(&self) -> Option<Vec3<S>> {
        (!self.parallel).then_some(self.eye)
    }

    /// Answers the sides of a pixel on the window, to the right and downward.
    pub fn pixel(&self) -> [Vec3<S>; 2] {
        [self.step(), self.down.scale(1, self.size[1])].map(WideVec3::narrow)
    }

    /// Answers the left end of the middle of a row, from the eye.
    pub(super) fn row_start(&self, y: u32) -> WideVec3<S> {
        self.line_start(y, [1, 2])
    }

    /// Answers the left end of a line of a row, from the eye; `above` of the row's height lies above it,
    /// numerator and denominator.
    pub(super) fn line_start(&self, y: u32, [above, height]: [u8; 2]) -> WideVec3<S> {
        let [above, height] = [above, height].map(i32::from);
        self.corner
            + self.down.scale(
                height.saturating_mul(index(y)).saturating_add(above),
                height.saturating_mul(self.size[1]),
            )
    }

    pub(super) fn step(&self) -> WideVec3<S> {
        self.right.scale(1, self.size[0])
    }

    /// Answers what the middle of column `x` adds to the start of a row.
    pub(super) fn column(&self, x: i32) -> WideVec3<S> {
        self.right.scale(x.saturating_mul(2).saturating_add(1), self.size[0].wrapping_mul(2))
    }
}
