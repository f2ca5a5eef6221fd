//! What a program is built without is refused by name; what it is built with is drawn.

#[allow(dead_code, unused_imports, reason = "this program uses a part")]
#[path = "suite/support/mod.rs"]
mod support;

use embedded_graphics::image::ImageRaw;
use embedded_graphics::pixelcolor::Rgb888;
use scanray::{
    Bitmap, Bump, Class, Cone, Cube, Fault, Glass, Grid, Image, Isosurface, Light, Material, Model, Object,
    Rgb, Scene, SceneError, Shape, Sky, Sphere, Texture, Vec3, Volume, Voxels,
};
use support::v;

static GREY: ImageRaw<Rgb888> = ImageRaw::new(&[128; 3], 1);
const IMAGE: Image = Image::new(Bitmap::new(&GREY));
const BALL: Shape = Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0));

/// Checks a scene of one object against what this build ought to say of it.
fn assert_carried(
    feature: &'static str,
    carried: bool,
    shape: Shape,
    material: Material,
    of: fn(usize, Fault) -> SceneError,
) {
    let (objects, materials) = ([Object::new(shape, 0)], [material]);
    let lights: [Light; 0] = [];
    let said = Scene::new(&objects, &materials, &lights).check();
    let ought = if carried { Ok(()) } else { Err(of(0, Fault::LeftOut(feature))) };
    assert_eq!(said, ought, "{feature}");
}

#[test]
fn a_scene_that_needs_what_was_left_out_is_refused_by_the_name_of_the_feature() {
    let plain = Material::matte(Rgb::WHITE);
    let cone = Shape::Cone(Cone::new(Vec3::ZERO, 1.0, v(0.0, 1.0, 0.0), 0.0));
    assert_carried("shapes", cfg!(feature = "shapes"), cone, plain, SceneError::Object);
    let glass = Material::matte(Rgb::BLACK).with_glass(Glass::new(1.0, 1.5));
    assert_carried("glass", cfg!(feature = "glass"), BALL, glass, SceneError::Material);
    assert_carried(
        "images",
        cfg!(feature = "images"),
        BALL,
        Material::textured(Texture::Image(IMAGE)),
        SceneError::Material,
    );
    let bumpy = plain.with_bump(Bump::heights(IMAGE, 0.1));
    assert_carried("images", cfg!(feature = "images"), BALL, bumpy, SceneError::Material);
    let blinn = plain.with_model(Model::BlinnPhong);
    assert_carried("models", cfg!(feature = "models"), BALL, blinn, SceneError::Material);
}

/// Is one cell, from air to bone.
static CELL: Grid =
    Grid::new(Voxels::new([2; 3], &[0, 255, 0, 255, 0, 255, 0, 255]), Vec3::ZERO, Vec3::new(1.0, 1.0, 1.0));

#[test]
fn a_volume_and_a_surface_in_one_are_refused_by_the_name_of_theirs() {
    let carried = cfg!(feature = "volumes");
    let surface = Shape::Isosurface(Isosurface::new(&CELL, 127.0));
    assert_carried("volumes", carried, surface, Material::matte(Rgb::WHITE), SceneError::Object);
    let volume = Volume::new(CELL, &Class::TISSUES, 1.0);
    let said = Scene::<f32>::new(&[], &[], &[]).with_volume(&volume).check();
    let ought = if carried { Ok(()) } else { Err(SceneError::Volume(Fault::LeftOut("volumes"))) };
    assert_eq!(said, ought);
}

#[test]
fn a_sky_of_images_is_refused_where_images_were_left_out() {
    static FACES: [Bitmap; 6] = [Bitmap::new(&GREY); 6];
    let sky = Sky::Cube(Cube::new(&FACES));
    let ought =
        if cfg!(feature = "images") { Ok(()) } else { Err(SceneError::Sky(Fault::LeftOut("images"))) };
    let scene: Scene = Scene::new(&[], &[], &[]).with_sky(sky);
    assert_eq!(scene.check(), ought);
}

#[test]
fn a_scene_that_needs_nothing_of_it_is_taken_by_every_build() {
    assert_carried("", true, BALL, Material::matte(Rgb::WHITE).with_mirror(0.5), SceneError::Object);
}
