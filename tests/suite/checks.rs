//! Wrong scenes and cameras are refused by name and fault, before anything is drawn.

use crate::support::{LIGHTS, MATERIALS, OBJECTS, ball, camera, scene, v};
use embedded_graphics::pixelcolor::Gray8;
use embedded_graphics::prelude::Size;
use scanray::{
    Bitmap, Bump, Camera, CameraError, Checker, Cone, Cube, Cuboid, Displaced, Fault, FillRule, Fixed, Full,
    Image, Intersect, Light, Material, Object, Plane, Polygon, Projection, Renderer, Rgb, Scene, SceneBuffer,
    SceneError, Settings, Shape, Sky, SmoothTriangle, Sphere, Texels, Texture, Triangle, Vec3, Vertex,
    Vertices, Workspace,
};

fn fault_of(shape: Shape) -> Option<Fault> {
    let objects = [OBJECTS[0], Object::new(shape, 0)];
    match (Scene { objects: &objects, ..scene() }).check() {
        Err(SceneError::Object(1, fault)) => Some(fault),
        Ok(()) => None,
        other => panic!("{other:?} names the wrong thing"),
    }
}

#[test]
fn a_good_scene_passes() {
    assert_eq!(scene().check(), Ok(()));
    assert_eq!(Scene::<f32>::new(&[], &[], &[]).check(), Ok(()));
}

#[test]
fn faults_of_shapes_are_told_apart() {
    let o = v(0.0, 0.0, 0.0);
    let sphere = |center, radius| fault_of(Shape::Sphere(Sphere::new(center, radius)));
    assert_eq!(sphere(o, 1.0), None);
    assert_eq!(sphere(o, 0.0), Some(Fault::RadiusNotPositive));
    assert_eq!(sphere(o, -1.0), Some(Fault::RadiusNotPositive));
    assert_eq!(sphere(o, f32::NAN), Some(Fault::OutOfRange));
    assert_eq!(sphere(v(0.0, f32::INFINITY, 0.0), 1.0), Some(Fault::OutOfRange));
    assert_eq!(sphere(v(0.0, 0.0, 1e17), 1.0), Some(Fault::OutOfRange));
    let triangle = |b, c| fault_of(Shape::Triangle(Triangle::new(o, b, c)));
    assert_eq!(triangle(v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0)), None);
    assert_eq!(triangle(o, v(0.0, 1.0, 0.0)), Some(Fault::Degenerate));
    assert_eq!(triangle(v(1.0, 2.0, 3.0), v(2.0, 4.0, 6.0)), Some(Fault::Degenerate));
    let off_the_axes = Triangle::new(v(0.1, 0.2, 0.35), v(0.2, 0.4, 0.7), v(0.41, 0.82, 1.435));
    assert_eq!(fault_of(Shape::Triangle(off_the_axes)), Some(Fault::Degenerate));
    assert_eq!(triangle(v(1.0, f32::NAN, 3.0), v(2.0, 4.0, 6.0)), Some(Fault::OutOfRange));
    let plane = |normal| fault_of(Shape::Plane(Plane::new(o, normal)));
    assert_eq!(plane(v(0.0, 9.0, 0.0)), None);
    assert_eq!(plane(o), Some(Fault::NoDirection));
    let cuboid = |high| fault_of(Shape::Cuboid(Cuboid::new(o, high)));
    assert_eq!(cuboid(v(1.0, 1.0, 0.0)), None);
    assert_eq!(cuboid(v(1.0, -1.0, 1.0)), Some(Fault::CornersSwapped));
    assert_eq!(cuboid(v(1.0, 0.0, 0.0)), Some(Fault::Degenerate));
    assert_eq!(cuboid(v(f32::NAN, 1.0, 1.0)), Some(Fault::OutOfRange));
}

#[test]
fn faults_of_polygons_are_told_apart() {
    let fault = |vertices: &[Vec3], normal| {
        let vertices = vertices.to_vec().leak();
        fault_of(Shape::Polygon(Polygon::new(vertices, normal, FillRule::Winding)))
    };
    let up = v(0.0, 2.0, 0.0);
    let square = [v(0.0, 1.0, 0.0), v(2.0, 1.0, 0.0), v(2.0, 1.0, 2.0), v(0.0, 1.0, 2.0)];
    assert_eq!(fault(&square, up), None);
    assert_eq!(fault(&square[..2], up), Some(Fault::TooFewCorners));
    assert_eq!(fault(&[], up), Some(Fault::TooFewCorners));
    assert_eq!(fault(&square, v(0.0, 0.0, 0.0)), Some(Fault::NoDirection));
    assert_eq!(fault(&square, v(0.0, f32::NAN, 0.0)), Some(Fault::OutOfRange));
    assert_eq!(fault(&square, v(0.0, 1.0, 0.01)), Some(Fault::NotFlat));
    let bent = |height| [square[0], square[1], square[2], v(0.0, height, 2.0)];
    assert_eq!(fault(&bent(1.001), up), None, "within 1/1024 of 2");
    assert_eq!(fault(&bent(1.003), up), Some(Fault::NotFlat));
    assert_eq!(fault(&bent(f32::INFINITY), up), Some(Fault::OutOfRange));
    let line = [square[0], square[1], square[0], square[1]];
    assert_eq!(fault(&line, up), Some(Fault::Degenerate));
}

#[test]
fn faults_of_cones_are_told_apart() {
    let (o, top) = (v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0));
    let fault = |radii: [f32; 2], apex| fault_of(Shape::Cone(Cone::new(o, radii[0], apex, radii[1])));
    assert_eq!(fault([1.0, 0.0], top), None);
    assert_eq!(fault([0.0, 1.0], top), None);
    assert_eq!(fault([0.0, 0.0], top), Some(Fault::RadiusNotPositive));
    assert_eq!(fault([-1.0, 1.0], top), Some(Fault::RadiusNotPositive));
    assert_eq!(fault([1.0, f32::NAN], top), Some(Fault::OutOfRange));
    assert_eq!(fault([1.0, 1.0], v(0.0, 1e17, 0.0)), Some(Fault::OutOfRange));
    assert_eq!(fault([1.0, 1.0], o), Some(Fault::NoDirection));
}

#[test]
fn faults_of_smooth_triangles_are_told_apart() {
    let up = v(0.0, 0.0, 1.0);
    let fault = |last, normal| {
        let vertex = |point, normal| Vertex::new(point, normal, [0.0, 0.0]);
        let corners = [vertex(v(0.0, 0.0, 0.0), up), vertex(v(1.0, 0.0, 0.0), up), vertex(last, normal)];
        fault_of(Shape::SmoothTriangle(SmoothTriangle::new(Box::leak(Box::new(corners)))))
    };
    let last = v(0.0, 1.0, 0.0);
    assert_eq!(fault(last, v(0.6, 0.0, 0.8)), None);
    assert_eq!(fault(last, v(0.0, 0.0, 2.0)), Some(Fault::NoDirection));
    assert_eq!(fault(last, v(0.0, 0.0, -1.0)), Some(Fault::NormalInward));
    assert_eq!(fault(last, v(f32::NAN, 0.0, 0.8)), Some(Fault::OutOfRange));
    assert_eq!(fault(v(2.0, 0.0, 0.0), up), Some(Fault::Degenerate));
}

#[test]
fn a_material_that_is_not_there_is_named() {
    let objects = [ball(0.0, 0.0, 0.0, 1.0, 3)];
    let error = Scene { objects: &objects, ..scene() }.check().unwrap_err();
    assert_eq!(error, SceneError::Object(0, Fault::NoSuchMaterial(3)));
    assert_eq!(error.to_string(), "object 0: it names material 3, which is not in the list");
}

#[test]
fn faults_of_materials_lights_sky_and_ambient_light_are_named() {
    let nan = Rgb::gray(f32::NAN);
    let check = |scene: Scene<'_>| scene.check().unwrap_err();
    for bad in [
        Material::matte(nan),
        Material::matte(Rgb::gray(-0.1)),
        Material::matte(Rgb::gray(1e15)),
        Material::matte(Rgb::BLACK).with_specular(nan, 5),
        Material::matte(Rgb::BLACK).with_ambient(f32::INFINITY),
        Material::matte(Rgb::BLACK).with_ambient(-0.1),
        Material::matte(Rgb::BLACK).with_ambient(1025.0),
        Material::textured(Texture::Checker(Checker::new(Rgb::BLACK, nan, 1.0))),
        Material::textured(Texture::Vertices(Vertices::new(Rgb::BLACK, Rgb::WHITE, nan))),
    ] {
        let materials = [MATERIALS[0], MATERIALS[1], MATERIALS[2], bad];
        let error = check(Scene { materials: &materials, ..scene() });
        assert_eq!(error, SceneError::Material(3, Fault::OutOfRange));
    }
    for weight in [f32::NAN, -0.5, 1.5] {
        let materials = [Material::matte(Rgb::BLACK).with_mirror(weight), MATERIALS[1], MATERIALS[2]];
        let error = check(Scene { materials: &materials, ..scene() });
        assert_eq!(error, SceneError::Material(0, Fault::MirrorWeight), "{weight}");
    }
    let light = |light| check(Scene { lights: &[LIGHTS[0], light], ..scene() });
    let o = v(0.0, 0.0, 0.0);
    assert_eq!(light(Light::point(o, nan)), SceneError::Light(1, Fault::OutOfRange));
    assert_eq!(light(Light::directional(o, Rgb::WHITE)), SceneError::Light(1, Fault::NoDirection));
    let sky = |up| check(scene().with_sky(Sky::Gradient { up, nadir: Rgb::BLACK, zenith: Rgb::WHITE }));
    assert_eq!(sky(v(0.0, 2.0, 0.0)), SceneError::Sky(Fault::NoDirection));
    assert_eq!(check(scene().with_sky(Sky::Solid(nan))), SceneError::Sky(Fault::OutOfRange));
    assert_eq!(check(scene().with_ambient(nan)), SceneError::Ambient(Fault::OutOfRange));
}

/// Is an image of any size, without content.
struct Blank([u32; 2]);

impl Texels for Blank {
    fn size(&self) -> [u32; 2] {
        self.0
    }

    fn texel(&self, _: u32, _: u32) -> [u8; 3] {
        [0; 3]
    }
}

#[test]
fn images_without_texels_and_too_large_ones_are_refused_wherever_they_are() {
    static BLANKS: [Blank; 4] = [Blank([2048, 1]), Blank([2049, 1]), Blank([0, 5]), Blank([5, 0])];
    static FINE: [Bitmap; 6] = [Bitmap::new(&BLANKS[0]); 6];
    let [fine, bad @ ..] = [0, 1, 2, 3].map(|i| Image::new(Bitmap::new(&BLANKS[i])));
    let textured = |image| Material::textured(Texture::Image(image)).check();
    let bumpy = |image| Material::matte(Rgb::WHITE).with_bump(Bump::heights(image, 0.1)).check();
    let moved = |image, height| Displaced::new(Sphere::new(v(0.0, 0.0, 0.0), 1.0), image, height).check();
    assert_eq!((textured(fine), bumpy(fine), moved(fine, 0.1)), (Ok(()), Ok(()), Ok(())));
    for image in bad {
        assert_eq!([textured(image), bumpy(image), moved(image, 0.1)], [Err(Fault::ImageSize); 3]);
        let faces: &[Bitmap; 6] =
            Box::leak(Box::new([FINE[0], FINE[0], FINE[0], FINE[0], image.bitmap, FINE[0]]));
        let sky = scene().with_sky(Sky::Cube(Cube::new(faces)));
        assert_eq!(sky.check(), Err(SceneError::Sky(Fault::ImageSize)));
    }
    assert_eq!(scene().with_sky(Sky::Cube(Cube::new(&FINE))).check(), Ok(()));
    assert_eq!(textured(fine.with_tiles(f32::NAN, 1.0)), Err(Fault::OutOfRange));
    assert_eq!(moved(fine, -0.1), Err(Fault::OutOfRange));
}

#[test]
fn what_fixed_point_cannot_hold_is_refused_not_bent() {
    let far = Sphere::new(Vec3::new(Fixed::new(1500.0), Fixed::new(0.0), Fixed::new(0.0)), Fixed::new(1.0));
    let objects = [Object::new(Shape::Sphere(far), 0)];
    let materials = [Material::matte(Rgb::WHITE)];
    let scene = Scene::<Fixed>::new(&objects, &materials, &[]);
    assert_eq!(scene.check(), Err(SceneError::Object(0, Fault::OutOfRange)));
    // A constant beyond the range saturates to the very end, which is refused as well.
    assert_eq!(Fixed::new(1e9), Fixed::MAX);
}

#[test]
fn cameras_that_see_nothing_are_refused() {
    let frame = |camera: Camera| camera.frame(40, 30).err();
    let good = camera();
    assert_eq!(frame(good), None);
    assert_eq!(frame(Camera { center: good.eye, ..good }), Some(CameraError::NoDirection));
    assert_eq!(frame(Camera { up: good.eye - good.center, ..good }), Some(CameraError::NoDirection));
    let along = Camera::perspective(v(0.1, 0.2, 0.35), v(0.3, 0.6, 1.05), v(0.1, 0.2, 0.35), 45.0);
    assert_eq!(frame(along), Some(CameraError::NoDirection));
    assert_eq!(frame(Camera { eye: v(f32::NAN, 0.0, 0.0), ..good }), Some(CameraError::OutOfRange));
    for fovy in [0.0, -10.0, 180.0] {
        let projection = Projection::Perspective { fovy };
        assert_eq!(frame(Camera { projection, ..good }), Some(CameraError::NoWindow), "{fovy} degrees");
    }
    let projection = Projection::Frustum { left: -1.0, right: 1.0, bottom: 1.0, top: 1.0 };
    assert_eq!(frame(Camera { projection, near: 1.0, ..good }), Some(CameraError::NoWindow));
    assert_eq!(frame(Camera { projection, near: 0.0, ..good }), Some(CameraError::NoDepth));
    assert_eq!(frame(good.with_clip(-1.0, 5.0)), Some(CameraError::NoDepth));
    assert_eq!(frame(good.with_clip(5.0, 5.0)), Some(CameraError::NoDepth));
    for (columns, rows) in [(0, 30), (40, 0), (40_000, 30)] {
        assert_eq!(good.frame(columns, rows).err(), Some(CameraError::BadSize));
    }
}

#[test]
fn a_window_that_fixed_point_cannot_hold_is_refused() {
    let o = Vec3::from_f64(0.0, 0.0, 0.0);
    let (ahead, up) = (Vec3::from_f64(0.0, 0.0, -1.0), Vec3::from_f64(0.0, 1.0, 0.0));
    let [one, far] = [Fixed::new(1.0), Fixed::new(100.0)];
    let close = Camera::frustum([o, ahead, up], [-one, one, -one, one], [Fixed::new(0.0002), far]);
    assert_eq!(close.frame(40, 30).err(), Some(CameraError::OutOfRange));
    let wide = Camera::orthographic(o, ahead, up, Fixed::new(1000.0));
    assert_eq!(wide.frame(50, 10).err(), Some(CameraError::OutOfRange));
    assert_eq!(wide.frame(10, 10).err(), None);
}

#[test]
fn as_many_objects_as_can_be_named_are_drawn_and_one_more_is_refused() {
    // All but one behind the eye.
    let mut crowd = vec![ball(0.0, 0.0, 50.0, 1.0, 0); 65_536];
    crowd[65_535] = ball(0.0, 0.0, -50.0, 1.0, 0);
    let materials = [Material::matte(Rgb::WHITE)];
    let lights = [Light::point(v(0.0, 9.0, 0.0), Rgb::WHITE)];
    let all = Scene::new(&crowd, &materials, &lights);
    assert_eq!(all.check(), Err(SceneError::Object(65_536, Fault::TooMany)));
    let scene = Scene { objects: &crowd[1..], ..all };
    let camera = Camera::perspective(v(0.0, 0.0, 0.0), v(0.0, 0.0, -1.0), v(0.0, 1.0, 0.0), 2.0);
    let mut workspace = Workspace::<f32, Gray8, 1, 0>::new();
    let settings = Settings::new().with_depth(0);
    let mut renderer = Renderer::new(&scene, &camera, Size::new(1, 1), settings, &mut workspace).unwrap();
    let mut light = Rgb::BLACK;
    renderer.trace_row(0, 0..1, &mut (), |_, color| light = color).unwrap();
    assert!(light.is_lit());
}

#[test]
fn a_full_buffer_says_so_and_keeps_what_it_has() {
    let mut buffer = SceneBuffer::<f32, 1, 1, 1>::new();
    assert_eq!(buffer.add_material(MATERIALS[0]), Ok(0));
    assert_eq!(buffer.add_material(MATERIALS[1]), Err(Full::Materials(1)));
    assert_eq!(buffer.add_object(OBJECTS[1].shape, 0), Ok(()));
    assert_eq!(buffer.add_object(OBJECTS[2].shape, 0), Err(Full::Objects(1)));
    assert_eq!(buffer.add_light(LIGHTS[0]), Ok(()));
    assert_eq!(buffer.add_light(LIGHTS[1]), Err(Full::Lights(1)));
    let kept = buffer.scene();
    assert_eq!((kept.objects.len(), kept.materials, kept.lights), (1, &MATERIALS[..1], &LIGHTS[..1]));
}
