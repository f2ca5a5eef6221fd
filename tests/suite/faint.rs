//! Light too faint to be seen is not traced, and none that can be seen is left out.

use crate::support::v;
use embedded_graphics::pixelcolor::{Gray4, Gray8, Rgb565, Rgb666, Rgb888};
use embedded_graphics::prelude::*;
use scanray::output::Quantizer;
use scanray::ray::Interval;
use scanray::trace::{Candidates, Packet, Pending, RayCounts, Tracer};
use scanray::{
    Camera, Cuboid, Dither, Encode, Light, Material, Object, Renderer, Rgb, Scene, Settings, Shape, Sky,
    Transfer, Workspace,
};

const SIZE: u32 = 48;
const DEPTH: u8 = 12;

/// Is a corridor of two facing mirrors of which each gives back `mirror` of the light.
fn between_mirrors<T>(mirror: f32, look: impl FnOnce(&Scene<'_>, &Camera) -> T) -> T {
    let slab = |low, high| Object::new(Shape::Cuboid(Cuboid::new(low, high)), 0);
    let objects = [
        slab(v(-3.0, -2.0, -5.0), v(-1.0, 2.0, 5.0)),
        slab(v(1.0, -2.0, -5.0), v(3.0, 2.0, 5.0)),
        slab(v(-3.0, -3.0, -5.0), v(3.0, -1.0, 5.0)),
    ];
    let materials = [Material::matte(Rgb::new(0.6, 0.5, 0.4)).with_mirror(mirror)];
    let lights = [Light::point(v(0.2, 1.5, 1.0), Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &lights).with_sky(Sky::Solid(Rgb::gray(0.3)));
    look(&scene, &Camera::perspective(v(0.0, 0.0, 4.5), v(0.3, -0.2, 0.0), v(0.0, 1.0, 0.0), 60.0))
}

/// Traces every ray to its end, or to a number of levels.
fn whole(scene: &Scene<'_>, camera: &Camera, depth: u8) -> (Vec<Rgb>, RayCounts) {
    let frame = camera.frame(SIZE, SIZE).expect("a good camera");
    let mut pending = [Pending::NONE; DEPTH as usize];
    let mut tracer = Tracer::new(scene, &mut pending[..usize::from(depth)]);
    let mut counts = RayCounts::default();
    let mut light = Vec::new();
    for y in 0..SIZE {
        for found in frame.row(y, 0).take(SIZE as usize) {
            let ray = std::iter::once((found.ray, found.interval));
            let mut packet = Packet::new();
            light.push(tracer.radiance(&mut packet, ray, Candidates::all(scene), &mut counts)[0]);
        }
    }
    (light, counts)
}

fn rendered(scene: &Scene<'_>, camera: &Camera) -> (Vec<Rgb>, RayCounts) {
    let mut workspace = Workspace::<f32, Rgb565, 0, 12>::new();
    let settings = Settings::new().with_depth(DEPTH);
    let size = Size::new(SIZE, SIZE);
    let mut renderer = Renderer::new(scene, camera, size, settings, &mut workspace).expect("a good scene");
    let mut counts = RayCounts::default();
    let mut light = Vec::new();
    for y in 0..SIZE {
        renderer.trace_row(y, 0..SIZE, &mut counts, |_, color| light.push(color)).expect("a row");
    }
    (light, counts)
}

/// Answers how many pixels a panel shows differently; no channel by more than one step.
fn differing<C: Encode + Into<[u8; 3]>>(one: &[Rgb], other: &[Rgb]) -> usize {
    let shown = |light: &Rgb, i: usize| {
        let (x, y) = (i as u32 % SIZE, i as u32 / SIZE);
        C::from_light(*light, Quantizer::new(Transfer::Srgb, Dither::Ordered, x, y)).into()
    };
    let pairs = one.iter().zip(other).enumerate().map(|(i, (a, b))| (shown(a, i), shown(b, i)));
    pairs
        .filter(|(a, b)| {
            assert!(a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= 1), "{a:?} and {b:?}");
            a != b
        })
        .count()
}

macro_rules! channels {
    ($name:ident, $color:ty, $pixel:ident => $channels:expr) => {
        #[derive(Clone, Copy)]
        struct $name($color);
        impl Encode for $name {
            const DARKEST: Self = Self(<$color as Encode>::DARKEST);
            const TOPS: [u8; 3] = <$color>::TOPS;
            fn levels(light: [u32; 3], transfer: Transfer) -> [u32; 3] {
                <$color>::levels(light, transfer)
            }
            fn by_thresholds(levels: [u32; 3], thresholds: [u32; 3]) -> Self {
                Self(<$color>::by_thresholds(levels, thresholds))
            }
        }
        impl From<$name> for [u8; 3] {
            fn from($name($pixel): $name) -> Self {
                $channels
            }
        }
    };
}

channels!(Eight, Rgb888, p => [p.r(), p.g(), p.b()]);
channels!(Six, Rgb666, p => [p.r(), p.g(), p.b()]);
channels!(Five, Rgb565, p => [p.r(), p.g(), p.b()]);
channels!(Grey, Gray8, p => [p.luma(); 3]);
channels!(Four, Gray4, p => [p.luma(); 3]);

#[test]
fn faint_reflections_are_left_out_and_no_panel_shows_it() {
    for mirror in [0.005, 0.01, 0.02] {
        between_mirrors(mirror, |scene, camera| {
            let ((light, traced), (all, needed)) = (rendered(scene, camera), whole(scene, camera, DEPTH));
            assert!(traced.reflection < needed.reflection, "{mirror}: {traced:?} of {needed:?}");
            let off = light.iter().zip(&all).map(|(a, b)| (a.r - b.r).abs().max((a.g - b.g).abs()));
            assert!(off.fold(0.0, f32::max) < 1.0 / 65_536.0);
            let pixels = (SIZE * SIZE) as usize;
            assert!(differing::<Eight>(&light, &all) <= pixels / 20);
            assert!(differing::<Six>(&light, &all) <= pixels / 80);
            assert!(differing::<Five>(&light, &all) <= pixels / 160);
            assert!(differing::<Grey>(&light, &all) <= pixels / 20);
            assert!(differing::<Four>(&light, &all) <= pixels / 340);
        });
    }
}

#[test]
fn reflections_that_can_be_seen_are_all_followed() {
    between_mirrors(0.9, |scene, camera| {
        let ((light, traced), (all, needed)) = (rendered(scene, camera), whole(scene, camera, DEPTH));
        assert_eq!(traced, needed);
        assert_eq!(light, all);
    });
}

#[test]
fn reflections_are_followed_as_long_as_they_bring_a_level_s_share_of_the_faintest_light() {
    // The third level brings 0.02^3 of 0.6, 4.8e-6, the fourth 9.6e-8; a thirteenth of 2^-16 is 1.2e-6.
    between_mirrors(0.02, |scene, camera| {
        let ((_, traced), (_, needed)) = (rendered(scene, camera), whole(scene, camera, 3));
        assert!(needed.reflection > whole(scene, camera, 2).1.reflection);
        assert_eq!(traced, needed);
    });
}

#[test]
fn a_ray_of_no_weight_is_not_sent() {
    between_mirrors(0.5, |scene, camera| {
        let frame = camera.frame(SIZE, SIZE).expect("a good camera");
        let row = frame.row(40, 10).map(|found| (found.ray, Interval::AHEAD));
        let mut counts = RayCounts::default();
        let mut pending = [Pending::NONE; DEPTH as usize];
        let mut dark = Tracer::new(scene, &mut pending).with_exposure(0.0);
        dark.radiance(&mut Packet::new(), row, Candidates::all(scene), &mut counts);
        assert_eq!((counts.primary, counts.reflection), (8, 0));
    });
}
