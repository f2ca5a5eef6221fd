use super::picture::Picture;
use super::{Exact, Quality, RenderError, RowError, Settings, Workspace};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::math::Scalar;
use crate::output::Encode;
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::Observer;
use core::convert::Infallible;
use core::ops::Range;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

/// Draws a scene row by row.
///
/// Rows do not depend on each other: any row, or part of one, comes out the same whenever and in
/// whatever order it is asked for.
#[derive(Debug)]
pub struct Renderer<'a, 'w, S: Scalar, C, const WIDTH: usize, const DEPTH: usize, X = Infallible, Q = Exact> {
    pub(super) picture: Picture<'a, S, X, Q>,
    pub(super) workspace: &'w mut Workspace<S, C, WIDTH, DEPTH>,
}

impl<'a, 'w, S, C, const WIDTH: usize, const DEPTH: usize, X, Q> Renderer<'a, 'w, S, C, WIDTH, DEPTH, X, Q>
where
    S: Scalar,
    C: Encode,
    X: Intersect<S>,
    Q: Quality,
{
    /// Makes a renderer for pictures of one size.
    ///
    /// Matched by reference, as in `match &mut Renderer::new(..)`, it stays where it is made; moved out of the result,
    /// its 250 bytes mostly lie on the stack twice.
    ///
    /// # Errors
    /// Whatever keeps the picture from being drawn: a fault of the scene or the camera, a
    /// workspace too small.
    pub fn new(
        scene: &Scene<'a, S, X>,
        camera: &Camera<S>,
        size: Size,
        settings: Settings<S, Q>,
        workspace: &'w mut Workspace<S, C, WIDTH, DEPTH>,
    ) -> Result<Self, RenderError> {
        scene.check()?;
        if WIDTH > 0 && size.width as usize > WIDTH {
            return Err(RenderError::RowTooWide { width: size.width, room: WIDTH });
        }
        if usize::from(settings.depth) > DEPTH {
            return Err(RenderError::TooDeep { depth: settings.depth, room: DEPTH });
        }
        settings.check_exposure()?;
        settings.quality.pattern().check()?;
        let frame = camera.frame(size.width, size.height)?;
        workspace.scratch.spans.enter_picture(scene, &frame);
        workspace.scratch.vicinities.clear();
        Ok(Self {
            picture: Picture {
                scene: *scene,
                frame,
                size,
                settings,
                faintest: faintest(scene, settings.depth),
            },
            workspace,
        })
    }

    /// Answers the size of the picture.
    pub fn size(&self) -> Size {
        self.picture.size
    }

    /// Traces the pixels `columns` of row `y` and hands each its linear light, left to right.
    ///
    /// Columns beyond the picture are left out. With [`Adaptive`](crate::Adaptive) too every pixel is traced:
    /// pixels are filled in on their way to a panel, in its levels.
    ///
    /// # Errors
    /// [`RowError::NoSuchRow`] below the picture.
    pub fn trace_row(
        &mut self,
        y: u32,
        columns: Range<u32>,
        observer: &mut impl Observer,
        pixel: impl FnMut(u32, Rgb<S>),
    ) -> Result<(), RowError> {
        self.row_exists(y)?;
        self.picture.trace_row(&mut self.workspace.scratch, y, columns, observer, pixel);
        Ok(())
    }

    fn row_exists(&self, y: u32) -> Result<(), RowError> {
        if y < self.picture.size.height { Ok(()) } else { Err(RowError::NoSuchRow(y)) }
    }

    /// Renders row `y` into a buffer of the caller's: the door for those who feed a display by DMA.
    ///
    /// `P` is any colour of embedded-graphics, or `[u8; 2]` for the bytes of Rgb565 as the bus
    /// wants them.
    ///
    /// # Errors
    /// [`RowError`] when there is no such row, or the buffer is not exactly as long as it.
    pub fn render_row<P: Encode>(&mut self, y: u32, row: &mut [P]) -> Result<(), RowError> {
        self.watch_row(y, row, &mut ())
    }

    /// Renders row `y` as [`render_row`](Self::render_row) does and tells an observer of its rays.
    ///
    /// # Errors
    /// As there.
    pub fn watch_row<P: Encode>(
        &mut self,
        y: u32,
        row: &mut [P],
        observer: &mut impl Observer,
    ) -> Result<(), RowError> {
        let width = self.picture.size.width;
        RowError::check_length(width, row.len())?;
        self.row_exists(y)?;
        self.picture.encode_row(&mut self.workspace.scratch, y, 0..width, row, observer);
        Ok(())
    }
}

/// Answers the columns and the rows of a part that lie in a picture of some size; `Rectangle::intersection` would wrap
/// where a part ends beyond the largest coordinate.
fn inside(part: &Rectangle, size: Size) -> [Range<u32>; 2] {
    let cut = |start: i32, length: u32, most: u32| {
        let [start, end] =
            [start, start.saturating_add_unsigned(length)].map(|end| end.max(0).unsigned_abs());
        start..end.min(most)
    };
    let Rectangle { top_left, size: extent } = *part;
    [cut(top_left.x, extent.width, size.width), cut(top_left.y, extent.height, size.height)]
}

/// Answers the weight up to which all that a ray can still bring is too faint for any panel.
///
/// It brings less than 2^-16: 1/20 of the darkest step of 8 bits a channel, which the sRGB curve
/// makes 1/3295 of white; 1/80 of the darkest step of 6 bits, 1/160 of that of 5, 1/340 of that of
/// 4. No channel changes by more than one step, and that only where dithering tips it.
fn faintest<S: Scalar, X: Intersect<S>>(scene: &Scene<'_, S, X>, depth: u8) -> S {
    let mirrors = S::from_i32(64) * (S::from_i32(i32::from(depth)) + S::ONE);
    S::SKIN * (mirrors * scene.brightest()).recip()
}

impl<S, C, const WIDTH: usize, const DEPTH: usize, X, Q> Renderer<'_, '_, S, C, WIDTH, DEPTH, X, Q>
where
    S: Scalar,
    C: Encode + PixelColor,
    X: Intersect<S>,
    Q: Quality,
{
    /// Draws the picture at the upper left corner of a display, one `fill_contiguous` a row.
    ///
    /// # Errors
    /// The display's own error, untouched. Drawing again draws the whole picture again.
    pub fn draw<D: DrawTarget<Color = C>>(&mut self, target: &mut D) -> Result<(), D::Error> {
        let corner = target.bounding_box().top_left;
        self.draw_at(corner, target)
    }

    /// Draws the picture with its upper left corner at a point of the display.
    ///
    /// # Errors
    /// The display's own error, untouched.
    pub fn draw_at<D: DrawTarget<Color = C>>(
        &mut self,
        corner: Point,
        target: &mut D,
    ) -> Result<(), D::Error> {
        self.draw_part(&Rectangle::new(Point::zero(), self.picture.size), corner, target)
    }

    /// Draws a part of the picture, given in the picture's own pixels, where it belongs when the
    /// picture's upper left corner is at a point of the display.
    ///
    /// What of `part` lies outside the picture is not drawn. With
    /// [`Dither::Diffused`](crate::Dither::Diffused) its rows are traced from the picture's left edge on.
    ///
    /// # Errors
    /// The display's own error, untouched.
    pub fn draw_part<D: DrawTarget<Color = C>>(
        &mut self,
        part: &Rectangle,
        corner: Point,
        target: &mut D,
    ) -> Result<(), D::Error> {
        self.watch_part(part, corner, target, &mut ())
    }

    pub(super) fn watch_part<D: DrawTarget<Color = C>>(
        &mut self,
        part: &Rectangle,
        corner: Point,
        target: &mut D,
        observer: &mut impl Observer,
    ) -> Result<(), D::Error> {
        const { assert!(WIDTH > 0, "drawing needs a workspace with room for a row") };
        let [columns, rows] = inside(part, self.picture.size);
        if columns.is_empty() {
            return Ok(());
        }
        let Workspace { scanline, scratch } = &mut *self.workspace;
        // No row is longer than WIDTH: `new` has seen to it.
        let (pixels, _) = scanline.split_at_mut(columns.len().min(WIDTH));
        for y in rows {
            self.picture.encode_row(scratch, y, columns.clone(), pixels, observer);
            let place = Point::new(
                corner.x.saturating_add_unsigned(columns.start),
                corner.y.saturating_add_unsigned(y),
            );
            let row = Rectangle::new(place, Size::new(pixels.len() as u32, 1));
            target.fill_contiguous(&row, pixels.iter().copied())?;
        }
        Ok(())
    }
}
