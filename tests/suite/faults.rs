//! Displays that fail, stall or have another size: nothing is lost, and nobody else's error is made.

use crate::support::{BusFault, Memory, memory};
use draw_faults::{At, Counting, Failing, Stalling, Strict};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::prelude::*;
use scanray::gallery::{Gallery, View};
use scanray::render::Pointwise;
use scanray::*;
use std::fmt::Debug;

const SIZE: Size = Size::new(20, 15);

type Room<S> = Workspace<S, Rgb565, 20, 5>;

/// Is a display with a fault, of which nothing else is forgiven.
type Bus = Strict<Counting<Failing<Memory<Rgb565>>>>;

const fn all() -> Rectangle {
    Rectangle::new(Point::zero(), SIZE)
}

fn bus(at: At, fault: BusFault) -> Bus {
    Strict::new(Counting::new(Failing::once(memory(all()), at, fault)))
}

fn shown(bus: &Bus) -> &[Option<Rgb565>] {
    bus.inner().inner().inner().pixels()
}

fn view<S: Gallery>() -> &'static View<S> {
    S::find("three-spheres").expect("a scene of the gallery")
}

/// Draws on displays that fail at every call and at every pixel in turn, and checks that the error is theirs and
/// that the next attempt completes the picture. `draw` is told whether it is the first attempt on a display.
fn survives(what: &str, mut draw: impl FnMut(&mut Bus, bool) -> Result<(), BusFault>) {
    let mut whole = bus(At::Call(u64::MAX), BusFault(0));
    draw(&mut whole, true).expect("a display that works");
    assert!(shown(&whole).iter().all(Option::is_some), "{what}");
    let counts = whole.inner().counts();
    let faults = (0..counts.calls()).map(At::Call).chain((0..counts.pixels).map(At::Pixel));
    for (number, at) in faults.enumerate() {
        let mut display = bus(at, BusFault(number));
        assert_eq!(draw(&mut display, true), Err(BusFault(number)), "{what}, {at:?}");
        assert_eq!(draw(&mut display, false), Ok(()), "{what}, {at:?}");
        assert!(shown(&display) == shown(&whole), "{what}, another picture after {at:?}");
    }
}

fn tracer_survives<S: Gallery>(quality: impl Quality + Debug) {
    let (view, mut workspace) = (view::<S>(), Room::new());
    let settings = view.settings.with_quality(quality);
    let mut renderer = Renderer::new(&view.scene, &view.camera, SIZE, settings, &mut workspace).unwrap();
    survives(&format!("{quality:?}"), |display, _| renderer.draw(display));
}

#[test]
fn whatever_row_or_pixel_a_display_fails_at_the_next_attempt_draws_the_picture() {
    tracer_survives::<f32>(Exact);
    tracer_survives::<Fixed>(Exact);
    tracer_survives::<f32>(Uniform(2));
    tracer_survives::<Fixed>(AtEdges(Uniform(2)));
}

#[test]
fn an_adaptive_picture_survives_every_failure() {
    tracer_survives::<f32>(Adaptive);
    tracer_survives::<Fixed>(Adaptive);
}

fn refining_survives<S: Gallery>(quality: impl Pointwise + Debug, dither: Dither) {
    let (view, mut workspace) = (view::<S>(), Room::new());
    let settings = view.settings.with_quality(quality).with_dither(dither);
    let mut renderer = Renderer::new(&view.scene, &view.camera, SIZE, settings, &mut workspace).unwrap();
    let mut progress = Progress::new(8);
    survives(&format!("refining, {quality:?}, {dither:?}"), |display, first| {
        if first {
            progress = Progress::new(8);
        }
        while !progress.is_complete() {
            let before = progress;
            renderer.refine(&mut progress, display).inspect_err(|_| assert_eq!(progress, before))?;
        }
        Ok(())
    });
}

#[test]
fn a_refined_picture_goes_on_with_the_band_that_a_display_failed_at() {
    refining_survives::<f32>(Exact, Dither::Ordered);
    refining_survives::<f32>(Uniform(2), Dither::None);
    refining_survives::<Fixed>(Exact, Dither::None);
}

#[test]
fn the_z_buffer_survives_every_failure() {
    fn check<S: Gallery>() {
        let (view, mut workspace) = (view::<S>(), RasterWorkspace::<S, 20>::new());
        let (camera, settings) = (&view.camera, view.settings);
        let mut renderer = RasterRenderer::new(&view.scene, camera, SIZE, settings, &mut workspace).unwrap();
        survives("z-buffer", |display, _| renderer.draw(display));
    }
    check::<f32>();
    check::<Fixed>();
}

#[test]
fn two_renderers_that_take_turns_go_on_with_the_row_that_failed() {
    let (view, mut rooms) = (view::<Fixed>(), [Room::new(), Room::new()]);
    let mut renderers = rooms.each_mut().map(|room| {
        Renderer::new(&view.scene, &view.camera, SIZE, view.settings, room).expect("a scene of the gallery")
    });
    let mut y = 0;
    survives("two renderers", |display, first| {
        if first {
            y = 0;
        }
        while y < SIZE.height as usize {
            let row = Rectangle::new(Point::new(0, y as i32), Size::new(SIZE.width, 1));
            renderers[y % 2].draw_part(&row, Point::zero(), display)?;
            y += 1;
        }
        Ok(())
    });
}

/// Repeats a step until it is through, and answers how often it was not.
fn patiently<T>(mut step: impl FnMut() -> Result<T, BusFault>) -> (T, usize) {
    let mut waits = 0;
    loop {
        match step() {
            Ok(done) => return (done, waits),
            Err(fault) => assert_eq!(fault, BusFault(11)),
        }
        waits += 1;
    }
}

#[test]
fn a_bus_that_stalls_before_every_row_costs_nothing_but_time() {
    let (view, mut workspace) = (view::<f32>(), Room::new());
    let settings = view.settings;
    let mut renderer = Renderer::new(&view.scene, &view.camera, SIZE, settings, &mut workspace).unwrap();
    let mut whole = memory(all());
    renderer.draw(&mut whole).unwrap();
    let mut display = Strict::new(Stalling::new(memory(all()), 3, BusFault(11)).every(1));
    for y in 0..SIZE.height as i32 {
        let row = Rectangle::new(Point::new(0, y), Size::new(SIZE.width, 1));
        let ((), waits) = patiently(|| renderer.draw_part(&row, Point::zero(), &mut display));
        assert_eq!(waits, 3);
    }
    assert_eq!(display.inner().inner().pixels(), whole.pixels());
}

#[test]
fn a_bus_that_stalls_again_and_again_does_not_keep_a_picture_from_becoming_finer() {
    let (view, mut workspace) = (view::<f32>(), Room::new());
    let settings = view.settings;
    let mut renderer = Renderer::new(&view.scene, &view.camera, SIZE, settings, &mut workspace).unwrap();
    let mut whole = memory(all());
    renderer.draw(&mut whole).unwrap();
    // A band of this picture is ten fills at most.
    for every in 10..25 {
        let mut display = Strict::new(Stalling::new(memory(all()), 2, BusFault(11)).every(every));
        let mut progress = Progress::new(8);
        while patiently(|| renderer.refine(&mut progress, &mut display)).0 {}
        assert!(display.inner().stalls() >= 4, "every {every} calls");
        assert_eq!(display.inner().inner().pixels(), whole.pixels(), "every {every} calls");
    }
}

/// Answers what a panel should show: the pixels of `part` of a picture whose corner is at a point of the panel.
fn expected(
    picture: &[Option<Rgb565>],
    part: &Rectangle,
    corner: Point,
    area: Rectangle,
) -> Vec<Option<Rgb565>> {
    let within = |at: i64, start: i32, length: u32| (0..i64::from(length)).contains(&(at - i64::from(start)));
    let pixel = |point: Point| {
        let (x, y) = (i64::from(point.x) - i64::from(corner.x), i64::from(point.y) - i64::from(corner.y));
        let inside = within(x, 0, SIZE.width) && within(y, 0, SIZE.height);
        let asked =
            within(x, part.top_left.x, part.size.width) && within(y, part.top_left.y, part.size.height);
        if inside && asked { picture[y as usize * SIZE.width as usize + x as usize] } else { None }
    };
    area.points().map(pixel).collect()
}

#[test]
fn a_panel_of_another_size_shows_what_it_has_room_for() {
    let (view, mut workspace, mut raster_room) =
        (view::<f32>(), Room::new(), RasterWorkspace::<f32, 20>::new());
    let (camera, settings) = (&view.camera, view.settings);
    let mut renderer = Renderer::new(&view.scene, camera, SIZE, settings, &mut workspace).unwrap();
    let mut raster = RasterRenderer::new(&view.scene, camera, SIZE, settings, &mut raster_room).unwrap();
    let [mut traced, mut rasterized] = [memory(all()), memory(all())];
    renderer.draw(&mut traced).unwrap();
    raster.draw(&mut rasterized).unwrap();
    for [width, height] in [[0, 0], [0, 9], [9, 0], [1, 1], [19, 15], [20, 14], [21, 16], [64, 48]] {
        let area = Rectangle::new(Point::new(3, -2), Size::new(width, height));
        let shows = |whole: &Memory<Rgb565>| expected(whole.pixels(), &all(), area.top_left, area);
        let [mut direct, mut refined, mut layered] = [memory(area), memory(area), memory(area)];
        renderer.draw(&mut direct).unwrap();
        assert_eq!(direct.pixels(), shows(&traced), "{width} x {height}");
        let mut progress = Progress::new(16);
        while renderer.refine(&mut progress, &mut refined).unwrap() {}
        let (refined, shown) = (refined.pixels(), shows(&traced));
        // Blocks reach as far as the picture does, so that all of it is drawn and nothing beyond.
        assert_eq!(refined, shown, "{width} x {height}");
        raster.draw(&mut layered).unwrap();
        assert_eq!(layered.pixels(), shows(&rasterized), "{width} x {height}");
    }
}

/// Makes coordinates, most of them near a picture and some as far as there are.
fn anywhere() -> impl Strategy<Value = i32> {
    prop_oneof![8 => -40..40, 1 => any::<i32>(), 1 => prop_oneof![Just(i32::MIN), Just(i32::MAX)]]
}

fn any_length() -> impl Strategy<Value = u32> {
    prop_oneof![8 => 0_u32..40, 1 => any::<u32>(), 1 => Just(u32::MAX)]
}

proptest! {
    #[test]
    fn any_part_at_any_place_of_any_panel_shows_its_pixels_and_no_others(
        (part_x, part_y, part_width, part_height) in (anywhere(), anywhere(), any_length(), any_length()),
        (corner_x, corner_y) in (anywhere(), anywhere()),
        (left, top, width, height) in (-40..40, -40..40, 0_u32..40, 0_u32..40),
    ) {
        let (view, mut workspace) = (view::<f32>(), Room::new());
        let mut renderer =
            Renderer::new(&view.scene, &view.camera, SIZE, view.settings, &mut workspace).unwrap();
        let mut whole = memory(all());
        renderer.draw(&mut whole).unwrap();
        let part = Rectangle::new(Point::new(part_x, part_y), Size::new(part_width, part_height));
        let (corner, area) =
            (Point::new(corner_x, corner_y), Rectangle::new(Point::new(left, top), Size::new(width, height)));
        let mut panel = memory(area);
        renderer.draw_part(&part, corner, &mut panel).unwrap();
        prop_assert_eq!(panel.pixels(), expected(whole.pixels(), &part, corner, area));
        let (mut refined, mut progress) = (memory(area), Progress::new(8));
        while renderer.watch_refining(&mut progress, corner, &mut refined, &mut ()).unwrap() {}
        prop_assert_eq!(refined.pixels(), expected(whole.pixels(), &all(), corner, area));
    }
}
