//! Pictures of which not every pixel is traced.

use embedded_graphics::image::ImageRaw;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Gray8, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::gallery::{Gallery, View};
use scanray::trace::RayCounts;
use scanray::*;

const SIZE: [u32; 2] = [320, 240];

/// Draws a view and counts its rays.
fn draw<S: Scalar, C: Encode>(
    view: &View<S>,
    [columns, rows]: [u32; 2],
    quality: impl Quality,
) -> (Vec<C>, RayCounts) {
    let mut workspace = Workspace::<S, C, 0, 5>::new();
    let (size, settings) = (Size::new(columns, rows), view.settings.with_quality(quality));
    let mut renderer =
        Renderer::new(&view.scene, &view.camera, size, settings, &mut workspace).expect(view.name);
    let mut pixels = vec![C::DARKEST; (columns * rows) as usize];
    let mut rays = RayCounts::default();
    for (y, row) in (0..).zip(pixels.chunks_mut(columns as usize)) {
        renderer.watch_row(y, row, &mut rays).expect("a row of the picture");
    }
    (pixels, rays)
}

/// Answers by how many steps of a 5-bit channel two colours differ, rounded up.
fn steps(a: Rgb565, b: Rgb565) -> u8 {
    a.r().abs_diff(b.r()).max(a.b().abs_diff(b.b())).max(a.g().abs_diff(b.g()).div_ceil(2))
}

fn the_gallery_keeps_the_promise<S: Gallery>() {
    for view in S::views() {
        let (exact, all) = draw::<_, Rgb565>(view, SIZE, Exact);
        let (adaptive, some) = draw(view, SIZE, Adaptive);
        let off: Vec<u8> = exact.iter().zip(&adaptive).map(|(a, b)| steps(*a, *b)).collect();
        let over = off.iter().filter(|steps| **steps > 2).count();
        assert!(over * 1000 <= off.len() * 5, "{}: {over} of {} pixels", view.name, off.len());
        assert!(off.iter().all(|steps| *steps <= 28), "{}: {:?} steps", view.name, off.iter().max());
        assert!(2 * some.primary < all.primary, "{}: {some:?} of {all:?}", view.name);
    }
}

#[test]
fn nearly_all_pixels_of_the_gallery_are_within_two_steps_in_f32() {
    the_gallery_keeps_the_promise::<f32>();
}

#[test]
fn nearly_all_pixels_of_the_gallery_are_within_two_steps_in_fixed_point() {
    the_gallery_keeps_the_promise::<Fixed>();
}

#[test]
fn every_pixel_is_traced_unless_asked_otherwise() {
    let view = &gallery::float::THREE_SPHERES;
    let mut workspace = Workspace::<f32, Rgb565, 0, 5>::new();
    let size = Size::new(64, 48);
    let mut renderer =
        Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace).expect("a good view");
    let (mut rays, mut row) = (RayCounts::default(), [Rgb565::BLACK; 64]);
    for y in 0..48 {
        renderer.watch_row(y, &mut row, &mut rays).expect("a row of the picture");
    }
    assert_eq!(rays.primary, 64 * 48);
}

#[test]
fn a_narrow_object_is_never_lost() {
    let materials = [Material::flat(Rgb::WHITE), Material::flat(Rgb::gray(0.5))];
    let camera = Camera::perspective(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 60.0);
    let white = |pixels: &[Rgb565]| pixels.iter().filter(|color| **color == Rgb565::WHITE).count();
    for step in 0..200_u8 {
        let n = f32::from(step);
        // Balls of 0.7 to 7.6 pixels, anywhere on the row, half of them before a wall.
        let center = Vec3::new(n * 0.07 - 7.0, (n * 0.618).fract() - 0.5, -10.0);
        let ball: Shape = Shape::Sphere(Sphere::new(center, 0.03 + (n * 0.414).fract() * 0.3));
        let wall = Shape::Plane(Plane::new(Vec3::new(0.0, 0.0, -20.0), Vec3::new(0.0, 0.0, 1.0)));
        let objects = [Object::new(ball, 0), Object::new(wall, 1)];
        let objects = &objects[..1 + usize::from(step % 2)];
        let scene = Scene::new(objects, &materials, &[]).with_sky(Sky::Solid(Rgb::gray(0.1)));
        let size = Size::new(320, 240);
        let mut rows = [[0; 2]; 240];
        let mut workspace = Workspace::<f32, Rgb565, 0, 0>::new();
        let mut row = [Rgb565::BLACK; 320];
        let settings = Settings::new().with_depth(0);
        let mut exact = Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("a good scene");
        for (y, count) in (0..).zip(&mut rows) {
            exact.render_row(y, &mut row).expect("a row of the picture");
            count[0] = white(&row);
        }
        let settings = settings.with_quality(Adaptive);
        let mut adaptive =
            Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("a good scene");
        for (y, count) in (0..).zip(&mut rows) {
            adaptive.render_row(y, &mut row).expect("a row of the picture");
            count[1] = white(&row);
        }
        assert!(rows.iter().any(|[exact, _]| *exact > 0), "ball {step} is in the picture");
        assert!(rows.iter().all(|[exact, adaptive]| exact == adaptive), "ball {step}: {rows:?}");
    }
}

#[test]
fn a_part_of_a_picture_comes_out_as_in_the_whole() {
    let view = &gallery::fixed::BUSINESS_CARD;
    let size = Size::new(60, 60);
    let mut workspace = Workspace::<Fixed, Rgb565, 60, 5>::new();
    let settings = view.settings.with_quality(Adaptive);
    let mut renderer =
        Renderer::new(&view.scene, &view.camera, size, settings, &mut workspace).expect("a good view");
    let mut whole = MockDisplay::<Rgb565>::new();
    let Ok(()) = renderer.draw(&mut whole);
    for (left, width) in (0..50).flat_map(|left| [1, 2, 7, 10].map(|width| (left, width))) {
        let part = Rectangle::new(Point::new(left, 20), Size::new(width, 12));
        let mut display = MockDisplay::<Rgb565>::new();
        let Ok(()) = renderer.draw_part(&part, Point::zero(), &mut display);
        for point in part.points() {
            assert_eq!(display.get_pixel(point), whole.get_pixel(point), "{point} of {part:?}");
        }
    }
}

#[test]
fn the_columns_that_are_traced_lie_half_a_step_apart_in_rows_next_to_each_other() {
    let scene: Scene = Scene::new(&[], &[], &[]);
    let camera = Camera::perspective(Vec3::ZERO, Vec3::new(0.0, 0.0, -1.0), Vec3::new(0.0, 1.0, 0.0), 60.0);
    let settings = Settings::new().with_depth(0).with_quality(Adaptive);
    let mut workspace = Workspace::<f32, Rgb565, 0, 0>::new();
    let mut renderer =
        Renderer::new(&scene, &camera, Size::new(16, 4), settings, &mut workspace).expect("a good scene");
    // Columns 0, 8 and 15, then 0, 4, 12 and 15.
    for (y, columns) in (0..).zip([3, 4, 3, 4]) {
        let mut rays = RayCounts::default();
        renderer.watch_row(y, &mut [Rgb565::BLACK; 16], &mut rays).expect("a row of the picture");
        assert_eq!(rays.primary, columns, "row {y}");
    }
}

/// Is a row of a camera that looks straight at what stands 10 before it: a column is 0.1 wide.
fn row_before(objects: &[Object], materials: &[Material], lights: &[Light]) -> [[Gray8; 64]; 2] {
    let scene = Scene::new(objects, materials, lights).with_ambient(Rgb::WHITE);
    let view = [Vec3::ZERO, Vec3::new(0.0, 0.0, -10.0), Vec3::new(0.0, 1.0, 0.0)];
    let camera = Camera::new(view, Projection::Orthographic { height: 0.1 }, [0.0, 100.0]);
    let settings = Settings::new().with_depth(0).with_dither(Dither::None);
    let mut workspace = Workspace::<f32, Gray8, 0, 0>::new();
    let mut rows = [[Gray8::BLACK; 64]; 2];
    let size = Size::new(64, 1);
    let [exact, adaptive] = &mut rows;
    let mut renderer = Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("a good scene");
    renderer.render_row(0, exact).expect("the row");
    let settings = settings.with_quality(Adaptive);
    let mut renderer = Renderer::new(&scene, &camera, size, settings, &mut workspace).expect("a good scene");
    renderer.render_row(0, adaptive).expect("the row");
    rows
}

const WALL: Plane = Plane::new(Vec3::new(0.0, 0.0, -10.0), Vec3::new(0.0, 0.0, 1.0));

#[test]
fn nothing_is_filled_in_across_two_objects() {
    // Two shades 1.6 steps of 5 bits apart, which as colours alone would pass for one.
    let materials = [Material::flat(Rgb::gray(0.50)), Material::flat(Rgb::gray(0.46))];
    let slope = Plane::new(Vec3::new(0.33, 0.0, -10.0), Vec3::new(1.0, 0.0, 1.0));
    let objects = [Object::new(Shape::Plane(WALL), 0), Object::new(Shape::Plane(slope), 1)];
    let [exact, adaptive] = row_before(&objects, &materials, &[]);
    assert!(exact.windows(2).any(|pair| pair[0] != pair[1]));
    assert_eq!(exact, adaptive);
}

#[test]
fn nothing_is_filled_in_across_two_tiles() {
    let board = Checker::new(Rgb::gray(0.50), Rgb::gray(0.46), 0.77);
    let materials = [Material::textured(Texture::Checker(board))];
    let [exact, adaptive] = row_before(&[Object::new(Shape::Plane(WALL), 0)], &materials, &[]);
    assert!(exact.windows(2).filter(|pair| pair[0] != pair[1]).count() > 3);
    assert_eq!(exact, adaptive);
}

#[test]
fn nothing_is_filled_in_across_two_texels() {
    // Shades up to 1.6 steps of 5 bits apart, a texel to 1.3 columns.
    static SHADES: ImageRaw<Gray8> = ImageRaw::new(&[185, 181, 186, 180, 184, 187, 180], 7);
    for filter in [Filter::Nearest, Filter::Bilinear] {
        let image = Image::new(Bitmap::new(&SHADES)).with_tiles(1.28, 1.0).with_filter(filter);
        let materials = [Material::textured(Texture::Image(image))];
        let [exact, adaptive] = row_before(&[Object::new(Shape::Plane(WALL), 0)], &materials, &[]);
        assert!(exact.windows(2).filter(|pair| pair[0] != pair[1]).count() > 20);
        assert_eq!(exact, adaptive, "{filter:?}");
    }
}

#[test]
fn nothing_is_filled_in_across_the_edge_of_a_shadow() {
    let materials = [Material::matte(Rgb::gray(0.50))];
    // A box above the picture keeps the faint light from the right half of the wall.
    let lights = [
        Light::directional(Vec3::new(0.0, 0.0, 1.0), Rgb::gray(0.9)),
        Light::directional(Vec3::new(0.0, 1.0, 1.0), Rgb::gray(0.1)),
    ];
    let high = Cuboid::new(Vec3::new(0.33, 3.0, -9.0), Vec3::new(9.0, 9.0, -1.0));
    let objects = [Object::new(Shape::Plane(WALL), 0), Object::new(Shape::Cuboid(high), 0)];
    let [exact, adaptive] = row_before(&objects, &materials, &lights);
    assert!(exact.windows(2).any(|pair| pair[0] != pair[1]));
    assert_eq!(exact, adaptive);
}

#[test]
fn what_is_filled_in_rises_evenly_between_two_samples() {
    let materials = [Material::matte(Rgb::WHITE).with_ambient(0.0)];
    let lights = [Light::point(Vec3::new(-2.0, 0.0, -7.0), Rgb::WHITE)];
    let [exact, adaptive] = row_before(&[Object::new(Shape::Plane(WALL), 0)], &materials, &lights);
    // Eight columns of it differ by up to ten levels.
    assert!(exact.windows(9).any(|columns| columns[0].luma().abs_diff(columns[8].luma()) > 6));
    for (x, (exact, adaptive)) in exact.iter().zip(&adaptive).enumerate() {
        assert!(exact.luma().abs_diff(adaptive.luma()) <= 1, "column {x}: {adaptive:?}, not {exact:?}");
    }
}
