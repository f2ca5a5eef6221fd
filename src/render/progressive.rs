//! Progressive pictures: coarse blocks first, then finer ones, until every pixel is there (row S2).
//!
//! A pass of blocks of side s traces the pixels whose column and row are multiples of s, those of coarser
//! passes left out, and paints each over its whole block. What passes before have traced is on the panel
//! and stays there: no pixel is traced twice, and nothing is kept in RAM.

use super::{Pointwise, Renderer};
use crate::math::Scalar;
use crate::output::{Dither, Encode, light_bits};
use crate::shape::Intersect;
use crate::trace::{LANES, Observer};
use core::ops::Range;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;
use heapless::Vec;

/// Is how far a picture has been refined, in 8 bytes: [`Renderer::refine`] goes on from here.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// use scanray::{Progress, Renderer, Workspace, gallery};
///
/// let view = &gallery::float::SIMPLE;
/// let mut workspace = Workspace::<f32, Rgb565, 64, 5>::new();
/// let mut renderer = Renderer::new(
///     &view.scene, &view.camera, Size::new(64, 64), view.settings, &mut workspace)?;
/// let mut display = MockDisplay::new();
/// display.set_allow_overdraw(true);
/// let mut progress = Progress::new(16);
/// while let Ok(true) = renderer.refine(&mut progress, &mut display) {
///     // Turn to something else for a while: the panel shows a picture all the time.
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Side of the blocks of this pass; 0 after the last.
    side: u8,
    /// Whether no pass has been before.
    first: bool,
    /// The row in which the next band of blocks begins.
    y: u32,
}

impl Progress {
    /// Begins with blocks of so many pixels along a side: a power of two up to 128, others are rounded down
    /// to one. Each pass halves it; 1 draws the picture row by row.
    pub const fn new(side: u8) -> Self {
        let side = if side == 0 { 1 } else { 1 << side.ilog2() };
        Self { side, first: true, y: 0 }
    }

    /// Tells whether every pixel is drawn.
    pub const fn is_complete(&self) -> bool {
        self.side == 0
    }

    /// Answers the side of the blocks of the present pass; 0 after the last.
    pub const fn side(&self) -> u8 {
        self.side
    }

    /// Answers the rows that the next step draws in, as far as the picture has them: blocks of a pass's last
    /// band may reach below it, and are cut off there.
    pub fn rows(&self) -> Range<u32> {
        self.y..self.y.saturating_add(u32::from(self.side))
    }

    /// Goes on to the next band of a picture of so many rows.
    fn advance(&mut self, height: u32) {
        self.y = self.rows().end;
        if self.y >= height {
            *self = Self { side: self.side / 2, first: false, y: 0 };
        }
    }

    /// Tells whether all blocks of the next band are new, and not only every second one.
    fn is_whole(&self) -> bool {
        self.first || self.y / u32::from(self.side.max(1)) % 2 == 1
    }
}

/// Paints blocks of a band, neighbouring ones together: as many as rays are traced together.
struct Brush<'t, D> {
    target: &'t mut D,
    /// Where the picture's upper left corner is on the target.
    corner: Point,
    /// The rows of the band, and where its rows end.
    rows: Range<u32>,
    width: u32,
    /// The side of a block is 2 to this power.
    shift: u32,
    dither: Dither,
    /// The column in which the first block begins that is still to be painted, and their levels.
    left: u32,
    blocks: Vec<[u32; 3], LANES>,
}

impl<C: Encode + PixelColor, D: DrawTarget<Color = C>> Brush<'_, D> {
    /// Takes the levels of the block that begins in column `x`.
    fn take(&mut self, x: u32, levels: [u32; 3]) -> Result<(), D::Error> {
        let end = self.left.saturating_add((self.blocks.len() as u32).wrapping_shl(self.shift));
        if x != end || self.blocks.is_full() {
            self.paint()?;
            self.left = x;
        }
        // There is room: blocks that are painted are gone.
        let _ = self.blocks.push(levels);
        Ok(())
    }

    /// Paints all blocks taken. Every pixel has its own threshold: dithered blocks have the colour of
    /// their light, and the pixel that was traced has the one it keeps.
    fn paint(&mut self) -> Result<(), D::Error> {
        let (left, shift, dither) = (self.left, self.shift, self.dither);
        let blocks = core::mem::take(&mut self.blocks);
        let right = left.saturating_add((blocks.len() as u32).wrapping_shl(shift)).min(self.width);
        let place = |origin: i32, pixel: u32| origin.saturating_add(pixel as i32);
        let corner = Point::new(place(self.corner.x, left), place(self.corner.y, self.rows.start));
        let area = Rectangle::new(corner, Size::new(right.saturating_sub(left), self.rows.len() as u32));
        let color = |x: u32, y: u32| {
            let levels =
                blocks.get(x.wrapping_sub(left).wrapping_shr(shift) as usize).copied().unwrap_or_default();
            C::from_levels(levels, dither.threshold(x, y))
        };
        match blocks.len() {
            0 => Ok(()),
            1 if dither == Dither::None => self.target.fill_solid(&area, color(left, self.rows.start)),
            _ => {
                let pixels = self.rows.clone().flat_map(|y| (left..right).map(move |x| (x, y)));
                self.target.fill_contiguous(&area, pixels.map(|(x, y)| color(x, y)))
            }
        }
    }
}

impl<S, C, const WIDTH: usize, const DEPTH: usize, X, Q> Renderer<'_, '_, S, C, WIDTH, DEPTH, X, Q>
where
    S: Scalar,
    C: Encode + PixelColor,
    X: Intersect<S>,
    Q: Pointwise,
{
    /// Draws the next band of a picture that becomes finer and finer, at the upper left corner of a
    /// display, and tells whether there is more to draw.
    ///
    /// Once `progress` is complete the pixels are those of [`draw`](Self::draw); with
    /// [`Dither::Diffused`], which needs all pixels to the left, those of [`Dither::Ordered`]. The display shows a whole
    /// picture after the first pass, which takes 1/256 of the rays for blocks of 16; each further pass takes
    /// three times the rays of all before it. New pixels that lie side by side go to the display together,
    /// eight blocks at a time and in the last pass by rows; in every second band each block goes alone, since
    /// what lies between is on the display already. Blocks of 16 at first write every pixel four times.
    ///
    /// # Errors
    /// The display's own error, untouched. `progress` then is where it was: the same step can be tried
    /// again.
    pub fn refine<D: DrawTarget<Color = C>>(
        &mut self,
        progress: &mut Progress,
        target: &mut D,
    ) -> Result<bool, D::Error> {
        let corner = target.bounding_box().top_left;
        self.watch_refining(progress, corner, target, &mut ())
    }

    /// Draws the next band as [`refine`](Self::refine) does, with the picture's upper left corner at a point
    /// of the display, and tells an observer of its rays.
    ///
    /// # Errors
    /// As there.
    pub fn watch_refining<D: DrawTarget<Color = C>>(
        &mut self,
        progress: &mut Progress,
        corner: Point,
        target: &mut D,
        observer: &mut impl Observer,
    ) -> Result<bool, D::Error> {
        if progress.is_complete() {
            return Ok(false);
        }
        let Size { width, height } = self.picture.size;
        let Range { start: top, end } = progress.rows();
        let rows = top..end.min(height);
        let dither = self.picture.settings.dither;
        if progress.side == 1 && progress.is_whole() && dither.is_pointwise() {
            let row = Rectangle::new(Point::new(0, top as i32), Size::new(width, 1));
            self.watch_part(&row, corner, target, observer)?;
        } else if !rows.is_empty() {
            let shift = progress.side.ilog2();
            let blocks = Vec::new();
            let mut brush = Brush { target, corner, rows, width, shift, dither, left: 0, blocks };
            self.paint_band(progress, &mut brush, observer)?;
        }
        progress.advance(height);
        Ok(!progress.is_complete())
    }

    /// Traces the new pixels of a band's first row and paints their blocks.
    fn paint_band<D: DrawTarget<Color = C>>(
        &mut self,
        progress: &Progress,
        brush: &mut Brush<'_, D>,
        observer: &mut impl Observer,
    ) -> Result<(), D::Error> {
        let side = u32::from(progress.side);
        let (first, stride) = if progress.is_whole() { (0, side) } else { (side, 2 * side) };
        let Self { picture, workspace } = self;
        let transfer = picture.settings.transfer;
        let mut sampler = picture.sampler(&mut workspace.scratch, [first, progress.y], &[], observer);
        sampler.try_trace(first..brush.width, stride, |x, light| {
            brush.take(x, C::levels(light_bits(light), transfer))
        })?;
        brush.paint()
    }
}
