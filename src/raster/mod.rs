//! The other approach: a z-buffer, one row of depths at a time (row Z1).
//!
//! A ray tracer asks for each pixel which object it sees; a z-buffer asks for each object which pixels
//! it covers, and keeps for each pixel the nearest that came along (E. Catmull 1974). Nothing here
//! meets a ray with a shape. With a row at a time, as scan-line renderers have it (G. Watkins 1970),
//! the whole buffer is a row of depths and the names of what lies there:
//!
//! ```text
//! row -> its plane through the eye
//!   -> each object: cut by the plane -> clipped by the window -> projected: a span of columns
//!     -> each column: the depth is stepped to, tested and kept if it is nearer
//!   -> each pixel: the hit of whatever was kept -> shade -> linear light -> panel
//! ```
//!
//! Stepping is possible because 1/z of anything flat grows evenly along a row, which z does not
//! (J. Blinn 1992, "Hyperbolic Interpolation"): a face costs an addition and a comparison a pixel, where
//! a ray takes products and a division to meet it. A ball's 1/z takes one square root of a product of two
//! evenly growing numbers, see `ball.rs`.
//!
//! Work grows with the pixels that objects cover, not with pixels times objects, and none of it knows of
//! more than one object: whatever needs another ray is lost. There are no shadows, and mirrors and glass show
//! their own surface alone, glass opaque, as the tracer has them at depth 0. Textures, bumps and light are the
//! tracer's own code.
//!
//! Depths are told apart best near the eye. In fixed point, with the nearest thing one unit away, a depth z
//! of a flat face is off by z^2 * 1e-7 at most: by 1e-5 at 10 and by 1e-3 at 100.

mod ball;
mod clearance;
mod cuboid;
mod depths;
mod figure;
mod level;
mod renderer;
mod shading;
mod slice;
mod span;
mod triangle;
mod workspace;

pub use renderer::RasterRenderer;
pub use workspace::RasterWorkspace;

#[cfg(test)]
mod tests {
    use super::depths::{Fragment, Painter};
    use super::slice::Slice;
    use crate::camera::Camera;
    use crate::math::{Fixed, Scalar, Vec3};
    use crate::shape::{Cuboid, Plane, Shape, Sphere, Triangle};
    use core::convert::Infallible;

    const SIDE: usize = 101;
    const MIDDLE: usize = 50;

    const fn v(x: f64, y: f64, z: f64) -> Vec3<f64> {
        Vec3::new(x, y, z)
    }

    /// Looks from the origin along -z, a right angle wide.
    fn camera() -> Camera<f64> {
        Camera::perspective(Vec3::ZERO, v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 90.0)
    }

    /// Answers the z depth of a shape in the middle row, infinite where it is not seen.
    fn depths(shape: Shape<f64>, camera: Camera<f64>) -> [f64; SIDE] {
        let frame = camera.frame(SIDE as u32, SIDE as u32).unwrap();
        let slice = Slice::of(&frame, MIDDLE as u32, 0.5).unwrap();
        let mut row = [Fragment::empty(slice.farthest); SIDE];
        let mut painter = Painter { row: &mut row, object: 0, observer: &mut () };
        match &shape {
            Shape::<f64, Infallible>::Sphere(ball) => super::ball::paint(ball, &slice, &mut painter),
            Shape::Plane(plane) => super::level::paint(plane, &slice, &mut painter),
            Shape::Triangle(triangle) => super::triangle::paint(triangle, &slice, &mut painter),
            Shape::Cuboid(cuboid) => super::cuboid::paint(cuboid, &slice, &mut painter),
            _ => panic!("the z-buffer draws no such shape"),
        }
        let depth = |fragment: &Fragment<f64>| slice.distance(fragment.nearness, 1.0);
        row.each_ref().map(|fragment| if fragment.object == 0 { depth(fragment) } else { f64::INFINITY })
    }

    fn ball(z: f64, radius: f64) -> Shape<f64> {
        Shape::Sphere(Sphere::new(v(0.0, 0.0, z), radius))
    }

    #[test]
    fn a_ball_is_as_deep_as_its_front_and_cut_open_or_from_inside_as_its_back() {
        let middle = |shape, camera| depths(shape, camera)[MIDDLE];
        assert!((middle(ball(-5.0, 2.0), camera()) - 3.0).abs() < 1e-12);
        assert!((middle(ball(-5.0, 2.0), camera().with_clip(4.0, 100.0)) - 7.0).abs() < 1e-12);
        assert!((middle(ball(-1.0, 2.0), camera()) - 3.0).abs() < 1e-12);
        assert!((middle(ball(0.0, 2.0), camera()) - 2.0).abs() < 1e-12);
        assert_eq!(middle(ball(5.0, 2.0), camera()), f64::INFINITY, "behind the eye");
        assert_eq!(middle(ball(-5.0, 2.0), camera().with_clip(0.0, 2.5)), f64::INFINITY, "too far");
    }

    #[test]
    fn a_ball_ends_at_its_tangents() {
        // From 5 away a ball of 3 is seen up to the slope 3/4: 37.9 pixels to either side of the middle.
        let depths = depths(ball(-5.0, 3.0), camera());
        assert!(depths[12].is_infinite() && depths[13].is_finite());
        assert!(depths[87].is_finite() && depths[88].is_infinite());
    }

    #[test]
    fn along_a_slanted_face_the_reciprocal_of_depth_grows_evenly() {
        let [a, b] = [v(-3.0, -1.0, -3.0), v(-3.0, 1.0, -3.0)];
        let depths = depths(Shape::Triangle(Triangle::new(a, b, v(12.0, 0.0, -8.0))), camera());
        for (column, depth) in depths.iter().enumerate().take(90) {
            // The line through (-3, -3) and (12, -8): z = -4 - x / 3, met at x = slope * -z.
            let slope = (column as f64 - MIDDLE as f64) / 50.5;
            assert!((1.0 / depth - (1.0 - slope / 3.0) / 4.0).abs() < 1e-12, "column {column}: {depth}");
        }
    }

    #[test]
    fn in_fixed_point_a_depth_is_as_good_as_the_documentation_says() {
        // As above, 25 times as far.
        let eye = Vec3::<Fixed>::ZERO;
        let (ahead, up) = (Vec3::from_f64(0.0, 0.0, -1.0), Vec3::from_f64(0.0, 1.0, 0.0));
        let frame =
            Camera::perspective(eye, ahead, up, Fixed::new(90.0)).frame(SIDE as u32, SIDE as u32).unwrap();
        let slice = Slice::of(&frame, MIDDLE as u32, Fixed::ONE).unwrap();
        let mut row = [Fragment::empty(slice.farthest); SIDE];
        let [a, b] = [Vec3::from_f64(-75.0, -25.0, -75.0), Vec3::from_f64(-75.0, 25.0, -75.0)];
        let face = Triangle::new(a, b, Vec3::from_f64(300.0, 0.0, -200.0));
        super::triangle::paint(&face, &slice, &mut Painter { row: &mut row, object: 0, observer: &mut () });
        for (column, fragment) in row.iter().enumerate().take(90) {
            let slope = (column as f64 - MIDDLE as f64) / 50.5;
            let (exact, found) = (100.0 / (1.0 - slope / 3.0), slice.distance(fragment.nearness, Fixed::ONE));
            let off = (found.to_f64() - exact).abs();
            assert!(off <= exact * exact * 1e-7, "column {column}: off by {off}");
        }
    }

    #[test]
    fn a_plane_reaches_to_its_horizon_and_no_farther() {
        // A wall to the left of the eye: its horizon is upright, in the middle of the row.
        let wall = Shape::Plane(Plane::new(v(-2.0, 0.0, 0.0), v(1.0, 0.0, 0.0)));
        let depths = depths(wall, camera());
        assert!((depths[0] - 2.0 * 50.5 / 50.0).abs() < 1e-12);
        assert!(depths[MIDDLE - 1].is_finite() && depths[MIDDLE + 1].is_infinite());
    }

    #[test]
    fn a_room_is_seen_from_within() {
        let room = Shape::Cuboid(Cuboid::new(v(-1.0, -1.0, -2.0), v(1.0, 1.0, 1.0)));
        let depths = depths(room, camera());
        assert!((depths[MIDDLE] - 2.0).abs() < 1e-12);
        // The far wall ends at the slope 1/2, and the left one comes to meet it.
        assert!((depths[0] - 50.5 / 50.0).abs() < 1e-12);
        assert!(depths.iter().all(|depth| depth.is_finite()));
    }

    #[test]
    fn of_two_equally_near_the_first_stays() {
        let mut row = [Fragment::empty(0.0); 1];
        for (object, nearness) in [(0, 1.0), (1, 1.0), (2, 0.5), (3, 2.0), (4, 2.0)] {
            let mut painter = Painter { row: &mut row, object, observer: &mut () };
            painter.paint(0..1, 7, |_| core::iter::repeat(nearness));
        }
        assert_eq!((row[0].object, row[0].part, row[0].nearness), (3, 7, 2.0));
    }
}
