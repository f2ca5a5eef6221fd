//! Surfaces in sampled fields are where they ought to be, in every number.

use crate::kit::{Kit, scattered, scattered_point};
use crate::support::film;
use scanray::ray::Interval;
use scanray::*;
use std::sync::LazyLock;

/// Is `128 + 127 (1 - r)` at r from the origin, on 33 nodes an axis from -1.6 to 1.6.
static BALL: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let at = |n: usize| n as f64 * 0.1 - 1.6;
    let value = |n: usize| {
        let [x, y, z] = [n % 33, n / 33 % 33, n / 1089].map(at);
        (128.0 + 127.0 * (1.0 - (x * x + y * y + z * z).sqrt())).clamp(0.0, 255.0).round() as u8
    };
    (0..33 * 33 * 33).map(value).collect()
});

/// Is noise of 6 nodes an axis.
static NOISE: [u8; 216] = {
    let mut values = [0; 216];
    let mut i = 0;
    while i < 216 {
        values[i] =
            ((i as u32 + 1).wrapping_mul(0x9e37_79b9).rotate_left(7).wrapping_mul(0x85eb_ca6b) >> 24) as u8;
        i += 1;
    }
    values
};

fn cube<S: Scalar>(
    kit: &Kit<S>,
    values: &'static [u8],
    side: u16,
    low: f64,
    spacing: f64,
) -> &'static Grid<S> {
    let grid =
        Grid::new(Voxels::new([side; 3], values), kit.v(low, low, low), kit.v(spacing, spacing, spacing));
    // Never freed: a test is soon over.
    Box::leak(Box::new(grid))
}

mod checks {
    use super::*;

    pub fn the_surface_of_a_sampled_ball_is_the_ball_within_a_tenth_of_a_cell<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let grid = cube(&kit, &BALL, 33, -1.6, 0.1);
        // Values are rounded to 1/254 of a unit, and between nodes the distance is 1/400 off at most.
        let surface = Isosurface::new(grid, make(128.0));
        assert_eq!((surface.check(), surface.is_closed()), (Ok(()), true));
        let ball = Sphere::new(Vec3::ZERO, S::ONE);
        for i in 0..300 {
            let target = scattered_point(i, false).map(|c| 0.5 * c);
            let origin = scattered_point(i, true).map(|c| c * 4.0 + 2.0 * c.signum());
            let ray = kit.ray_at(origin, target);
            let crossing = surface.intersect(&ray, &Interval::AHEAD).expect("a hit");
            let exact = kit.seen(&ball, &ray).expect("a hit");
            assert!((read(crossing.t) - exact).abs() < 0.01, "{} instead of {exact}", read(crossing.t));
            let found = surface.surface(&ray, &crossing);
            let off = found.normal - ball.surface(&ray, &Crossing::at(crossing.t)).normal;
            assert!(read(off.length()) < 0.07, "{found:?}");
            // Outward it is not met again, inward at the far side.
            let out = Ray::new(found.point, found.normal);
            assert_eq!(surface.intersect_leaving(&out, &Interval::AHEAD), None);
            let across = Ray::new(found.point, -found.normal);
            let far = surface.intersect_leaving(&across, &Interval::AHEAD).expect("the far side");
            assert!((read(far.t) - 2.0).abs() < 0.02, "{far:?}");
            let inner = surface.surface(&across, &far);
            assert!(read(inner.normal.dot(across.direction)) > 0.9, "its back: {inner:?}");
        }
        assert_eq!(kit.seen(&surface, &kit.ray([5.0, 1.05, 0.0], [-1.0, 0.0, 0.0])), None, "past it");
        assert_eq!(kit.seen(&surface, &kit.ray([5.0, 9.0, 0.0], [-1.0, 0.0, 0.0])), None, "past its grid");
    }

    pub fn no_ray_passes_through_the_surface_in_noise<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        const STEPS: u32 = 3000;
        let kit = Kit(make, read);
        let grid = cube(&kit, &NOISE, 6, -1.0, 0.4);
        let surface = Isosurface::new(grid, make(127.5));
        let mut met = 0;
        for i in 0..400 {
            let end = scattered_point(i, false);
            let (start, end) = (end.map(|c| -1.7 * c), scattered_point(i, true));
            let ray = kit.ray_at(start, end);
            let inside = |t: f64| {
                let point = kit.plain(ray.at(make(t)));
                let within = point.iter().all(|c| c.abs() < 1.0 - 1e-5);
                within.then(|| read(grid.value(&grid.place(kit.at(point)))) - 127.5)
            };
            // The first step that is clearly on the other side than the one where the ray comes in.
            let steps = (0..STEPS).map(|step| 4.0 * f64::from(step) / f64::from(STEPS));
            let mut seen =
                steps.filter_map(|t| Some((t, inside(t)?))).filter(|(_, above)| above.abs() > 1e-3);
            let Some((_, first)) = seen.next() else { continue };
            let changed = seen.find(|(_, above)| (*above > 0.0) != (first > 0.0));
            if let Some((t, _)) = changed {
                met += 1;
                let found = kit.seen(&surface, &ray).expect("it goes through the surface");
                assert!(found <= t + 1e-5, "{found} though it has changed sides at {t}");
                let above = inside(found).unwrap_or(0.0);
                assert!(above.abs() < 0.01, "at {found} the field is {above} off");
            }
        }
        assert!(met > 250, "{met}");
    }

    pub fn where_the_grid_cuts_a_body_open_its_inside_is_seen<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        // Only the values in the middle: the ball of radius 1 is cut by planes 0.8 away.
        let kit = Kit(make, read);
        static CUT: LazyLock<Vec<u8>> = LazyLock::new(|| {
            let place = |n: usize| [n % 17, n / 17 % 17, n / 289].map(|k| k + 8);
            let value = |[x, y, z]: [usize; 3]| BALL[x + 33 * (y + 33 * z)];
            (0..17 * 17 * 17).map(|n| value(place(n))).collect()
        });
        let surface = Isosurface::new(cube(&kit, &CUT, 17, -0.8, 0.1), make(128.0));
        assert!(!surface.is_closed());
        // Through the middle there is nothing; from the middle to a corner there is, and from inside.
        assert_eq!(kit.seen(&surface, &kit.ray([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0])), None);
        let ray = kit.ray([0.1, 0.0, 0.0], [1.0, 1.0, 1.0]);
        let crossing = surface.intersect(&ray, &Interval::AHEAD).expect("the corner");
        assert!(read(surface.surface(&ray, &crossing).normal.dot(ray.direction)) > 0.9, "seen from inside");
    }

    pub fn a_body_that_reaches_any_side_of_the_grid_is_open<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        // The middle of 3 x 3 x 3 voxels, and that of one side with it.
        for (beside, closed) in
            [(13, true), (4, false), (22, false), (10, false), (16, false), (12, false), (14, false)]
        {
            let values: Vec<u8> = (0..27).map(|n| if n == 13 || n == beside { 200 } else { 0 }).collect();
            let surface = Isosurface::new(cube(&kit, values.leak(), 3, -1.0, 1.0), make(100.0));
            assert_eq!(surface.is_closed(), closed, "voxel {beside}");
        }
    }
}

in_every_number!(
    the_surface_of_a_sampled_ball_is_the_ball_within_a_tenth_of_a_cell,
    no_ray_passes_through_the_surface_in_noise,
    where_the_grid_cuts_a_body_open_its_inside_is_seen,
    a_body_that_reaches_any_side_of_the_grid_is_open,
);

use scanray::hit::Crossing;
use scanray::ray::Ray;

/// Is the voxels of the gallery's head, without blocks.
const PLAIN: Voxels =
    Voxels::new([48, 60, 56], include_bytes!("../../src/gallery/images/head_48x60x56.voxels"));

#[test]
fn leaving_out_blocks_changes_no_bit_of_a_surface() {
    fn check<S: gallery::Gallery>() {
        let view = S::find("isosurface").expect("a scene of the gallery");
        let objects: Vec<Object<S>> = view.scene.objects.to_vec();
        let plain = objects.iter().map(|object| match object.shape {
            Shape::Isosurface(surface) => {
                let grid: &'static Grid<S> = Box::leak(Box::new(Grid { voxels: PLAIN, ..*surface.grid }));
                Object::new(Shape::Isosurface(Isosurface { grid, ..surface }), object.material)
            }
            _ => *object,
        });
        let plain: Vec<Object<S>> = plain.collect();
        assert_ne!(plain, objects);
        let scene = Scene { objects: &plain, ..view.scene };
        let draw = |scene: &Scene<'_, S>| film(scene, &view.camera, [80, 80], view.settings, &mut ());
        assert!(draw(&scene) == draw(&view.scene));
    }
    check::<f32>();
    check::<Fixed>();
}

#[test]
fn the_surface_throws_a_shadow_and_is_seen_in_a_mirror() {
    let grid = cube(&Kit(|x| x as f32, f64::from), &BALL, 33, -1.6, 0.1);
    let ball = Shape::Isosurface(Isosurface::new(grid, 128.0));
    let exact = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));
    let floor = Object::new(Shape::Plane(Plane::new(Vec3::new(0.0, -1.1, 0.0), Vec3::new(0.0, 1.0, 0.0))), 1);
    let draw = |shape: Shape| {
        let objects = [Object::new(shape, 0), floor];
        let scene = Scene::new(&objects, &crate::support::MATERIALS, &crate::support::LIGHTS)
            .with_ambient(Rgb::gray(0.1));
        film(&scene, &crate::support::camera(), [80, 60], Settings::new(), &mut ())
    };
    let off = |a: &Rgb, b: &Rgb| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs()) > 0.08;
    let (surface, sphere) = (draw(ball), draw(exact));
    let differing = surface.iter().zip(&sphere).filter(|(a, b)| off(a, b)).count();
    assert!(differing < 60, "{differing} of 4800 pixels");
    assert!(scattered(1, 0).abs() <= 0.5);
}

#[test]
fn glass_wants_a_closed_surface_and_a_level_is_one_of_eight_bits() {
    let kit = Kit(|x| x as f32, f64::from);
    let glass = [Material::matte(Rgb::BLACK).with_glass(Glass::new(1.0, 1.5))];
    let check = |grid: &'static Grid, level: f32| {
        let objects = [Object::new(Shape::Isosurface(Isosurface::new(grid, level)), 0)];
        Scene::<f32>::new(&objects, &glass, &[]).check()
    };
    assert_eq!(check(cube(&kit, &BALL, 33, -1.6, 0.1), 128.0), Ok(()));
    assert_eq!(check(cube(&kit, &NOISE, 6, -1.0, 0.4), 128.0), Err(SceneError::Object(0, Fault::NotClosed)));
    for level in [-1.0, 256.0, f32::NAN] {
        let faulty = Err(SceneError::Object(0, Fault::OutOfRange));
        assert_eq!(check(cube(&kit, &BALL, 33, -1.6, 0.1), level), faulty);
    }
}
