//! Pictures of which a pixel takes several rays.

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::gallery::{Gallery, View};
use scanray::trace::RayCounts;
use scanray::*;

/// Traces the light of a view and counts its rays.
fn film<S: Scalar>(view: &View<S>, size: [u32; 2], quality: impl Quality) -> (Vec<Rgb<S>>, RayCounts) {
    let mut workspace = Workspace::<S, Rgb888, 0, 5>::new();
    let settings = view.settings.with_quality(quality);
    let canvas = Size::new(size[0], size[1]);
    let mut renderer =
        Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace).expect(view.name);
    let (mut light, mut rays) = (Vec::new(), RayCounts::default());
    for y in 0..size[1] {
        renderer.trace_row(y, 0..size[0], &mut rays, |_, pixel| light.push(pixel)).expect("a row");
    }
    (light, rays)
}

fn all(rays: RayCounts) -> u64 {
    rays.primary + rays.shadow + rays.reflection
}

/// Answers the mean square of the differences of 8-bit levels.
fn error(a: &[Rgb<f32>], b: &[Rgb<f32>]) -> f64 {
    let levels = |light: &Rgb<f32>| {
        [light.r, light.g, light.b].map(|n| f64::from(Transfer::Srgb.level(Scalar::light_bits(n))) / 256.0)
    };
    let square = |(a, b): (&Rgb<f32>, &Rgb<f32>)| {
        levels(a).into_iter().zip(levels(b)).map(|(a, b)| (a - b).powi(2)).sum::<f64>()
    };
    a.iter().zip(b).map(square).sum::<f64>() / (3 * a.len()) as f64
}

#[test]
fn probe() {
    for view in f32::views() {
        let size = [160, 120];
        let (truth, _) = film(view, size, Uniform(8));
        for n in [2, 3, 4] {
            let (exact, one) = film(view, size, Exact);
            let (full, many) = film(view, size, Uniform(n));
            let (jit, _) = film(view, size, Jittered(n));
            let (edges, some) = film(view, size, AtEdges(Uniform(n)));
            println!("{:14} n {n}: exact {:7.2} uniform {:6.2} jitter {:6.2} edges {:6.2}; rays edges/full {:.3}, primary a pixel {:.2}, all/exact {:.2}",
                view.name, error(&exact, &truth), error(&full, &truth), error(&jit, &truth), error(&edges, &truth),
                all(some) as f64 / all(many) as f64, some.primary as f64 / one.primary as f64, all(some) as f64/all(one) as f64);
        }
    }
}
