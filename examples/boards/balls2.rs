//! The scene `balls2`, made of `balls2.nff` by `scanray bake`.
//!
//! It is a module of any program that depends on `scanray`: `Renderer::new` takes its `SCENE`, `CAMERA`
//! and `SETTINGS`.
//!
//! - number: fixed
//! - holds: 92 objects
//!
//! | data | bytes of flash |
//! |---|--:|
//! | hierarchies | 2166 |
//! | outlines | 48 |
//! | objects | 5888 |
//! | materials | 288 |
//! | lights | 144 |
//! | all | 8534 |
//!
//! Meshes, objects and materials hold addresses: they are counted with 64 bits each,
//! and are smaller on a device.

#![allow(clippy::approx_constant, clippy::unreadable_literal, reason = "these numbers are data")]

use scanray::*;

/// Is what there is to see.
#[rustfmt::skip]
pub static SCENE: Scene<'static, Fixed> = Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
    .with_ambient(Rgb::from_f64(0.0, 0.0, 0.0))
    .with_sky(Sky::Solid(Rgb::from_f64(0.078, 0.361, 0.753)))
    .with_hierarchy(&TREE);

/// Is where it is seen from.
#[rustfmt::skip]
pub const CAMERA: Camera<Fixed> = Camera {
    eye: Vec3::from_f64(67.2, 41.6, 54.4),
    center: Vec3::from_f64(0.0, 0.0, 0.0),
    up: Vec3::from_f64(0.0, 0.0, 1.0),
    projection: Projection::Perspective { fovy: Fixed::new(45.079262) },
    near: Fixed::new(0.32),
    far: Scalar::FAR,
};

/// Is how the picture is made.
#[rustfmt::skip]
pub const SETTINGS: Settings<Fixed> = Settings::new().with_depth(4).with_exposure(Fixed::new(1.0))
    .with_transfer(Transfer::Linear).with_dither(Dither::Ordered);

/// Is the columns and rows of the usual picture.
#[rustfmt::skip]
pub const SIZE: [u32; 2] = [512, 512];

#[rustfmt::skip]
static OBJECTS: [Object<Fixed>; 92] = [
    Object::new(Shape::Polygon(Polygon::new(&OUTLINE_0, Vec3::from_f64(0.0, 0.0, 1.0), FillRule::OddEven)), 0),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(0.0, 0.0, 0.0), Fixed::new(16.0))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(8.709312, 8.709312, 17.418592), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(13.450048, 13.450048, 19.78896), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(14.779008, 9.750688, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(9.750688, 14.779008, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(7.38032, 12.40864, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(3.680992, 13.7376, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(2.639584, 7.667904, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(12.40864, 7.38032, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(7.667904, 2.639584, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(13.7376, 3.680992, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(20.606432, 5.521472, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(25.683456, 9.007072, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(20.606432, 5.521472, -7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(19.012512, 11.470048, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(25.683456, 9.007072, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(19.012512, 11.470048, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(20.606432, 5.521472, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(27.277376, 3.058521, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(22.20032, -0.427088, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(22.20032, -0.427088, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(5.521472, 20.606432, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(9.007072, 25.683456, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(11.470048, 19.012512, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(5.521472, 20.606432, -7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(3.058521, 27.277376, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-0.427088, 22.20032, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-0.427088, 22.20032, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(9.007072, 25.683456, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(5.521472, 20.606432, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(11.470048, 19.012512, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-11.89712, 3.187824, 17.418592), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-12.595872, 7.056032, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-6.119904, 5.3208, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-10.05664, 10.05664, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-18.373088, 4.92304, 19.78896), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-15.833856, 7.923648, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-17.674336, 1.054845, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-14.436352, 0.187229, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-13.7376, -3.680992, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-7.960384, -1.548003, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-15.08496, 15.08496, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-16.287456, 22.093632, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-10.730304, 19.439584, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-10.730304, 19.439584, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-20.642112, 17.739008, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-15.08496, 15.08496, -7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-19.439584, 10.730304, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-20.642112, 17.739008, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-19.439584, 10.730304, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-15.08496, 15.08496, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-20.606432, -5.521472, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-26.74608, -5.041376, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-20.606432, -5.521472, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-22.20032, 0.427088, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-26.74608, -5.041376, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-22.20032, 0.427088, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-20.606432, -5.521472, -7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-25.15216, -10.98992, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-19.012512, -11.470048, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-19.012512, -11.470048, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(3.187824, -11.89712, 17.418592), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(7.056032, -12.595872, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(10.05664, -10.05664, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(5.3208, -6.119904, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(0.187229, -14.436352, 23.344512), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-1.548003, -7.960384, 20.974144), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-3.680992, -13.7376, 17.418592), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(4.92304, -18.373088, 19.78896), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(1.054845, -17.674336, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(7.923648, -15.833856, 13.86304), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-5.521472, -20.606432, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-5.041376, -26.74608, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(0.427088, -22.20032, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-5.521472, -20.606432, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-10.98992, -25.15216, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-11.470048, -19.012512, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-11.470048, -19.012512, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-5.041376, -26.74608, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(-5.521472, -20.606432, -7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(0.427088, -22.20032, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(15.08496, -15.08496, 0.0), Fixed::new(5.333344))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(22.093632, -16.287456, 0.0), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(19.439584, -10.730304, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(19.439584, -10.730304, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(17.739008, -20.642112, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(15.08496, -15.08496, 7.111104), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(10.730304, -19.439584, 3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(17.739008, -20.642112, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(10.730304, -19.439584, -3.555552), Fixed::new(1.77778))), 1),
    Object::new(Shape::Sphere(Sphere::new(Vec3::from_f64(15.08496, -15.08496, -7.111104), Fixed::new(1.77778))), 1),
];

#[rustfmt::skip]
static MATERIALS: [Material<Fixed>; 2] = [
    Material::matte(Rgb::from_f64(0.8, 0.6, 0.264)),
    Material::matte(Rgb::from_f64(0.5, 0.45, 0.35))
        .with_specular(Rgb::from_f64(0.5, 0.5, 0.5), 3)
        .with_mirror(Fixed::new(0.5)),
];

#[rustfmt::skip]
static LIGHTS: [Light<Fixed>; 3] = [
    Light::point(Vec3::from_f64(128.0, 96.0, 64.0), Rgb::from_f64(0.577351, 0.577351, 0.577351)),
    Light::point(Vec3::from_f64(32.0, -128.0, 128.0), Rgb::from_f64(0.577351, 0.577351, 0.577351)),
    Light::point(Vec3::from_f64(-96.0, 32.0, 160.0), Rgb::from_f64(0.577351, 0.577351, 0.577351)),
];

#[rustfmt::skip]
static TREE: accel::Bvh<Fixed> = accel::Bvh {
    lattice: accel::Lattice::new(
        Vec3::from_f64(-384.047625, -384.047625, -379.486479),
        Fixed::new(768.095248),
    ),
    nodes: &TREE_NODES,
    count: 92,
    items: &TREE_ITEMS,
};

#[rustfmt::skip]
static TREE_NODES: [accel::BvhNode; 107] = [
    accel::BvhNode::new([[3, 3, 31012], [65533, 65533, 34524]], 1, 0, 0, 2),
    accel::BvhNode::new([[3, 3, 31012], [65533, 65533, 31015]], 0, 0, 1, 0),
    accel::BvhNode::new([[30333, 30333, 31012], [35249, 35249, 34524]], 3, 0, 0, 0),
    accel::BvhNode::new([[30333, 30333, 31012], [34135, 34815, 34524]], 5, 2, 0, 0),
    accel::BvhNode::new([[32583, 30721, 31619], [35249, 35249, 34524]], 57, 2, 0, 2),
    accel::BvhNode::new([[30333, 31636, 31619], [32209, 34806, 34524]], 7, 3, 0, 2),
    accel::BvhNode::new([[31401, 30333, 31012], [34135, 34815, 34524]], 33, 3, 0, 1),
    accel::BvhNode::new([[30333, 31636, 31619], [31937, 34806, 32835]], 9, 5, 0, 1),
    accel::BvhNode::new([[30857, 32144, 32832], [32209, 34208, 34524]], 23, 5, 0, 2),
    accel::BvhNode::new([[30333, 31636, 31619], [31466, 32958, 32835]], 11, 7, 0, 0),
    accel::BvhNode::new([[30854, 33530, 31619], [31937, 34806, 32835]], 19, 7, 0, 0),
    accel::BvhNode::new([[30333, 31677, 31922], [31027, 32958, 32835]], 13, 9, 0, 0),
    accel::BvhNode::new([[30553, 31636, 31619], [31466, 32753, 32835]], 17, 9, 0, 0),
    accel::BvhNode::new([[30333, 31677, 31922], [30775, 32491, 32835]], 15, 11, 0, 0),
    accel::BvhNode::new([[30721, 32651, 31922], [31027, 32958, 32835]], 4, 11, 2, 0),
    accel::BvhNode::new([[30333, 32185, 31922], [30639, 32491, 32835]], 1, 13, 2, 0),
    accel::BvhNode::new([[30469, 31677, 32226], [30775, 31984, 32532]], 3, 13, 1, 0),
    accel::BvhNode::new([[30553, 31840, 31619], [31466, 32753, 32835]], 6, 12, 2, 0),
    accel::BvhNode::new([[30993, 31636, 31922], [31299, 31943, 32835]], 8, 12, 2, 0),
    accel::BvhNode::new([[30854, 33530, 31922], [31263, 34435, 32835]], 21, 10, 0, 0),
    accel::BvhNode::new([[31024, 33599, 31619], [31937, 34806, 32835]], 14, 10, 3, 0),
    accel::BvhNode::new([[30854, 34128, 31922], [31160, 34435, 32835]], 10, 19, 2, 0),
    accel::BvhNode::new([[30956, 33530, 31922], [31263, 33837, 32835]], 12, 19, 2, 0),
    accel::BvhNode::new([[30857, 32144, 32832], [31634, 34208, 33139]], 25, 8, 0, 0),
    accel::BvhNode::new([[31047, 32301, 33408], [32209, 33597, 34524]], 27, 8, 0, 0),
    accel::BvhNode::new([[30857, 32144, 32832], [31163, 32450, 33139]], 17, 23, 1, 0),
    accel::BvhNode::new([[31328, 33902, 32832], [31634, 34208, 33139]], 18, 23, 1, 0),
    accel::BvhNode::new([[31047, 32705, 33408], [31570, 33597, 34220]], 29, 24, 0, 0),
    accel::BvhNode::new([[31296, 32301, 33408], [32209, 33523, 34524]], 31, 24, 0, 2),
    accel::BvhNode::new([[31047, 33035, 33914], [31354, 33341, 34220]], 19, 27, 1, 0),
    accel::BvhNode::new([[31107, 32705, 33408], [31570, 33597, 33715]], 20, 27, 2, 0),
    accel::BvhNode::new([[31296, 32301, 33408], [32209, 33497, 34322]], 22, 28, 2, 0),
    accel::BvhNode::new([[31383, 32631, 34217], [31847, 33523, 34524]], 24, 28, 2, 0),
    accel::BvhNode::new([[31636, 30333, 31619], [32937, 31749, 34524]], 35, 6, 0, 2),
    accel::BvhNode::new([[31401, 31401, 31012], [34135, 34815, 34322]], 45, 6, 0, 1),
    accel::BvhNode::new([[31636, 30333, 31619], [32753, 31466, 32835]], 37, 33, 0, 0),
    accel::BvhNode::new([[32144, 30857, 32832], [32937, 31749, 34524]], 43, 33, 0, 0),
    accel::BvhNode::new([[31636, 30469, 31922], [31984, 31299, 32835]], 39, 35, 0, 0),
    accel::BvhNode::new([[31840, 30333, 31619], [32753, 31466, 32835]], 41, 35, 0, 0),
    accel::BvhNode::new([[31636, 30993, 31922], [31943, 31299, 32835]], 26, 37, 2, 0),
    accel::BvhNode::new([[31677, 30469, 32226], [31984, 30775, 32532]], 28, 37, 1, 0),
    accel::BvhNode::new([[31840, 30553, 31619], [32753, 31466, 32835]], 29, 38, 2, 0),
    accel::BvhNode::new([[32185, 30333, 31922], [32491, 30639, 32835]], 31, 38, 2, 0),
    accel::BvhNode::new([[32144, 30857, 32832], [32450, 31163, 33139]], 33, 36, 1, 0),
    accel::BvhNode::new([[32301, 31383, 33712], [32937, 31749, 34524]], 34, 36, 2, 0),
    accel::BvhNode::new([[31401, 31401, 31012], [34135, 34135, 34322]], 47, 34, 0, 0),
    accel::BvhNode::new([[31699, 33069, 31922], [32885, 34815, 34322]], 51, 34, 0, 1),
    accel::BvhNode::new([[31936, 31936, 34015], [32789, 32789, 34322]], 49, 45, 0, 0),
    accel::BvhNode::new([[31401, 31401, 31012], [34135, 34135, 33746]], 38, 45, 1, 0),
    accel::BvhNode::new([[31936, 32483, 34015], [32242, 32789, 34322]], 36, 47, 1, 0),
    accel::BvhNode::new([[32483, 31936, 34015], [32789, 32242, 34322]], 37, 47, 1, 0),
    accel::BvhNode::new([[31757, 33069, 33712], [32399, 33779, 34322]], 53, 46, 0, 0),
    accel::BvhNode::new([[31699, 34273, 31922], [32885, 34815, 32835]], 55, 46, 0, 0),
    accel::BvhNode::new([[31757, 33473, 33712], [32063, 33779, 34018]], 39, 51, 1, 0),
    accel::BvhNode::new([[32093, 33069, 34015], [32399, 33375, 34322]], 40, 51, 1, 0),
    accel::BvhNode::new([[31699, 34273, 31922], [32006, 34580, 32835]], 41, 52, 2, 0),
    accel::BvhNode::new([[32578, 34509, 31922], [32885, 34815, 32835]], 43, 52, 2, 0),
    accel::BvhNode::new([[32651, 30721, 31619], [35249, 35249, 33139]], 59, 4, 0, 1),
    accel::BvhNode::new([[32583, 31047, 33408], [34182, 34182, 34524]], 89, 4, 0, 1),
    accel::BvhNode::new([[32651, 30721, 31619], [34806, 32006, 33139]], 61, 57, 0, 1),
    accel::BvhNode::new([[32783, 32578, 31619], [35249, 35249, 33139]], 73, 57, 0, 0),
    accel::BvhNode::new([[32651, 30721, 31922], [34435, 31263, 32835]], 63, 59, 0, 0),
    accel::BvhNode::new([[33599, 31024, 31619], [34806, 32006, 33139]], 67, 59, 0, 0),
    accel::BvhNode::new([[32651, 30721, 31922], [32958, 31027, 32835]], 45, 61, 2, 0),
    accel::BvhNode::new([[33530, 30854, 31922], [34435, 31263, 32835]], 65, 61, 0, 0),
    accel::BvhNode::new([[33530, 30956, 31922], [33837, 31263, 32835]], 47, 64, 2, 0),
    accel::BvhNode::new([[34128, 30854, 31922], [34435, 31160, 32835]], 49, 64, 2, 0),
    accel::BvhNode::new([[33599, 31024, 31619], [34512, 31937, 33139]], 69, 62, 0, 0),
    accel::BvhNode::new([[34273, 31225, 31922], [34806, 32006, 32835]], 71, 62, 0, 0),
    accel::BvhNode::new([[33599, 31024, 31922], [34512, 31937, 32835]], 51, 67, 1, 0),
    accel::BvhNode::new([[33902, 31328, 31619], [34208, 31634, 33139]], 52, 67, 2, 0),
    accel::BvhNode::new([[34273, 31699, 31922], [34580, 32006, 32835]], 54, 68, 2, 0),
    accel::BvhNode::new([[34500, 31225, 32226], [34806, 31532, 32532]], 56, 68, 1, 0),
    accel::BvhNode::new([[32783, 34070, 31619], [33900, 35249, 33139]], 75, 60, 0, 0),
    accel::BvhNode::new([[34070, 32578, 31619], [35249, 33900, 33139]], 79, 60, 0, 0),
    accel::BvhNode::new([[32783, 34070, 31619], [33696, 35249, 33139]], 57, 73, 4, 0),
    accel::BvhNode::new([[33383, 34237, 31922], [33900, 35113, 32835]], 77, 73, 0, 0),
    accel::BvhNode::new([[33383, 34806, 31922], [33690, 35113, 32835]], 61, 76, 2, 0),
    accel::BvhNode::new([[33593, 34237, 31922], [33900, 34543, 32835]], 63, 76, 2, 0),
    accel::BvhNode::new([[34070, 32783, 31619], [34983, 33900, 33139]], 81, 74, 0, 0),
    accel::BvhNode::new([[34509, 32578, 31922], [35249, 33690, 32835]], 85, 74, 0, 0),
    accel::BvhNode::new([[34237, 33593, 31922], [34543, 33900, 32835]], 65, 79, 2, 0),
    accel::BvhNode::new([[34070, 32783, 31619], [34983, 33696, 33139]], 83, 79, 0, 1),
    accel::BvhNode::new([[34070, 32783, 31922], [34983, 33696, 32835]], 67, 82, 1, 0),
    accel::BvhNode::new([[34373, 33086, 31619], [34679, 33392, 33139]], 68, 82, 2, 0),
    accel::BvhNode::new([[34509, 32578, 31922], [34815, 32885, 32835]], 70, 80, 2, 0),
    accel::BvhNode::new([[34806, 32876, 31922], [35249, 33690, 32835]], 87, 80, 0, 0),
    accel::BvhNode::new([[34806, 33383, 31922], [35113, 33690, 32835]], 72, 86, 2, 0),
    accel::BvhNode::new([[34942, 32876, 32226], [35249, 33182, 32532]], 74, 86, 1, 0),
    accel::BvhNode::new([[32583, 31047, 33408], [33779, 32399, 34524]], 91, 58, 0, 2),
    accel::BvhNode::new([[32840, 32840, 33408], [34182, 34182, 34524]], 97, 58, 0, 2),
    accel::BvhNode::new([[32583, 31107, 33408], [33779, 32209, 34322]], 93, 89, 0, 1),
    accel::BvhNode::new([[33035, 31047, 33914], [33523, 32399, 34524]], 95, 89, 0, 0),
    accel::BvhNode::new([[32705, 31107, 33408], [33597, 31570, 33715]], 75, 91, 2, 0),
    accel::BvhNode::new([[32583, 31296, 33408], [33779, 32209, 34322]], 77, 91, 2, 0),
    accel::BvhNode::new([[33035, 31047, 33914], [33341, 31354, 34220]], 79, 92, 1, 0),
    accel::BvhNode::new([[33069, 31540, 34015], [33523, 32399, 34524]], 80, 92, 2, 0),
    accel::BvhNode::new([[32929, 32929, 33408], [34182, 34182, 34322]], 99, 90, 0, 0),
    accel::BvhNode::new([[32840, 32840, 34015], [33980, 33980, 34524]], 105, 90, 0, 2),
    accel::BvhNode::new([[32929, 33055, 33408], [33968, 34182, 34322]], 101, 97, 0, 1),
    accel::BvhNode::new([[33762, 32929, 33408], [34182, 34069, 34220]], 103, 97, 0, 0),
    accel::BvhNode::new([[33055, 33055, 33408], [33968, 33968, 34322]], 82, 99, 1, 0),
    accel::BvhNode::new([[32929, 33787, 33408], [33753, 34182, 34018]], 83, 99, 2, 0),
    accel::BvhNode::new([[33762, 33762, 33914], [34069, 34069, 34220]], 85, 100, 1, 0),
    accel::BvhNode::new([[33787, 32929, 33408], [34182, 33753, 34018]], 86, 100, 2, 0),
    accel::BvhNode::new([[32840, 32840, 34015], [33575, 33575, 34322]], 88, 98, 2, 0),
    accel::BvhNode::new([[33244, 33244, 34217], [33980, 33980, 34524]], 90, 98, 2, 0),
];

#[rustfmt::skip]
static TREE_ITEMS: [u16; 92] = [
    0, 56, 53, 59, 57, 55, 58, 52, 60, 61, 46, 49, 48, 50, 43, 47, 42, 54, 51, 36, 38, 37, 40, 32, 39, 33, 78,
    77, 76, 80, 72, 79, 73, 75, 68, 66, 41, 67, 1, 35, 34, 45, 44, 27, 28, 81, 74, 90, 88, 89, 86, 82, 91, 87,
    84, 85, 83, 26, 22, 25, 30, 23, 29, 24, 31, 15, 17, 12, 14, 18, 21, 20, 13, 16, 19, 70, 71, 62, 64, 69,
    65, 63, 2, 7, 5, 3, 11, 4, 10, 8, 9, 6,
];

#[rustfmt::skip]
static OUTLINE_0: [Vec3<Fixed>; 4] = [
    Vec3::from_f64(384.0, 384.0, -16.0), Vec3::from_f64(-384.0, 384.0, -16.0),
    Vec3::from_f64(-384.0, -384.0, -16.0), Vec3::from_f64(384.0, -384.0, -16.0),
];
