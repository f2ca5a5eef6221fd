use super::Fault;
use scanray::{Camera, Vec3};

/// Is what a pinhole camera sees through: a window one unit before the eye, anywhere across the line
/// of sight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    /// Where the picture is taken from.
    pub eye: Vec3<f64>,
    /// Line of sight, unit length.
    pub forward: Vec3<f64>,
    /// The upper left corner from the eye.
    pub corner: Vec3<f64>,
    /// The upper side, from left to right.
    pub right: Vec3<f64>,
    /// The left side, from top to bottom.
    pub down: Vec3<f64>,
}

impl Window {
    /// Reads the window off the rays that the core sends through it, whatever the projection is made of.
    pub fn of(camera: &Camera<f64>, [columns, rows]: [u32; 2]) -> Result<Self, Fault> {
        let frame = camera.frame(columns, rows)?;
        let eye = frame.one_eye().ok_or(Fault::Unwritable("parallel rays"))?;
        // A row of rays never ends.
        let through = |x, y| {
            let toward = frame.row(y, x).next().map_or(frame.forward, |primary| primary.ray.direction);
            toward * (1.0 / toward.dot(frame.forward))
        };
        let first = through(0, 0);
        let (column, row) = (through(1, 0) - first, through(0, 1) - first);
        Ok(Self {
            eye,
            forward: frame.forward,
            corner: first - (column + row) * 0.5,
            right: column * f64::from(columns),
            down: row * f64::from(rows),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_of_a_right_angle_is_two_high_and_as_wide_as_the_picture() {
        let ahead = Vec3::new(0.0, 0.0, -1.0);
        let camera = Camera::perspective(Vec3::ZERO, ahead, Vec3::new(0.0, 1.0, 0.0), 90.0);
        let window = Window::of(&camera, [30, 20]).unwrap();
        let right = [
            (window.corner, Vec3::new(-1.5, 1.0, -1.0)),
            (window.right, Vec3::new(3.0, 0.0, 0.0)),
            (window.down, Vec3::new(0.0, -2.0, 0.0)),
        ];
        for (seen, wanted) in right {
            assert!((seen - wanted).length() < 1e-12, "{seen:?} {wanted:?}");
        }
    }

    #[test]
    fn parallel_rays_have_no_window() {
        let camera =
            Camera::orthographic(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 2.0);
        assert!(matches!(Window::of(&camera, [4, 4]), Err(Fault::Unwritable("parallel rays"))));
    }
}
