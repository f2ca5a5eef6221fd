//! Rays that leave a surface: what an eye sees, a lamp at the eye lights.

use super::distances::body;
use crate::hostile::dice::Dice;
use embedded_graphics::prelude::Size;
use host_sim::scenes::HostNumber;
use scanray::trace::{Observer, RayKind};
use scanray::{Camera, Fixed, Light, Material, Object, Renderer, Rgb, Scene, Settings, Vec3, Workspace};

/// Is the side of a picture: 1024 rays.
const SIDE: u32 = 32;

/// Counts the places that are met and those that are lit.
#[derive(Default)]
struct Lit {
    met: usize,
    lit: usize,
}

impl Observer for Lit {
    fn ray(&mut self, _: RayKind) {}

    fn met(&mut self, _: u8, object: u16, _: u32) {
        self.met += usize::from(object == 0);
    }

    fn lit(&mut self, _: u8, _: u16) {
        self.lit += 1;
    }
}

/// Looks at one body of a size from somewhere around it.
fn look<S: HostNumber>(dice: &mut Dice) -> Lit {
    let size = 10_f64.powf(dice.share() * 4.0 - 2.0);
    let objects = [Object::new(body::<S>(dice, size), 0)];
    let around: [f64; 3] = std::array::from_fn(|_| 2.0 * dice.share() - 1.0);
    let length = around.iter().map(|x| x * x).sum::<f64>().sqrt();
    let eye = Vec3::from_array(around.map(|x| S::round(5.0 * size * x / length)));
    let materials = [Material::matte(Rgb::WHITE)];
    let lights = [Light::point(eye, Rgb::WHITE)];
    let scene = Scene::<S>::new(&objects, &materials, &lights);
    let up = Vec3::from_array([0.1, 1.0, 0.2].map(S::round));
    let camera = Camera::perspective(eye, Vec3::ZERO, up, S::round(20.0));
    let mut workspace = Workspace::<S, [u8; 2], 0, 0>::new();
    let settings = Settings::new().with_depth(0);
    let canvas = Size::new_equal(SIDE);
    let mut renderer =
        Renderer::new(&scene, &camera, canvas, settings, &mut workspace).expect("a sound scene");
    let mut lit = Lit::default();
    for y in 0..SIDE {
        renderer.trace_row(y, 0..SIDE, &mut lit, |_, _| ()).expect("there is such a row");
    }
    lit
}

/// Answers how many rays left a surface and how many of them met it again.
fn shaded<S: HostNumber>(name: &str, bodies: usize) -> [usize; 2] {
    let mut dice = Dice::of(9);
    let all: Vec<Lit> = (0..bodies).map(|_| look::<S>(&mut dice)).collect();
    let [met, lit] = [all.iter().map(|one| one.met).sum(), all.iter().map(|one| one.lit).sum::<usize>()];
    println!("{name}: {met} rays leave {bodies} bodies, {} meet them again", met - lit);
    [met, met - lit]
}

#[test]
fn no_surface_shades_itself_whatever_its_size() {
    for [met, shaded] in [shaded::<f32>("f32", 60), shaded::<Fixed>("fixed", 60)] {
        assert!(met > 10_000);
        assert_eq!(shaded, 0);
    }
}

#[test]
#[ignore = "a thousand bodies take a minute"]
fn no_ray_that_leaves_a_thousand_bodies_meets_them_again() {
    for [met, shaded] in [shaded::<f32>("f32", 1000), shaded::<Fixed>("fixed", 1000)] {
        assert!(met > 100_000);
        assert_eq!(shaded, 0);
    }
}
