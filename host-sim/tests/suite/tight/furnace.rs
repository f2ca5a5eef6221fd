//! White furnaces: in light that is the same from everywhere nothing can be seen that only passes light on.

use super::distances::body;
use crate::hostile::dice::Dice;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use host_sim::scenes::HostNumber;
use scanray::{
    Camera, Fixed, Fresnel, Glass, Material, Object, Renderer, Rgb, Scene, Settings, Sky, Vec3, Workspace,
};

const SIDE: u32 = 24;
const DEPTH: usize = 12;

/// Answers what hands on all light that it gets, or as much of its own as it does not hand on.
fn materials<S: HostNumber>() -> [Material<S>; 4] {
    let (half, gray) = (S::HALF, Rgb::gray(S::HALF));
    [
        Material::flat(Rgb::BLACK).with_mirror(S::ONE),
        Material::flat(gray).with_mirror(half),
        Material::matte(gray).with_mirror(half),
        Material::flat(Rgb::BLACK).with_glass(Glass::new(S::ONE, S::round(1.5)).with_fresnel(Fresnel::Exact)),
    ]
}

/// Answers the darkest level of a picture of one body.
fn darkest<S: HostNumber>(dice: &mut Dice, material: Material<S>) -> u8 {
    let mut shape = body::<S>(dice, 1.0);
    while material.glass.is_some() && !matches!(shape, scanray::Shape::Sphere(_)) {
        shape = body::<S>(dice, 1.0);
    }
    let (objects, materials) = ([Object::new(shape, 0)], [material]);
    let scene =
        Scene::<S>::new(&objects, &materials, &[]).with_sky(Sky::Solid(Rgb::WHITE)).with_ambient(Rgb::WHITE);
    let eye = Vec3::from_array([1.0, 2.0, 3.0].map(S::round));
    let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
    let camera = Camera::perspective(eye, Vec3::ZERO, up, S::round(40.0));
    let mut workspace = Workspace::<S, Rgb888, 0, DEPTH>::new();
    let settings = Settings::new().with_depth(DEPTH as u8).with_dither(scanray::Dither::None);
    let size = Size::new_equal(SIDE);
    let mut renderer = Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("a sound scene");
    let mut row = [Rgb888::BLACK; SIDE as usize];
    let mut darkest = u8::MAX;
    for y in 0..SIDE {
        renderer.render_row(y, &mut row).expect("there is such a row");
        darkest = row.iter().flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()]).fold(darkest, u8::min);
    }
    darkest
}

fn furnaces<S: HostNumber>(bodies: usize) {
    let mut dice = Dice::of(7);
    for _ in 0..bodies {
        for material in materials::<S>() {
            let darkest = darkest(&mut dice, material);
            assert!(darkest >= 254, "{darkest} of {material:?}");
        }
    }
}

#[test]
fn what_only_passes_light_on_cannot_be_seen_in_a_white_furnace() {
    furnaces::<f32>(40);
    furnaces::<Fixed>(40);
}
