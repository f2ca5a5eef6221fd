//! Rays go where the camera's formulas say, row by row.

use scanray::camera::{Frame, RowRay};
use scanray::math::Scalar;
use scanray::{Camera, Fixed, Projection, Vec3};

const COLUMNS: u32 = 640;
const ROWS: u32 = 480;

type Point = [f64; 3];

fn add(a: Point, b: Point, scale: f64) -> Point {
    [a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: Point) -> Point {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

const EYE: Point = [3.0, 2.5, 7.0];
const CENTER: Point = [-1.0, 0.5, 0.25];
/// Rolled by some thirty degrees.
const UP: Point = [0.5, 1.0, 0.125];

/// Answers the axes xe, ye, ze of row C1.
fn axes() -> [Point; 3] {
    let ze = unit(add(EYE, CENTER, -1.0));
    let xe = unit(cross(UP, ze));
    [xe, cross(ze, xe), ze]
}

/// Answers where the middle of a pixel lies in a window of width and height 1.
fn place(x: u32, y: u32) -> (f64, f64) {
    ((f64::from(x) + 0.5) / f64::from(COLUMNS) - 0.5, 0.5 - (f64::from(y) + 0.5) / f64::from(ROWS))
}

fn camera<S: Scalar>(make: fn(f64) -> S, projection: Projection<S>) -> Camera<S> {
    let point = |[x, y, z]: Point| Vec3::new(make(x), make(y), make(z));
    Camera::new([point(EYE), point(CENTER), point(UP)], projection, [make(1.5), make(200.0)])
}

/// Runs through some rows and answers the largest distance of a ray from the expected one.
fn drift<S: Scalar>(
    frame: &Frame<S>,
    read: fn(S) -> f64,
    expected: impl Fn(u32, u32) -> (Point, Point),
    check: impl Fn(RowRay<S>, Point),
) -> f64 {
    let mut worst: f64 = 0.0;
    for y in (0..ROWS).step_by(37) {
        for (x, found) in (0..COLUMNS).zip(frame.row(y, 0)) {
            let (origin, direction) = expected(x, y);
            let origin_off = add(found.ray.origin.to_array().map(read), origin, -1.0);
            let direction_off = add(found.ray.direction.to_array().map(read), unit(direction), -1.0);
            worst = origin_off.into_iter().chain(direction_off).fold(worst, |w, off| w.max(off.abs()));
            check(found, direction);
        }
    }
    worst
}

fn perspective(x: u32, y: u32) -> (Point, Point) {
    let [xe, ye, ze] = axes();
    let height = 2.0 * 25_f64.to_radians().tan();
    let (u, v) = place(x, y);
    let direction = add(add(ze.map(|c| -c), xe, u * height * 640.0 / 480.0), ye, v * height);
    (EYE, direction)
}

#[test]
fn rays_of_a_row_do_not_drift_in_any_number() {
    fn worst<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) -> f64 {
        let camera = camera(make, Projection::Perspective { fovy: make(50.0) });
        let frame = camera.frame(COLUMNS, ROWS).expect("a good camera");
        drift(&frame, read, perspective, |found, direction| {
            // The clipping planes lie at depths 1.5 and 200: distances grow toward the corners.
            let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
            assert!((read(found.interval.near) - 1.5 * length).abs() < 1e-4);
            assert!((read(found.interval.far) - 200.0 * length).abs() < 1e-2);
        })
    }
    // A pixel is 1.5e-3 wide here: 2e-6 is 1/750 of it, 6e-6 is 1/250.
    let float = worst(|x| x as f32, f64::from);
    assert!(float < 2e-6, "f32: {float:e}");
    let fixed = worst(Fixed::new, Fixed::to_f64);
    assert!(fixed < 6e-6, "fixed point: {fixed:e}");
    let double = worst(|x| x, |x| x);
    assert!(double < 1e-14, "f64: {double:e}");
}

#[test]
fn parallel_rays_share_their_direction_and_move_their_origin() {
    let camera = camera(|x| x, Projection::Orthographic { height: 6.0 });
    let frame = camera.frame(COLUMNS, ROWS).expect("a good camera");
    let expected = |x, y| {
        let [xe, ye, ze] = axes();
        let (u, v) = place(x, y);
        (add(add(EYE, xe, u * 8.0), ye, v * 6.0), ze.map(|c| -c))
    };
    let worst = drift(
        &frame,
        |x| x,
        expected,
        |found, _| {
            assert_eq!((found.interval.near, found.interval.far), (1.5, 200.0));
        },
    );
    assert!(worst < 1e-13, "{worst:e}");
}

#[test]
fn an_off_centre_window_lies_on_the_near_plane() {
    let projection = Projection::Frustum { left: -0.2, right: 1.0, bottom: -0.1, top: 0.8 };
    let frame = camera(|x| x, projection).frame(COLUMNS, ROWS).expect("a good camera");
    let expected = |x, y| {
        let [xe, ye, ze] = axes();
        let (u, v) = place(x, y);
        let (right, up) = (0.4 + 1.2 * u, 0.35 + 0.9 * v);
        (EYE, add(add(ze.map(|c| -1.5 * c), xe, right), ye, up))
    };
    let worst = drift(&frame, |x| x, expected, |_, _| ());
    assert!(worst < 1e-14, "{worst:e}");
}
