//! A turning camera comes round to the bit and stays on its circle within the stated bounds.

use scanray::gallery::Gallery;
use scanray::math::Scalar;
use scanray::{Camera, Fixed, Vec3};

/// Answers a camera that looks at the origin, with the eye at a place and an axis of any length.
fn camera<S: Scalar>(eye: [S; 3], up: [S; 3]) -> Camera<S> {
    Camera::perspective(Vec3::from_array(eye), Vec3::ZERO, Vec3::from_array(up), S::from_i32(40))
}

#[test]
fn a_whole_turn_ends_on_the_bits_it_began_with() {
    fn check<S: Gallery>() {
        for view in S::views() {
            for steps in [1, 2, 7, 48, 360, u16::MAX] {
                let at = |step| view.camera.turned(step, steps);
                assert_eq!(at(0), view.camera, "{}", view.name);
                assert_eq!(at(u32::from(steps)), view.camera, "{}", view.name);
                let (some, turn) = (u32::from(steps) / 3, u32::from(steps));
                assert_eq!(at(some), at(some + 1000 * turn), "{}", view.name);
            }
            assert_eq!(view.camera.turned(5, 0), view.camera);
        }
    }
    check::<f32>();
    check::<Fixed>();
    check::<f64>();
}

#[test]
fn every_step_is_another_camera_and_only_its_eye_moves() {
    let view = Fixed::find("simple").expect("a scene of the gallery");
    let eyes: Vec<_> = (0..72).map(|step| view.camera.turned(step, 72).eye).collect();
    for (step, eye) in eyes.iter().enumerate() {
        assert_eq!(eyes.iter().filter(|other| *other == eye).count(), 1, "step {step}");
        let turned = view.camera.turned(step as u32, 72);
        assert_eq!(Camera { eye: view.camera.eye, ..turned }, view.camera);
    }
}

#[test]
fn the_camera_turns_to_its_right() {
    let right = camera([0.0, 1.0, 5.0], [0.0, 2.0, 0.0]).turned(1, 8);
    assert!(right.eye.x > 3.5 && right.eye.z > 3.5 && (right.eye.y - 1.0_f64).abs() < 1e-15);
}

#[test]
fn opposite_steps_are_opposite_to_the_bit() {
    let at = |step| {
        camera([Fixed::new(7.3), Fixed::ZERO, Fixed::ZERO], [0, 1, 0].map(Fixed::from_i32)).turned(step, 26)
    };
    for step in 1..13 {
        let (eye, across) = (at(step).eye, at(step + 13).eye);
        assert_eq!(eye + across, Vec3::ZERO, "step {step}");
    }
}

/// Answers the eye as sine and cosine of the standard library have it.
fn exact(eye: [f64; 3], up: [f64; 3], angle: f64) -> [f64; 3] {
    let length = up.map(|c| c * c).iter().sum::<f64>().sqrt();
    let [kx, ky, kz] = up.map(|c| c / length);
    let [x, y, z] = eye;
    let cross = [ky * z - kz * y, kz * x - kx * z, kx * y - ky * x];
    let along = kx * x + ky * y + kz * z;
    let axis = [kx, ky, kz];
    let (sine, cosine) = angle.sin_cos();
    [0, 1, 2].map(|i| eye[i] * cosine + cross[i] * sine + axis[i] * along * (1.0 - cosine))
}

/// Answers the worst distance from where the eye should be, in shares of its distance from the center and 1.
fn worst<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    let arms = [
        ([3.0, 2.5, 7.0], [0.5, 1.0, 0.125]),
        ([400.0, 40.0, -300.0], [0.0, 3.0, 0.0]),
        ([0.03, -0.01, 0.02], [-0.1, 0.2, 0.0]),
    ];
    for (eye, up) in arms {
        let (eye, up) = (eye.map(make), up.map(make));
        let (from, axis) = (eye.map(read), up.map(read));
        let length = |v: [f64; 3]| v.map(|c| c * c).iter().sum::<f64>().sqrt();
        for steps in [3_u16, 72, 1000, 65_535] {
            for step in (0..u32::from(steps)).step_by(usize::from(steps / 500 + 1)) {
                let angle = std::f64::consts::TAU * f64::from(step) / f64::from(steps);
                let expected = exact(from, axis, angle);
                let found = camera(eye, up).turned(step, steps).eye.to_array().map(read);
                let off = length([0, 1, 2].map(|i| found[i] - expected[i]));
                worst = worst.max(off / (length(from) + 1.0));
            }
        }
    }
    worst
}

#[test]
fn the_eye_stays_within_the_stated_bounds() {
    let bounds = [
        (worst(Fixed::new, Fixed::to_f64), 5e-6, "fixed point"),
        (worst(|x| x as f32, f64::from), 3e-7, "f32"),
        (worst(|x| x, |x| x), 2e-15, "f64"),
    ];
    for (worst, bound, number) in bounds {
        assert!(worst <= bound, "{number}: {worst:e} passes the bound {bound:e}");
        assert!(worst >= bound / 20.0, "{number}: {worst:e}, the bound {bound:e} says too little");
    }
}
