//! Draws a scene by any of the core's doors.

use super::canvas::Canvas;
use super::dice::Dice;
use super::liar::Liar;
use super::scene::{DEPTH, Recipe};
use super::shelf::Shelf;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use host_sim::rounded::Rounded;
use scanray::trace::RayCounts;
use scanray::{
    Adaptive, AtEdges, Exact, Jittered, Progress, Quality, RasterRenderer, RasterWorkspace, RenderError,
    Renderer, Uniform, Workspace,
};

/// Is the longest row that there is room for.
const WIDTH: usize = 24;

/// Is how many places each pixel may be asked at in a row: what a coarse pass asks of its neighbours included.
const ASKED: u64 = 3;

/// Makes a scene of the dice and draws it.
pub fn scene<S: Rounded>(shelf: &Shelf<S>, dice: &mut Dice) -> Result<(), RenderError> {
    let recipe = Recipe::thrown(shelf, dice);
    match dice.below(8) {
        0 => each_pixel(&recipe),
        1 => parts(&recipe, dice),
        2 => refined(&recipe, dice),
        3 => rastered(&recipe),
        4 => whole(&recipe, Adaptive, 1),
        5 => {
            let side = dice.pick(&[0, 1, 2, 3, 3, 200]);
            whole(&recipe, Uniform(side), side)
        }
        6 => {
            let side = dice.pick(&[1, 2, 3]);
            whole(&recipe, AtEdges(Jittered(side)), side)
        }
        _ => whole(&recipe, Exact, 1),
    }
}

type Space<S> = Workspace<S, Rgb565, WIDTH, { DEPTH as usize }>;

fn canvas_size([columns, rows]: [u32; 2]) -> Size {
    Size::new(columns, rows)
}

/// Draws onto a display in one go, and counts rays in a second one.
fn whole<S: Rounded, Q: Quality>(recipe: &Recipe<S>, quality: Q, side: u8) -> Result<(), RenderError> {
    let scene = recipe.scene();
    let settings = recipe.settings.with_quality(quality);
    let mut workspace = Space::new();
    let size = canvas_size(recipe.size);
    let mut renderer = Renderer::new(&scene, &recipe.camera, size, settings, &mut workspace)?;
    let mut canvas = Canvas::new();
    let Ok(()) = renderer.draw(&mut canvas);
    assert!(canvas.holds(recipe.size, |count| count == 1), "each pixel is written once");
    let mut rays = RayCounts::default();
    let mut row = vec![Rgb565::BLACK; recipe.size[0] as usize];
    for y in 0..recipe.size[1] {
        renderer.watch_row(y, &mut row, &mut rays).expect("there is such a row");
    }
    let pixels = u64::from(recipe.size[0]) * u64::from(recipe.size[1]);
    let most = pixels * ASKED * u64::from(side).pow(2).max(1) * recipe.most_rays();
    assert!(rays.total() <= most, "{rays:?} are more than {most}");
    assert!(renderer.render_row(recipe.size[1], &mut row).is_err(), "there is no row below the last");
    assert!(renderer.render_row::<Rgb565>(0, &mut []).is_err(), "a row has pixels");
    Ok(())
}

/// Hands out the light of each pixel, which is a number, and none is missing: rounding may leave 2^-16, half the
/// darkest step of any panel, less than nothing.
fn each_pixel<S: Rounded>(recipe: &Recipe<S>) -> Result<(), RenderError> {
    let scene = recipe.scene();
    let mut workspace = Workspace::<S, Rgb565, 0, { DEPTH as usize }>::new();
    let size = canvas_size(recipe.size);
    let mut renderer = Renderer::<S, Rgb565, 0, { DEPTH as usize }, Liar<S>, _>::new(
        &scene,
        &recipe.camera,
        size,
        recipe.settings,
        &mut workspace,
    )?;
    // Columns without a workspace's row may be many; a few rows tell.
    for y in 0..recipe.size[1].min(16) {
        let mut next = 0;
        let row = renderer.trace_row(y, 0..u32::MAX, &mut (), |x, light| {
            assert_eq!(x, next, "each pixel in its turn");
            next += 1;
            let is_number = |part: S| part < S::ZERO || part >= S::ZERO;
            let least = if recipe.has_a_liar() { S::FAR_BACK } else { -S::PARALLEL };
            let is_light = |part: S| is_number(part) && part >= least;
            assert!([light.r, light.g, light.b].into_iter().all(is_light), "{light:?} in {x}, {y}");
        });
        row.expect("there is such a row");
        assert_eq!(next, recipe.size[0], "each pixel of the row");
    }
    Ok(())
}

/// Draws parts of the picture wherever they are asked for.
fn parts<S: Rounded>(recipe: &Recipe<S>, dice: &mut Dice) -> Result<(), RenderError> {
    let scene = recipe.scene();
    let mut workspace = Space::new();
    let size = canvas_size(recipe.size);
    let mut renderer = Renderer::new(&scene, &recipe.camera, size, recipe.settings, &mut workspace)?;
    let mut canvas = Canvas::new();
    let half = Size::new(size.width / 2, size.height);
    for part in [
        Rectangle::new(Point::zero(), half),
        Rectangle::new(Point::new(half.width as i32, 0), Size::new(size.width - half.width, size.height)),
        Rectangle::new(Point::new(i32::MIN, 3), Size::new_equal(7)),
        Rectangle::new(Point::new(40, i32::MAX), Size::new_equal(u32::MAX)),
        Rectangle::new(Point::new(2, 2), Size::zero()),
    ] {
        let Ok(()) = renderer.draw_part(&part, Point::zero(), &mut canvas);
    }
    assert!(canvas.holds(recipe.size, |count| count == 1), "two halves are the whole");
    let far = [i32::MIN, -1, i32::MAX];
    let Ok(()) = renderer.draw_at(Point::new(dice.pick(&far), dice.pick(&far)), &mut canvas);
    Ok(())
}

/// Draws in passes that become finer.
fn refined<S: Rounded>(recipe: &Recipe<S>, dice: &mut Dice) -> Result<(), RenderError> {
    let scene = recipe.scene();
    let mut workspace = Space::new();
    let size = canvas_size(recipe.size);
    let mut renderer = Renderer::new(&scene, &recipe.camera, size, recipe.settings, &mut workspace)?;
    let mut canvas = Canvas::new();
    let mut progress = Progress::new(dice.pick(&[0, 1, 2, 7, 16, 255]));
    let mut steps = 0;
    while let Ok(true) = renderer.refine(&mut progress, &mut canvas) {
        steps += 1;
        assert!(steps <= 64 * 8, "passes end");
    }
    assert!(progress.is_complete() && canvas.holds(recipe.size, |count| count >= 1));
    Ok(())
}

/// Draws by the z-buffer, what it knows.
fn rastered<S: Rounded>(recipe: &Recipe<S>) -> Result<(), RenderError> {
    let scene = recipe.scene();
    let mut workspace = RasterWorkspace::<S, WIDTH>::new();
    let size = canvas_size(recipe.size);
    let mut renderer = RasterRenderer::new(&scene, &recipe.camera, size, recipe.settings, &mut workspace)?;
    let mut canvas = Canvas::new();
    let Ok(()) = renderer.draw(&mut canvas);
    assert!(canvas.holds(recipe.size, |count| count == 1), "each pixel is written once");
    Ok(())
}
