//! Pictures that become finer and finer.

use crate::support::{Panel, camera, panel, panel_of, pixels, scene, written};
use draw_faults::Call;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb666, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::output::BLUE_NOISE;
use scanray::render::Pointwise;
use scanray::trace::RayCounts;
use scanray::*;

fn settings<Q: Pointwise>(quality: Q) -> Settings<f32, Q> {
    Settings::new().with_depth(2).with_quality(quality)
}

type Room<C> = Workspace<f32, C, 64, 2>;

/// Draws the picture directly.
fn direct<C: Encode + PixelColor, Q: Pointwise>(size: Size, settings: Settings<f32, Q>) -> Vec<Option<C>> {
    let mut workspace = Room::<C>::new();
    let mut panel = panel(size);
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
    renderer.draw(&mut panel).unwrap();
    pixels(&panel).to_vec()
}

/// Draws the picture from coarse blocks on, and answers the panel and the rays it took.
fn refined<C: Encode + PixelColor, Q: Pointwise>(
    size: Size,
    settings: Settings<f32, Q>,
    block: u8,
) -> (Panel<C>, RayCounts) {
    let mut workspace = Room::<C>::new();
    let (mut panel, mut rays) = (panel(size), RayCounts::default());
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
    let mut progress = Progress::new(block);
    while renderer.watch_refining(&mut progress, Point::zero(), &mut panel, &mut rays).unwrap() {
        assert!(!progress.is_complete());
    }
    assert!(progress.is_complete());
    assert_eq!(renderer.refine(&mut progress, &mut panel), Ok(false));
    (panel, rays)
}

#[test]
fn each_pixel_is_traced_once_and_the_last_picture_is_the_direct_one() {
    for size in [Size::new(64, 48), Size::new(61, 37), Size::new(5, 40), Size::new(1, 1), Size::new(17, 1)] {
        let direct = direct::<Rgb565, _>(size, settings(Exact));
        for block in [0, 1, 2, 3, 16, 31, 64, 255] {
            let (panel, rays) = refined(size, settings(Exact), block);
            assert_eq!(rays.primary, u64::from(size.width * size.height), "{size}, blocks of {block}");
            assert_eq!(pixels(&panel), direct, "{size}, blocks of {block}");
        }
    }
}

#[test]
fn every_panel_ends_with_the_direct_picture() {
    fn check<C: Encode + PixelColor + std::fmt::Debug>() {
        let size = Size::new(61, 37);
        for dither in [Dither::None, Dither::Ordered, Dither::Mask(&BLUE_NOISE)] {
            let settings = settings(Exact).with_dither(dither);
            let (panel, _) = refined::<C, _>(size, settings, 16);
            assert_eq!(pixels(&panel), direct(size, settings));
        }
    }
    check::<Rgb565>();
    check::<Rgb666>();
    check::<Rgb888>();
    check::<Gray4>();
    check::<BinaryColor>();
}

#[test]
fn where_errors_cannot_be_handed_on_every_pass_rounds_by_the_ordered_square() {
    let size = Size::new(61, 37);
    let of = |dither| settings(Exact).with_dither(dither);
    for block in [1, 2, 16] {
        let (diffused, _) = refined::<BinaryColor, _>(size, of(Dither::Diffused), block);
        assert_eq!(pixels(&diffused), direct(size, of(Dither::Ordered)), "blocks of {block}");
    }
}

#[test]
fn several_rays_a_pixel_end_with_their_direct_picture() {
    fn check<Q: Pointwise>(quality: Q, samples: u64) {
        let size = Size::new(40, 30);
        let (panel, rays) = refined::<Rgb565, _>(size, settings(quality), 8);
        assert_eq!(rays.primary, 40 * 30 * samples);
        assert_eq!(pixels(&panel), direct(size, settings(quality)));
    }
    check(Uniform(2), 4);
    check(Jittered(3), 9);
}

#[test]
fn fixed_point_ends_with_the_direct_picture() {
    let (view, size) = (&gallery::fixed::C_RAY, Size::new(48, 36));
    let mut workspace = Workspace::<Fixed, Rgb565, 48, 5>::new();
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace).unwrap();
    let [mut direct, mut refined] = [panel::<Rgb565>(size), panel(size)];
    renderer.draw(&mut direct).unwrap();
    let mut progress = Progress::new(16);
    while renderer.refine(&mut progress, &mut refined).unwrap() {}
    assert_eq!(pixels(&refined), pixels(&direct));
}

#[test]
fn the_whole_panel_shows_something_after_the_first_pass() {
    let size = Size::new(61, 37);
    let mut workspace = Room::new();
    let mut panel = panel::<Rgb565>(size);
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings(Exact), &mut workspace).unwrap();
    let mut progress = Progress::new(16);
    while progress.side() == 16 {
        renderer.refine(&mut progress, &mut panel).unwrap();
    }
    assert!(panel.inner().inner().is_full());
    assert_eq!(written(&panel), 61 * 37);
}

#[test]
fn a_picture_of_one_shade_is_finished_by_the_first_pass_dithered_too() {
    let size = Size::new(48, 40);
    let sky: Scene = Scene::new(&[], &[], &[]).with_sky(Sky::Solid(Rgb::gray(0.3)));
    let mut workspace = Workspace::<f32, BinaryColor, 48, 0>::new();
    let settings = Settings::new().with_depth(0);
    let mut renderer = Renderer::new(&sky, &camera(), size, settings, &mut workspace).unwrap();
    let [mut direct, mut panel] = [panel(size), panel(size)];
    renderer.draw(&mut direct).unwrap();
    let mut progress = Progress::new(16);
    while progress.side() == 16 {
        renderer.refine(&mut progress, &mut panel).unwrap();
    }
    assert_eq!(pixels(&panel), pixels(&direct));
    assert!(
        pixels(&panel).contains(&Some(BinaryColor::On)) && pixels(&panel).contains(&Some(BinaryColor::Off))
    );
}

#[test]
fn it_goes_on_after_any_step_with_another_renderer() {
    let size = Size::new(61, 37);
    let mut panel = panel::<Rgb565>(size);
    let mut progress = Progress::new(8);
    let mut more = true;
    while more {
        // What was in RAM is lost between any two steps.
        let mut workspace = Room::new();
        let mut renderer = Renderer::new(&scene(), &camera(), size, settings(Exact), &mut workspace).unwrap();
        more = renderer.refine(&mut progress, &mut panel).unwrap();
    }
    assert_eq!(pixels(&panel), direct(size, settings(Exact)));
}

#[test]
fn it_is_drawn_at_any_corner() {
    let size = Size::new(24, 20);
    let mut workspace = Room::new();
    let mut renderer = Renderer::new(&scene(), &camera(), size, settings(Exact), &mut workspace).unwrap();
    let mut panel = panel_of::<Rgb565>(Rectangle::new(Point::new(-7, 11), size));
    let mut progress = Progress::new(16);
    while renderer.refine(&mut progress, &mut panel).unwrap() {}
    assert_eq!(pixels(&panel), direct(size, settings(Exact)));
}

#[test]
fn a_panel_is_written_four_times_and_rows_are_kept_together() {
    let (panel, _) = refined::<Rgb565, _>(Size::new(64, 64), settings(Exact), 16);
    // A pass but the first paints three quarters of the picture.
    assert_eq!(written(&panel), 64 * 64 * (4 + 4 * 3) / 4);
    let calls = panel.inner().calls();
    let fills = |side| calls.iter().filter_map(Call::area).filter(|area| area.size.height == side).count();
    // Bands of which every second block is new are painted block by block, others eight blocks at a time.
    assert_eq!(fills(16), 4);
    assert_eq!(fills(8), 4 * 4 + 4);
    assert_eq!(fills(4), 8 * 8 + 8 * 2);
    assert_eq!(fills(2), 16 * 16 + 16 * 4);
    // The last pass has whole rows.
    assert_eq!(fills(1), 32 * 32 + 32);
    assert!(calls.iter().all(|call| matches!(call, Call::Contiguous(_))));
}

#[test]
fn a_block_that_is_not_dithered_is_one_solid_fill() {
    let settings = settings(Exact).with_dither(Dither::None);
    let (panel, _) = refined::<Rgb565, _>(Size::new(64, 64), settings, 16);
    for call in panel.inner().calls() {
        let area = call.area().expect("fills alone");
        assert_eq!(*call == Call::Solid(area), area.size.width == area.size.height, "{area:?}");
    }
}
