use super::depths::Fragment;
use super::slice::Slice;
use super::workspace::RasterWorkspace;
use super::{figure, shading};
use crate::camera::{Camera, CameraError, Frame};
use crate::color::Rgb;
use crate::math::Scalar;
use crate::output::{Encode, Rounding, light_bits};
use crate::render::{RenderError, RowError, Settings};
use crate::scene::Scene;
use crate::shape::Intersect;
use crate::trace::Observer;
use core::convert::Infallible;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

/// Draws a scene row by row with a z-buffer, where [`Renderer`](crate::Renderer) traces rays.
///
/// Both draw the same picture but for what takes further rays: here nothing casts a shadow, and mirrors and
/// glass show their own surface alone, as the tracer has them at depth 0, glass opaque. What is nearer to the
/// eye than 1/1024 is not drawn. Rows do not depend on each other.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// use scanray::{RasterRenderer, RasterWorkspace, gallery::float::SIMPLE};
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// let mut workspace = RasterWorkspace::<f32, 64>::new();
/// let size = display.bounding_box().size;
/// let Ok(()) = RasterRenderer::new(&SIMPLE.scene, &SIMPLE.camera, size, SIMPLE.settings, &mut workspace)?
///     .draw(&mut display);
/// # Ok::<(), scanray::RenderError>(())
/// ```
#[derive(Debug)]
pub struct RasterRenderer<'a, 'w, S: Scalar, const WIDTH: usize, X = Infallible> {
    scene: Scene<'a, S, X>,
    frame: Frame<S>,
    size: Size,
    settings: Settings<S>,
    /// A distance from the eye within which nothing stands.
    clear: S,
    workspace: &'w mut RasterWorkspace<S, WIDTH>,
}

impl<'a, 'w, S: Scalar, const WIDTH: usize, X: Intersect<S>> RasterRenderer<'a, 'w, S, WIDTH, X> {
    /// Makes a renderer for pictures of one size; the settings' depth and quality mean nothing to it.
    ///
    /// # Errors
    /// Whatever keeps the picture from being drawn: a fault of the scene or the camera, a row that does
    /// not fit the workspace, and with [`Fault::NotRasterized`](crate::Fault::NotRasterized) an object
    /// that is no sphere, plane, triangle or box.
    pub fn new(
        scene: &Scene<'a, S, X>,
        camera: &Camera<S>,
        size: Size,
        settings: Settings<S>,
        workspace: &'w mut RasterWorkspace<S, WIDTH>,
    ) -> Result<Self, RenderError> {
        scene.check()?;
        if size.width as usize > WIDTH {
            return Err(RenderError::RowTooWide { width: size.width, room: WIDTH });
        }
        settings.check_exposure()?;
        let frame = camera.frame(size.width, size.height)?;
        frame.row_fan(0).ok_or(CameraError::NoWindow)?;
        let clear = figure::clearance(scene, frame.eye)?;
        Ok(Self { scene: *scene, frame, size, settings, clear, workspace })
    }

    /// Answers the size of the picture.
    pub fn size(&self) -> Size {
        self.size
    }

    /// Puts all objects into the row of depths and answers the light of its pixels, from left to right.
    fn light<'r, O: Observer>(
        &'r mut self,
        y: u32,
        slice: &'r Slice<S>,
        observer: &'r mut O,
    ) -> impl Iterator<Item = Rgb<S>> + 'r {
        // No row is longer than WIDTH: `new` has seen to it.
        let (row, _) = self.workspace.row.split_at_mut(WIDTH.min(self.size.width as usize));
        row.fill(Fragment::empty(slice.farthest));
        figure::paint(&self.scene, slice, row, observer);
        let exposure = self.settings.exposure;
        let exposed = exposure != S::ONE;
        shading::light(&self.scene, &self.frame, (y, slice), row, observer)
            .map(move |light| if exposed { light * exposure } else { light })
    }

    /// Answers the colours of row `y`, one for each pixel.
    fn colors<'r, P: Encode, O: Observer>(
        &'r mut self,
        y: u32,
        slice: &'r Slice<S>,
        observer: &'r mut O,
    ) -> impl Iterator<Item = P> + 'r {
        let Settings { transfer, dither, .. } = self.settings;
        let mut rounding = Rounding::of_row(dither, y);
        (0..self.size.width)
            .zip(self.light(y, slice, observer))
            .map(move |(x, light)| rounding.encode(x, light_bits(light), transfer))
    }

    /// Answers the plane of row `y`.
    fn slice(&self, y: u32) -> Result<Slice<S>, RowError> {
        let inside = (y < self.size.height).then(|| Slice::of(&self.frame, y, self.clear));
        inside.flatten().ok_or(RowError::NoSuchRow(y))
    }

    /// Hands each pixel of row `y` its linear light, left to right.
    ///
    /// # Errors
    /// [`RowError::NoSuchRow`] below the picture.
    pub fn shade_row(
        &mut self,
        y: u32,
        observer: &mut impl Observer,
        mut pixel: impl FnMut(u32, Rgb<S>),
    ) -> Result<(), RowError> {
        let slice = self.slice(y)?;
        (0..).zip(self.light(y, &slice, observer)).for_each(|(x, light)| pixel(x, light));
        Ok(())
    }

    /// Renders row `y` into a buffer of the caller's, in any colour that
    /// [`Renderer::render_row`](crate::Renderer::render_row) takes.
    ///
    /// # Errors
    /// [`RowError`] when there is no such row, or the buffer is not exactly as long as it.
    pub fn render_row<P: Encode>(&mut self, y: u32, row: &mut [P]) -> Result<(), RowError> {
        self.watch_row(y, row, &mut ())
    }

    /// Renders row `y` as [`render_row`](Self::render_row) does and tells an observer what it does.
    ///
    /// # Errors
    /// As there.
    pub fn watch_row<P: Encode>(
        &mut self,
        y: u32,
        row: &mut [P],
        observer: &mut impl Observer,
    ) -> Result<(), RowError> {
        RowError::check_length(self.size.width, row.len())?;
        let slice = self.slice(y)?;
        row.iter_mut().zip(self.colors(y, &slice, observer)).for_each(|(place, color)| *place = color);
        Ok(())
    }

    /// Draws the picture at the upper left corner of a display, one `fill_contiguous` a row.
    ///
    /// # Errors
    /// The display's own error, untouched. Drawing again draws the whole picture again.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Encode + PixelColor>,
    {
        let corner = target.bounding_box().top_left;
        self.draw_at(corner, target)
    }

    /// Draws the picture with its upper left corner at a point of the display.
    ///
    /// # Errors
    /// The display's own error, untouched.
    pub fn draw_at<D>(&mut self, corner: Point, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: Encode + PixelColor>,
    {
        let size = Size::new(self.size.width, 1);
        for y in 0..self.size.height {
            // Every row has a plane: `new` has seen to it.
            let Ok(slice) = self.slice(y) else { continue };
            let place = Point::new(corner.x, corner.y.saturating_add(y as i32));
            target.fill_contiguous(&Rectangle::new(place, size), self.colors(y, &slice, &mut ()))?;
        }
        Ok(())
    }
}
