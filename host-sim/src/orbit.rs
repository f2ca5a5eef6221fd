//! Orbits: a camera moved around what it looks at, and its window narrowed and widened.

use scanray::gallery::View;
use scanray::{Camera, Intersect, Projection, Vec3};

/// Is how far one arrow key walks, in radians: 48 steps around.
pub const STEP: f64 = std::f64::consts::TAU / 48.0;

/// Is how much one key or one notch of the wheel zooms.
pub const ZOOM: f64 = 1.1;

/// Is how near the line of sight may come to the axis of the orbit, in radians.
const POLE: f64 = 0.05;

/// Answers the point a view is walked around: on its line of sight, as far away as its objects.
///
/// The point a camera looks at may lie right before the eye. The objects' median distance says
/// better how far away things are, and one huge ball for a floor does not move it.
pub fn pivot(view: &View<f64>) -> Vec3<f64> {
    let camera = &view.camera;
    let toward = camera.center - camera.eye;
    let Some((forward, distance)) = toward.normalize() else { return camera.center };
    let depth = |center: Vec3<f64>| (center - camera.eye).dot(forward);
    let bounds = view.scene.objects.iter().filter_map(|object| object.shape.hull().bounds());
    let mut depths: Vec<f64> = bounds.map(|b| depth(b.center)).filter(|depth| *depth > 0.0).collect();
    depths.sort_by(f64::total_cmp);
    camera.eye + forward * depths.get(depths.len() / 2).copied().unwrap_or(distance)
}

/// Moves a camera around a point: to the right and up, in radians, as seen in the picture.
pub fn orbit(camera: &Camera<f64>, pivot: Vec3<f64>, right: f64, up: f64) -> Camera<f64> {
    let Some((axis, _)) = camera.up.normalize() else { return *camera };
    // A window that runs from right to left mirrors the picture.
    let right = if is_mirrored(camera) { -right } else { right };
    let offset = turn(camera.eye - pivot, axis, right);
    let Some((side, _)) = axis.cross(offset).normalize() else { return *camera };
    let [lowest, highest] = rises(camera, pivot);
    let rise = up.clamp(lowest, highest);
    let mut moved = *camera;
    moved.eye = pivot + turn(offset, side, -rise);
    moved.center = pivot;
    moved
}

/// Answers how far down and up a camera can go before it comes near the axis of the orbit, in radians: the first is
/// at most 0, the second at least 0.
pub fn rises(camera: &Camera<f64>, pivot: Vec3<f64>) -> [f64; 2] {
    let Some((axis, _)) = camera.up.normalize() else { return [0.0; 2] };
    let elevation = elevation(camera.eye - pivot, axis);
    let limit = std::f64::consts::FRAC_PI_2 - POLE;
    // A camera that begins nearer to the pole may stay there, but come no nearer.
    [(-limit - elevation).min(0.0), (limit - elevation).max(0.0)]
}

/// Narrows the window by a factor (widens it, below 1), so that things look larger.
pub fn zoom(camera: &Camera<f64>, factor: f64) -> Camera<f64> {
    let mut zoomed = *camera;
    zoomed.projection = match camera.projection {
        Projection::Perspective { fovy } => {
            let half = (fovy.to_radians() / 2.0).tan() / factor;
            Projection::Perspective { fovy: (2.0 * half.atan().to_degrees()).clamp(2.0, 150.0) }
        }
        Projection::Frustum { left, right, bottom, top } => {
            let [left, right, bottom, top] = [left, right, bottom, top].map(|edge| edge / factor);
            Projection::Frustum { left, right, bottom, top }
        }
        Projection::Orthographic { height } => Projection::Orthographic { height: height / factor },
        other => other,
    };
    zoomed
}

fn is_mirrored(camera: &Camera<f64>) -> bool {
    matches!(camera.projection, Projection::Frustum { left, right, .. } if left > right)
}

/// Answers the angle between a vector and the plane across the axis.
fn elevation(v: Vec3<f64>, axis: Vec3<f64>) -> f64 {
    let length = v.length();
    if length > 0.0 { (v.dot(axis) / length).clamp(-1.0, 1.0).asin() } else { 0.0 }
}

/// Turns a vector about a unit axis (Rodrigues' formula).
fn turn(v: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Vec3<f64> {
    let (sin, cos) = angle.sin_cos();
    v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes;
    use std::f64::consts::{FRAC_PI_2, TAU};

    fn camera() -> Camera<f64> {
        Camera::perspective(
            Vec3::new(0.0, 0.0, 5.0),
            Vec3::new(0.0, 0.0, 0.0),
            Vec3::new(0.0, 1.0, 0.0),
            40.0,
        )
    }

    fn close(a: Vec3<f64>, b: Vec3<f64>) -> bool {
        (a - b).length() < 1e-9
    }

    #[test]
    fn a_quarter_to_the_right_puts_the_eye_on_the_right_hand_axis() {
        let moved = orbit(&camera(), Vec3::ZERO, FRAC_PI_2, 0.0);
        assert!(close(moved.eye, Vec3::new(5.0, 0.0, 0.0)), "{:?}", moved.eye);
    }

    #[test]
    fn going_up_raises_the_eye_and_stops_before_the_pole() {
        let moved = orbit(&camera(), Vec3::ZERO, 0.0, 0.3);
        assert!(close(moved.eye, Vec3::new(0.0, 5.0 * 0.3_f64.sin(), 5.0 * 0.3_f64.cos())));
        let top = orbit(&camera(), Vec3::ZERO, 0.0, 10.0);
        assert!((top.eye.y - 5.0 * POLE.cos()).abs() < 1e-9 && top.eye.z > 0.0, "{:?}", top.eye);
    }

    #[test]
    fn a_camera_goes_as_far_up_and_down_as_it_is_told_that_it_can() {
        let [down, up] = rises(&camera(), Vec3::ZERO);
        assert!((up + down).abs() < 1e-9 && (up - (FRAC_PI_2 - POLE)).abs() < 1e-9, "{down} {up}");
        let highest = orbit(&camera(), Vec3::ZERO, 0.0, up);
        assert_eq!(highest, orbit(&camera(), Vec3::ZERO, 0.0, up + 1.0));
        assert!(rises(&highest, Vec3::ZERO)[1] < 1e-9);
        assert_ne!(highest, orbit(&camera(), Vec3::ZERO, 0.0, up - 0.01));
    }

    #[test]
    fn a_full_turn_comes_back_and_the_distance_never_changes() {
        let moved = orbit(&camera(), Vec3::ZERO, TAU, 0.0);
        assert!(close(moved.eye, camera().eye));
        let moved = orbit(&camera(), Vec3::new(1.0, 2.0, -3.0), 0.7, -0.4);
        let distance = (camera().eye - Vec3::new(1.0, 2.0, -3.0)).length();
        assert!(((moved.eye - moved.center).length() - distance).abs() < 1e-9);
    }

    #[test]
    fn a_mirrored_window_is_walked_around_the_other_way() {
        let mut mirrored = camera();
        mirrored.projection = Projection::Frustum { left: 1.0, right: -1.0, bottom: -1.0, top: 1.0 };
        assert!(orbit(&mirrored, Vec3::ZERO, 0.5, 0.0).eye.x < 0.0);
    }

    #[test]
    fn zooming_in_and_out_again_restores_the_window() {
        for entry in scenes::all() {
            let camera = entry.double.camera;
            let near = zoom(&camera, 1.25);
            assert_ne!(near.projection, camera.projection);
            let back = zoom(&near, 0.8);
            let text = format!("{:.9?}", back.projection);
            assert_eq!(text, format!("{:.9?}", camera.projection), "{}", entry.name());
        }
    }

    #[test]
    fn the_pivot_lies_on_the_line_of_sight_among_the_objects() {
        for entry in scenes::all() {
            let camera = &entry.double.camera;
            let (forward, _) = (camera.center - camera.eye).normalize().unwrap();
            let (toward, distance) = (pivot(entry.double) - camera.eye).normalize().unwrap();
            assert!(close(forward, toward), "{}", entry.name());
            assert!((3.0..200.0).contains(&distance), "{} at {distance}", entry.name());
        }
    }
}
