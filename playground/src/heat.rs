//! Heat: how many rays each pixel takes, in colours.

use crate::fault::Fault;
use embedded_graphics_core::geometry::Size;
use host_sim::picture::MAX_DEPTH;
use host_sim::scenes::HostNumber;
use host_sim::shot::{Approach, Number, Shot};
use scanray::trace::RayCounts;
use scanray::{Fixed, RenderError, Renderer, Workspace};

/// Is the colours from few rays to many: viridis, whose lightness rises evenly for every kind of eye (van der Walt
/// and Smith, 2015), at five places.
pub const COLORS: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// Counts the rays that the one through the middle of each pixel leads to, itself among them, row by row.
///
/// # Errors
/// What keeps the core from drawing the picture, or that it is not the core's tracer that draws it.
pub fn count(shot: &Shot) -> Result<Vec<u64>, Fault> {
    let counted = match (shot.approach, shot.number) {
        (Approach::Raster, _) | (_, Number::Oracle) => return Err(Fault::Uncounted),
        (_, Number::F32) => count_in::<f32>(shot),
        (_, Number::Fixed) => count_in::<Fixed>(shot),
        (_, Number::Exact) => count_in::<f64>(shot),
    };
    Ok(counted?)
}

fn count_in<S: HostNumber>(shot: &Shot) -> Result<Vec<u64>, RenderError> {
    let view = shot.view::<S>();
    let [columns, rows] = shot.size;
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let size = Size::new(columns, rows);
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace)?;
    let mut counts = vec![];
    for y in 0..rows {
        for x in 0..columns {
            let mut rays = RayCounts::default();
            // The row exists.
            let _ = renderer.trace_row(y, x..x + 1, &mut rays, |_, _| ());
            counts.push(rays.total());
        }
    }
    Ok(counts)
}

/// Answers the fewest and the most rays of a pixel.
pub fn range(counts: &[u64]) -> [u64; 2] {
    let ends = [counts.iter().min(), counts.iter().max()];
    ends.map(|end| end.copied().unwrap_or_default())
}

/// Answers the colour of so many rays in a picture of such a range.
pub fn color(count: u64, [fewest, most]: [u64; 2]) -> [u8; 3] {
    let spans = COLORS.len() as u64 - 1;
    let above = count.clamp(fewest, most.max(fewest)) - fewest;
    // In parts of 256 to a span.
    let place = (above * 256 * spans).checked_div(most.saturating_sub(fewest)).unwrap_or(0);
    let first = ((place / 256).min(spans - 1)) as usize;
    let part = (place - 256 * first as u64) as i32;
    std::array::from_fn(|channel| {
        let [from, to] = [COLORS[first][channel], COLORS[first + 1][channel]].map(i32::from);
        (from + (to - from) * part / 256) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use host_sim::scenes;

    #[test]
    fn fewest_and_most_rays_have_the_ends_of_the_colours() {
        assert_eq!(
            [color(2, [2, 10]), color(6, [2, 10]), color(10, [2, 10])],
            [COLORS[0], COLORS[2], COLORS[4]]
        );
        assert_eq!(color(5, [5, 5]), COLORS[0]);
        assert_eq!([color(0, [2, 10]), color(99, [2, 10])], [COLORS[0], COLORS[4]]);
        assert_eq!(range(&[]), [0, 0]);
    }

    #[test]
    fn rays_counted_by_the_pixel_are_those_of_the_picture() {
        for name in ["three-spheres", "c-ray", "glass", "teapot"] {
            let shot = Shot { size: [48, 36], ..Shot::new(scenes::find(name).unwrap()) };
            for number in [Number::F32, Number::Fixed, Number::Exact] {
                let shot = Shot { number, ..shot };
                let whole = shot.take(|_| ()).unwrap().rays.unwrap().total();
                assert_eq!(count(&shot).unwrap().iter().sum::<u64>(), whole, "{name}");
            }
        }
    }
}
