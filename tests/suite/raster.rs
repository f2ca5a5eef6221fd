//! The z-buffer sees what the tracer sees, in another way.

use crate::support::{is_a_row, panel_of, pixels};
use embedded_graphics::image::ImageRaw;
use embedded_graphics::pixelcolor::{Gray4, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::gallery::{Gallery, View};
use scanray::hit::{Crossing, Surface};
use scanray::output::{BLUE_NOISE, Quantizer};
use scanray::ray::{Interval, Ray};
use scanray::trace::{Observer, RayKind};
use scanray::{
    Bitmap, Bump, Camera, Checker, Cuboid, Dither, Encode, Fault, Fixed, Image, Intersect, Light, Material,
    Object, Plane, RasterRenderer, RasterWorkspace, RenderError, Renderer, Rgb, Rings, RowError, Scalar,
    Scene, SceneError, Settings, Shape, Sky, Sphere, Stripes, Texture, Triangle, Vec3, Workspace,
};

/// Is as wide as any picture of these tests.
const WIDTH: usize = 320;

/// Is what is seen in one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen<S> {
    object: u16,
    tile: u32,
    light: Rgb<S>,
    /// Whether a light that the surface faces is kept off.
    shadowed: bool,
}

/// Remembers what the last pixel met.
#[derive(Default)]
struct Watch {
    object: u16,
    tile: u32,
    asked: u32,
    lit: u32,
}

impl Observer for Watch {
    fn ray(&mut self, kind: RayKind) {
        self.asked += u32::from(kind == RayKind::Shadow);
    }

    fn met(&mut self, _: u8, object: u16, tile: u32) {
        (self.object, self.tile) = (object, tile);
    }

    fn lit(&mut self, _: u8, _: u16) {
        self.lit += 1;
    }
}

/// Traces a picture without mirrors, pixel by pixel.
fn traced<S: Scalar>(view: &View<S>) -> Vec<Seen<S>> {
    let [columns, rows] = view.size;
    let mut workspace = Workspace::<S, Rgb888, 0, 0>::new();
    let settings = view.settings.with_depth(0);
    let size = Size::new(columns, rows);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, settings, &mut workspace).unwrap();
    let mut pixel = |x, y| {
        let (mut watch, mut light) = (Watch::default(), Rgb::BLACK);
        renderer.trace_row(y, x..x + 1, &mut watch, |_, found| light = found).unwrap();
        Seen { object: watch.object, tile: watch.tile, light, shadowed: watch.asked > watch.lit }
    };
    (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect()
}

/// Remembers what each pixel of a row met.
#[derive(Default)]
struct Met(Vec<(u16, u32)>);

impl Observer for Met {
    fn ray(&mut self, _: RayKind) {
        panic!("a z-buffer sends no rays");
    }

    fn met(&mut self, _: u8, object: u16, tile: u32) {
        self.0.push((object, tile));
    }
}

fn rasterized<S: Scalar>(view: &View<S>) -> Result<Vec<Seen<S>>, RenderError> {
    let [columns, rows] = view.size;
    let mut workspace = RasterWorkspace::<S, WIDTH>::new();
    let size = Size::new(columns, rows);
    let mut renderer = RasterRenderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace)?;
    let mut seen = Vec::new();
    for y in 0..rows {
        let (mut met, mut light) = (Met::default(), Vec::new());
        renderer.shade_row(y, &mut met, |_, found| light.push(found)).unwrap();
        seen.extend(met.0.iter().zip(light).map(|((object, tile), light)| Seen {
            object: *object,
            tile: *tile,
            light,
            shadowed: false,
        }));
    }
    Ok(seen)
}

/// Answers the pixels around one, itself among them.
fn around([columns, rows]: [u32; 2], i: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (i as u32 % columns, i as u32 / columns);
    let near = |at: u32, end: u32| at.saturating_sub(1)..=(at + 1).min(end - 1);
    near(y, rows).flat_map(move |y| near(x, columns).map(move |x| (y * columns + x) as usize))
}

fn check_objects<S: Scalar>(view: &View<S>, traced: &[Seen<S>], rasterized: &[Seen<S>]) {
    let differ = |i: &usize| traced[*i].object != rasterized[*i].object;
    let wrong: Vec<usize> = (0..traced.len()).filter(differ).collect();
    println!("{}: {} of {} pixels differ", view.name, wrong.len(), traced.len());
    assert_eq!(traced.len(), rasterized.len());
    assert!(wrong.len() * 1000 <= traced.len(), "{}", view.name);
    for i in wrong {
        let object = rasterized[i].object;
        let beside = around(view.size, i).any(|near| traced[near].object == object);
        assert!(beside, "{}: pixel {i} shows object {object}, which is not seen beside it", view.name);
    }
}

fn check_light<S: Scalar>(view: &View<S>, traced: &[Seen<S>], rasterized: &[Seen<S>]) {
    let settings = view.settings.with_dither(Dither::None);
    let quantizer = Quantizer::new(settings.transfer, settings.dither, 0, 0);
    let levels = |light| {
        let color: Rgb888 = Encode::from_light(light, quantizer);
        [color.r(), color.g(), color.b()]
    };
    let mut worst = 0;
    let mut compared = 0;
    for (a, b) in traced.iter().zip(rasterized) {
        if (a.object, a.tile) == (b.object, b.tile) && !a.shadowed {
            let (a, b) = (levels(a.light), levels(b.light));
            let off = a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap();
            worst = worst.max(off);
            compared += 1;
        }
    }
    println!("{}: {compared} compared, worst {worst}/255", view.name);
    assert!(worst <= 2, "{}: {worst}/255", view.name);
    assert!(compared * 4 > traced.len(), "{}", view.name);
}

fn check<S: Gallery>() {
    for view in S::views() {
        match rasterized(view) {
            Ok(rasterized) => {
                let traced = traced(view);
                check_objects(view, &traced, &rasterized);
                check_light(view, &traced, &rasterized);
            }
            Err(RenderError::Scene(SceneError::Object(index, Fault::NotRasterized))) => {
                let known = |shape| {
                    matches!(
                        shape,
                        Shape::Sphere(_) | Shape::Plane(_) | Shape::Triangle(_) | Shape::Cuboid(_)
                    )
                };
                assert!(!known(view.scene.objects[index].shape), "{}: object {index}", view.name);
            }
            Err(RenderError::Scene(SceneError::Volume(Fault::NotRasterized))) => {}
            Err(error) => panic!("{}: {error}", view.name),
        }
    }
}

#[test]
fn the_gallery_has_the_tracers_silhouettes_and_light_in_f32() {
    check::<f32>();
}

#[test]
fn the_gallery_has_the_tracers_silhouettes_and_light_in_fixed_point() {
    check::<Fixed>();
}

#[test]
fn a_display_gets_the_rows_that_a_buffer_gets() {
    let mut workspace = RasterWorkspace::<f32, 64>::new();
    let size = Size::new(40, 30);
    let (scene, camera) = (crate::support::scene(), crate::support::camera());
    let mut renderer = RasterRenderer::new(&scene, &camera, size, Settings::new(), &mut workspace).unwrap();
    assert_eq!(renderer.size(), size);
    let mut display = panel_of::<Rgb888>(Rectangle::new(Point::new(3, 5), size)).only(is_a_row);
    renderer.draw(&mut display).unwrap();
    assert!(display.inner().inner().is_full());
    let mut row = [Rgb888::BLACK; 40];
    for (y, shown) in (0..).zip(pixels(&display).chunks(40)) {
        renderer.render_row(y, &mut row).unwrap();
        assert!(shown.iter().copied().eq(row.map(Some)), "row {y}");
    }
}

#[test]
fn rows_are_rounded_in_every_way_as_those_of_the_tracer() {
    let scene: Scene = Scene::new(&[], &[], &[]).with_sky(Sky::Solid(Rgb::gray(0.3)));
    let (camera, size) = (crate::support::camera(), Size::new(40, 30));
    for dither in [Dither::None, Dither::Ordered, Dither::Mask(&BLUE_NOISE), Dither::Diffused] {
        let settings = Settings::new().with_depth(0).with_dither(dither);
        let mut workspace = Workspace::<f32, Gray4, 40, 0>::new();
        let mut tracer = Renderer::new(&scene, &camera, size, settings, &mut workspace).unwrap();
        let mut workspace = RasterWorkspace::<f32, 40>::new();
        let mut raster = RasterRenderer::new(&scene, &camera, size, settings, &mut workspace).unwrap();
        let [mut traced, mut rasterized] = [[Gray4::BLACK; 40]; 2];
        for y in 0..30 {
            tracer.render_row(y, &mut traced).unwrap();
            raster.render_row(y, &mut rasterized).unwrap();
            assert_eq!(rasterized, traced, "{dither:?}, row {y}");
        }
    }
}

#[test]
fn rows_and_buffers_that_do_not_fit_are_refused() {
    let mut workspace = RasterWorkspace::<f32, 40>::new();
    let (scene, camera) = (crate::support::scene(), crate::support::camera());
    let settings = Settings::new();
    let wide = RasterRenderer::new(&scene, &camera, Size::new(41, 30), settings, &mut workspace);
    assert_eq!(wide.err(), Some(RenderError::RowTooWide { width: 41, room: 40 }));
    let dark = settings.with_exposure(-1.0);
    let dark = RasterRenderer::new(&scene, &camera, Size::new(40, 30), dark, &mut workspace);
    assert_eq!(dark.err(), Some(RenderError::Exposure));
    let mut renderer =
        RasterRenderer::new(&scene, &camera, Size::new(40, 30), settings, &mut workspace).unwrap();
    let mut row = [Rgb888::BLACK; 41];
    let long = renderer.render_row(0, &mut row);
    assert_eq!(long, Err(RowError::BufferLength { width: 40, length: 41 }));
    assert_eq!(renderer.render_row(30, &mut row[1..]), Err(RowError::NoSuchRow(30)));
}

/// Is a shape that nobody but the tracer can draw.
#[derive(Clone, Copy)]
struct Fog;

impl<S: Scalar> Intersect<S> for Fog {
    fn intersect(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        None
    }

    fn surface(&self, ray: &Ray<S>, _: &Crossing<S>) -> Surface<S> {
        Surface { point: ray.origin, normal: -ray.direction, u: S::ZERO, v: S::ZERO, part: 0 }
    }
}

#[test]
fn a_shape_that_is_not_known_is_named() {
    let ball = Shape::Sphere(Sphere::new(crate::support::v(0.0, 0.0, 0.0), 1.0));
    let objects = [Object::new(ball, 0), Object::new(Shape::Custom(Fog), 0)];
    let materials = [Material::matte(Rgb::WHITE)];
    let scene = Scene::new(&objects, &materials, &[]);
    let mut workspace = RasterWorkspace::<f32, 8>::new();
    let settings = Settings::new();
    let refused =
        RasterRenderer::new(&scene, &crate::support::camera(), Size::new(8, 8), settings, &mut workspace)
            .err();
    assert_eq!(refused, Some(RenderError::Scene(SceneError::Object(1, Fault::NotRasterized))));
    let says = refused.map(|error| error.to_string());
    assert_eq!(says.as_deref(), Some("object 1: the z-buffer has no way to draw it"));
}

#[test]
fn exposure_scales_the_light_as_it_does_for_the_tracer() {
    let view = scanray::gallery::double::Z_BUFFER;
    let light = |exposure| {
        let mut workspace = RasterWorkspace::<f64, WIDTH>::new();
        let (size, settings) = (Size::new(32, 24), view.settings.with_exposure(exposure));
        let mut renderer =
            RasterRenderer::new(&view.scene, &view.camera, size, settings, &mut workspace).unwrap();
        let mut light = Vec::new();
        renderer.shade_row(12, &mut (), |_, found| light.push(found)).unwrap();
        light
    };
    let twice: Vec<_> = light(1.0).into_iter().map(|light| light * 2.0).collect();
    assert_eq!(light(2.0), twice);
}

/// Is 3 x 2 colours; as heights they are hills.
static CARPET: ImageRaw<Rgb888> = ImageRaw::new(
    &[90, 10, 200, 150, 60, 250, 128, 228, 255, /* below */ 30, 200, 180, 255, 130, 160, 100, 90, 230],
    3,
);

#[test]
fn textures_and_bumps_are_those_of_the_tracer() {
    let image = Image::new(Bitmap::new(&CARPET)).with_tiles(6.0, 3.0);
    let (red, blue) = (Rgb::new(0.9, 0.2, 0.1), Rgb::new(0.1, 0.3, 0.8));
    // The lists of a view are never freed.
    let materials = Box::leak(Box::new(
        [
            Texture::Image(image),
            Texture::Checker(Checker::new(red, blue, 5.0)),
            Texture::Stripes(Stripes::new(red, blue, [3.0, 4.0])),
            Texture::Rings(Rings::new(red, blue, [0.5, 1.0], 2.0)),
        ]
        .map(|texture| {
            Material::textured(texture).with_specular(Rgb::gray(0.5), 9).with_bump(Bump::heights(image, 0.05))
        }),
    ));
    let v = Vec3::<f64>::new;
    let objects = Box::leak(Box::new([
        Object::new(Shape::Sphere(Sphere::new(v(-1.5, 0.9, 0.0), 0.9)), 0),
        Object::new(Shape::Cuboid(Cuboid::new(v(0.6, -0.2, -0.5), v(2.0, 1.3, 0.7))), 1),
        Object::new(
            Shape::Triangle(Triangle::new(v(-2.0, -0.5, 2.0), v(0.5, -0.5, 1.5), v(-1.0, 0.7, 1.0))),
            2,
        ),
        Object::new(Shape::Plane(Plane::new(v(0.0, -0.6, 0.0), v(0.1, 1.0, 0.2))), 3),
    ]));
    // A light at the eye: nothing that is seen is in shadow.
    let eye = v(0.5, 2.0, 6.0);
    let lights = Box::leak(Box::new([Light::point(eye, Rgb::WHITE)]));
    let view = View {
        name: "carpets",
        about: "a scene of this test",
        scene: Scene::new(objects, materials, lights).with_ambient(Rgb::gray(0.1)),
        camera: Camera::perspective(eye, Vec3::ZERO, v(0.0, 1.0, 0.0), 45.0),
        settings: Settings::new(),
        size: [80, 60],
    };
    let (traced, rasterized) = (traced(&view), rasterized(&view).unwrap());
    let (mut compared, mut same) = ([0; 4], 0);
    for (a, b) in traced.iter().zip(&rasterized).filter(|(a, b)| a.object < 4 && a.object == b.object) {
        let off = [a.light.r - b.light.r, a.light.g - b.light.g, a.light.b - b.light.b].map(f64::abs);
        same += 1;
        if a.tile == b.tile {
            assert!(off.iter().all(|off| *off < 1e-9), "object {}: off by {off:?}", a.object);
            compared[usize::from(a.object)] += 1;
        }
    }
    assert!(compared.iter().all(|pixels| *pixels > 100), "{compared:?}");
    // Rounding decides at the rims of texels alone.
    assert!(compared.iter().sum::<i32>() * 100 > 99 * same, "{compared:?} of {same}");
}
