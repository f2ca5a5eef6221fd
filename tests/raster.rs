//! The z-buffer sees what the tracer sees, in another way.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use scanray::gallery::{Gallery, View};
use scanray::trace::{Observer, RayKind};
use scanray::{
    Dither, Fault, Fixed, RasterRenderer, RasterWorkspace, RenderError, Renderer, Rgb, Scalar, SceneError,
    Workspace,
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
    let quantizer = scanray::output::Quantizer::new(settings.transfer, settings.dither, 0, 0);
    let levels = |light| {
        let color: Rgb888 = scanray::Encode::from_light(light, quantizer);
        [color.r(), color.g(), color.b()]
    };
    let mut worst = 0;
    let mut compared = 0;
    for (i, (a, b)) in traced.iter().zip(rasterized).enumerate() {
        if (a.object, a.tile) == (b.object, b.tile) && !a.shadowed {
            let (a, b) = (levels(a.light), levels(b.light));
            let off = a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap();
            if off > worst {
                println!("{} {i} {a:?} {b:?}", view.name);
            }
            worst = worst.max(off);
            compared += 1;
        }
    }
    println!("{}: {compared} compared, worst {worst}/255", view.name);
    assert!(worst <= 8, "{}: {worst}/255", view.name);
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
            Err(RenderError::Scene(SceneError::Object(_, Fault::NotRasterized))) => {}
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
