use super::description::{Camera, Projection};
use super::matrix::Matrix;
use super::roots::Ray;
use super::vector::Vector;

/// Is a camera as OpenGL's matrices describe it, for a picture of one size.
pub(super) struct Lens {
    to_eye: Matrix,
    from_eye: Matrix,
    from_clip: Matrix,
    parallel: bool,
    size: [f64; 2],
    near: f64,
    far: f64,
}

/// Answers the edges of a gluPerspective window at depth 1.
fn edges(fovy: f64, aspect: f64) -> [f64; 4] {
    let top = (fovy.to_radians() / 2.0).tan();
    [-top * aspect, top * aspect, -top, top]
}

impl Lens {
    /// Makes the matrices for a picture of so many columns and rows.
    pub fn of(camera: &Camera, [columns, rows]: [u32; 2]) -> Self {
        let size = [f64::from(columns), f64::from(rows)];
        let aspect = size[0] / size[1];
        // The far plane of a projection does not change where its pixels lie.
        let (projection, parallel) = match camera.projection {
            Projection::Perspective { fovy } => (Matrix::frustum(edges(fovy, aspect), 1.0, 2.0), false),
            Projection::Frustum { edges } => (Matrix::frustum(edges, camera.near, 2.0 * camera.near), false),
            Projection::Orthographic { height } => {
                (Matrix::orthographic(height * aspect, height, -1.0, 1.0), true)
            }
        };
        let to_eye = Matrix::look_at(camera.eye, camera.center, camera.up);
        let (from_eye, from_clip) = (to_eye.inverse(), projection.inverse());
        Self { to_eye, from_eye, from_clip, parallel, size, near: camera.near, far: camera.far }
    }

    /// Answers the ray through the middle of a pixel; row 0 is the top.
    pub fn ray(&self, x: u32, y: u32) -> Ray {
        let right = 2.0 * (f64::from(x) + 0.5) / self.size[0] - 1.0;
        let up = 1.0 - 2.0 * (f64::from(y) + 0.5) / self.size[1];
        let on_window = |depth: f64| self.from_clip.point(Vector([right, up, depth]));
        if self.parallel {
            let start = self.from_eye.point(on_window(0.0));
            let direction = self.from_eye.direction(on_window(1.0) - on_window(-1.0));
            return Ray { start, direction };
        }
        let start = self.from_eye.point(Vector([0.0; 3]));
        Ray { start, direction: self.from_eye.direction(on_window(-1.0)) }
    }

    /// Answers where a ray crosses the near and the far plane, in units of its direction.
    pub fn span(&self, ray: &Ray) -> [f64; 2] {
        let [_, _, start] = self.to_eye.point(ray.start).0;
        let [_, _, end] = self.to_eye.point(ray.point(1.0)).0;
        [self.near, self.far].map(|depth| (-depth - start) / (end - start))
    }

    /// Tells whether a point lies between the near and the far plane.
    pub fn sees(&self, point: Vector) -> bool {
        let [_, _, z] = self.to_eye.point(point).0;
        self.near < -z && -z < self.far
    }
}
