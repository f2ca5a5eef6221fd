//! Volumes have the known opacities and colours, in every number.

use crate::kit::{Kit, scattered_point};
use crate::support::film;
use scanray::ray::Interval;
use scanray::volume::Class;
use scanray::*;

/// Is 200 at each of 9 x 9 x 9 nodes, and at each of 2 x 2 x 2.
static LEVEL: [u8; 729] = [200; 729];
static CELL: [u8; 8] = [200; 8];
/// Is `10 i + 100` at node (i, j, k).
static RAMP: [u8; 64] = {
    let mut values = [0; 64];
    let mut i = 0;
    while i < 64 {
        values[i] = 100 + 10 * (i % 4) as u8;
        i += 1;
    }
    values
};

/// Is the share of light that a way takes.
fn opacity(density: f64, length: f64) -> f64 {
    1.0 - (-density * length).exp()
}

fn colors<S: Scalar>(kit: &Kit<S>, Rgb { r, g, b }: Rgb<S>) -> [f64; 3] {
    [r, g, b].map(kit.1)
}

#[track_caller]
fn assert_near(seen: [f64; 3], expected: [f64; 3], precision: f64) {
    let near = seen.iter().zip(expected).all(|(a, b)| (a - b).abs() < precision);
    assert!(near, "{seen:?} instead of {expected:?}");
}

/// Makes the box from -1 to 1 of some values.
fn cube<S: Scalar>(kit: &Kit<S>, values: &'static [u8], side: u16) -> Grid<S> {
    let spacing = 2.0 / f64::from(side - 1);
    Grid::new(Voxels::new([side; 3], values), kit.v(-1.0, -1.0, -1.0), kit.v(spacing, spacing, spacing))
}

fn table<S: Scalar>(kit: &Kit<S>, opacity: u8) -> &'static [Class<S>] {
    let color = Rgb::new((kit.0)(0.8), (kit.0)(0.4), (kit.0)(0.1));
    // Never freed: a test is soon over.
    Box::leak(Box::new([Class::new(50, color, opacity)]))
}

mod checks {
    use super::*;

    pub fn a_homogeneous_body_is_as_opaque_as_it_is_deep_whatever_its_voxels<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let ambient = Rgb::gray(make(0.5));
        for i in 0..100 {
            let ray =
                kit.ray_at(scattered_point(i, false).map(|c| 3.0 * c + c.signum()), scattered_point(i, true));
            let slabs = |end: f64| {
                let (o, d) = (kit.plain(ray.origin), kit.plain(ray.direction));
                let at = |axis: usize, face: f64| (face - o[axis]) / d[axis];
                let enter = (0..3).map(|axis| at(axis, -1.0).min(at(axis, 1.0))).fold(0.0, f64::max);
                let leave = (0..3).map(|axis| at(axis, -1.0).max(at(axis, 1.0))).fold(end, f64::min);
                (leave - enter).max(0.0)
            };
            for (values, side) in [(&LEVEL[..], 9), (&CELL[..], 2)] {
                // 51 is a fifth of 255.
                let volume =
                    Volume::new(cube(&kit, values, side), table(&kit, 51), make(6.0)).with_faintest(S::ZERO);
                for end in [100.0, 2.5] {
                    let interval = Interval::new(S::ZERO, make(end));
                    let veil = volume.veil(
                        &ray,
                        &interval,
                        &[Light::directional(kit.v(0.0, 1.0, 0.0), Rgb::WHITE)],
                        ambient,
                    );
                    let share = opacity(1.2, slabs(end));
                    assert!((read(veil.transparency) - (1.0 - share)).abs() < 6e-5, "{veil:?}, not {share}");
                    // A level field has no normal: ambient light alone.
                    assert_near(colors(&kit, veil.color), [0.4, 0.2, 0.05].map(|c| c * share), 6e-5);
                }
            }
        }
    }

    pub fn a_slope_is_lit_from_where_values_are_lower<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        let lamp = |toward: [f64; 3]| Light::directional(kit.at(toward), Rgb::gray(make(2.0)));
        for gradient in [Gradient::First, Gradient::Second] {
            for reconstruction in [Reconstruction::Nearest, Reconstruction::Trilinear] {
                let volume = Volume::new(cube(&kit, &RAMP, 4), table(&kit, 255), make(1.0))
                    .with_gradient(gradient)
                    .with_reconstruction(reconstruction);
                let ray = kit.ray([0.1, 0.2, 5.0], [0.0, 0.0, -1.0]);
                let lit = |light: Light<S>| {
                    let veil = volume.veil(&ray, &Interval::AHEAD, &[light], Rgb::gray(make(0.25)));
                    colors(&kit, veil.color)
                };
                let share = opacity(1.0, 2.0);
                let expected = |light: f64| [0.8, 0.4, 0.1].map(|c| c * light * share);
                assert_near(lit(lamp([-3.0, 0.0, 0.0])), expected(0.25 + 2.0), 1e-4);
                assert_near(lit(lamp([-1.0, 1.0, 0.0])), expected(0.25 + 2.0 * 0.5_f64.sqrt()), 1e-4);
                assert_near(lit(lamp([1.0, 0.0, 0.0])), expected(0.25), 1e-4);
                let point = Light::point(kit.v(-50.0, 0.2, 0.0), Rgb::gray(make(2.0)));
                assert_near(lit(point), expected(0.25 + 2.0), 2e-3);
            }
        }
    }
}

in_every_number!(
    a_homogeneous_body_is_as_opaque_as_it_is_deep_whatever_its_voxels,
    a_slope_is_lit_from_where_values_are_lower,
);

/// Is the voxels of the gallery's head, without blocks.
const PLAIN: Voxels =
    Voxels::new([48, 60, 56], include_bytes!("../../src/gallery/images/head_48x60x56.voxels"));

/// Draws the gallery's head with another volume.
fn head<S: gallery::Gallery>(change: impl Fn(Volume<S>) -> Volume<S>) -> Vec<Rgb<S>> {
    let view = S::find("phantom").expect("a scene of the gallery");
    let volume = change(*view.scene.volume.expect("its volume"));
    let scene = Scene { volume: Some(&volume), ..view.scene };
    film(&scene, &view.camera, [80, 80], view.settings, &mut ())
}

fn without_blocks<S: Scalar>(volume: Volume<S>) -> Volume<S> {
    Volume { grid: Grid { voxels: PLAIN, ..volume.grid }, ..volume }
}

#[test]
fn leaving_out_blocks_changes_no_bit_of_a_volume() {
    assert!(head::<f32>(|volume| volume) == head::<f32>(without_blocks));
    assert!(head::<Fixed>(|volume| volume) == head::<Fixed>(without_blocks));
}

#[test]
fn ending_a_ray_early_changes_a_channel_by_no_more_than_the_transparency_left() {
    let (ended, whole) = (head::<f64>(|volume| volume), head::<f64>(|volume| volume.with_faintest(0.0)));
    let off = |faintest: f64| {
        let ended =
            if faintest > 0.0 { head::<f64>(|volume| volume.with_faintest(faintest)) } else { ended.clone() };
        let channels =
            |(a, b): (&Rgb<f64>, &Rgb<f64>)| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs());
        ended.iter().zip(&whole).map(channels).fold(0.0, f64::max)
    };
    // Nothing in the scene is brighter than 1.3.
    let usual = off(0.0);
    assert!(usual > 0.0 && usual <= 1.3 / 8192.0, "{usual}");
    let early = off(0.25);
    assert!(early > 0.02 && early <= 1.3 * 0.25, "{early}");
}

#[test]
fn a_volume_of_nothing_is_not_seen_and_mirrors_do_not_see_any() {
    let kit = Kit(|x| x as f32, f64::from);
    let clear = Volume::new(cube(&kit, &LEVEL, 9), table(&kit, 0), 9.0);
    let scene = crate::support::scene();
    let draw = |scene: &Scene<'_>| film(scene, &crate::support::camera(), [60, 40], Settings::new(), &mut ());
    assert!(draw(&scene.with_volume(&clear)) == draw(&scene));
    // Behind the eye, where only the mirrors look.
    let aside = Grid { low: kit.v(-1.0, 0.0, 7.0), ..cube(&kit, &LEVEL, 9) };
    let fog = Volume::new(aside, table(&kit, 255), 9.0);
    assert!(draw(&scene.with_volume(&fog)) == draw(&scene));
    let before = Volume { grid: Grid { low: kit.v(-1.0, 0.0, 2.0), ..aside }, ..fog };
    let veiled = draw(&scene.with_volume(&before));
    assert!(veiled.iter().zip(draw(&scene)).filter(|(a, b)| *a != b).count() > 200);
}

#[test]
fn a_volume_is_seen_where_there_is_nothing_else_before_a_sky_of_one_colour() {
    let kit = Kit(|x| x as f32, f64::from);
    let fog = Volume::new(cube(&kit, &LEVEL, 9), table(&kit, 255), 9.0);
    let sky = Rgb::new(0.2, 0.3, 0.9);
    let scene: Scene = Scene::new(&[], &[], &[]).with_ambient(Rgb::WHITE).with_sky(Sky::Solid(sky));
    let scene = scene.with_volume(&fog);
    let camera = Camera::perspective(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 60.0);
    let seen = film(&scene, &camera, [9, 9], Settings::new(), &mut ());
    assert_eq!(seen[0], sky);
    assert_near(colors(&kit, seen[40]), [0.8, 0.4, 0.1], 0.01);
}

#[test]
fn exposure_is_of_all_light() {
    let view = &gallery::float::PHANTOM;
    let draw = |exposure: f32| {
        film(&view.scene, &view.camera, [40, 40], view.settings.with_exposure(exposure), &mut ())
    };
    for (twice, once) in draw(2.0).iter().zip(draw(1.0)) {
        assert!((twice.r - 2.0 * once.r).abs() < 1e-5, "{twice:?}, {once:?}");
    }
}

#[test]
fn what_is_wrong_with_a_volume_is_named() {
    let kit = Kit(|x| x as f32, f64::from);
    let good = Volume::new(cube(&kit, &LEVEL, 9), table(&kit, 255), 9.0);
    let check = |volume: Volume| Scene::<f32>::new(&[], &[], &[]).with_volume(&volume).check();
    let faulty = |fault| Err(SceneError::Volume(fault));
    assert_eq!(check(good), Ok(()));
    assert_eq!(check(Volume { classes: &[], ..good }), faulty(Fault::Classes));
    assert_eq!(check(Volume { density: -1.0, ..good }), faulty(Fault::OutOfRange));
    assert_eq!(check(good.with_faintest(1.5)), faulty(Fault::OutOfRange));
    assert_eq!(check(good.with_samples(0)), faulty(Fault::Samples));
    let grid = cube(&kit, &LEVEL, 8);
    assert_eq!(check(Volume { grid, ..good }), faulty(Fault::Voxels));
}
