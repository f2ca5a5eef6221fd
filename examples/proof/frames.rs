//! What is drawn for proof, on a chip and on the host alike: a scene of the gallery in every way the core has.

use core::cell::Cell;
use core::convert::Infallible;
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb666, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::accel::{Grid, Hierarchy, Kd, KdNode, Lattice, Lists, Octant, Octree};
use scanray::gallery::View;
use scanray::output::BLUE_NOISE;
use scanray::render::Quality;
use scanray::{
    Adaptive, AtEdges, Camera, Dither, Encode, Exact, Jittered, Progress, RasterRenderer, RasterWorkspace,
    RenderError, Renderer, Scalar, Scene, Settings, Uniform, Vec3, Workspace,
};

/// Counts the columns of a picture.
const WIDTH: usize = 40;

/// Is the size of the pictures: small, as there are hundreds of them on a chip without floating point.
const SIZE: Size = Size::new(WIDTH as u32, 30);

/// Counts the bounces that the gallery's rays may take at most.
const DEPTH: usize = 5;

/// Names the ways in which a scene is drawn, in the order in which they are.
pub const WAYS: [&str; 10] = [
    "exact",
    "adaptive",
    "uniform",
    "jittered",
    "at-edges",
    "progressive",
    "panels",
    "turned",
    "hierarchies",
    "raster",
];

/// Answers the bytes that the caller holds for a way of drawing, which are not the core's stack: the workspace, the
/// renderer, the row where that is the caller's, and the hierarchies that are made for the scene.
#[cfg(target_os = "none")]
pub const fn held_bytes<S: Scalar>(way: usize) -> usize {
    const { assert!(size_of::<Rgb666>() == size_of::<Rgb888>(), "the longest row is that of either") };
    match way {
        6 => tracer_bytes::<S, 0>() + size_of::<[Rgb666; WIDTH]>(),
        8 => {
            let trees = size_of::<Kd<S>>() + size_of::<Octree<S>>() + size_of::<Grid<S>>();
            let scene = size_of::<Scene<'_, S>>();
            tracer_bytes::<S, 0>() + size_of::<[[u8; 2]; WIDTH]>() + trees + scene
        }
        9 => size_of::<RasterWorkspace<S, WIDTH>>() + size_of::<RasterRenderer<'_, '_, S, WIDTH>>(),
        _ => tracer_bytes::<S, WIDTH>(),
    }
}

#[cfg(target_os = "none")]
const fn tracer_bytes<S: Scalar, const ROOM: usize>() -> usize {
    size_of::<Workspace<S, Rgb565, ROOM, DEPTH>>() + size_of::<Renderer<'_, '_, S, Rgb565, ROOM, DEPTH>>()
}

/// Draws a scene in the way of a number, a place in [`WAYS`], and hands the bytes that panels would get to
/// `take`.
///
/// # Errors
/// What the core has against the scene: the z-buffer does not know every shape.
pub fn draw<S: Scalar>(view: &View<S>, way: usize, take: &mut dyn FnMut(&[u8])) -> Result<(), RenderError> {
    match way {
        0 => rows(view, &view.camera, Exact, take),
        1 => rows(view, &view.camera, Adaptive, take),
        2 => rows(view, &view.camera, Uniform(2), take),
        3 => rows(view, &view.camera, Jittered(2), take),
        4 => rows(view, &view.camera, AtEdges(Uniform(2)), take),
        5 => refined(view, take),
        6 => panels(view, take),
        7 => rows(view, &view.camera.turned(7, 72), Exact, take),
        8 => hierarchies(view, take),
        _ => raster(view, take),
    }
}

/// Answers the renderer where it is: `?` alone would move it, and the stack would hold it twice.
fn in_place<R>(made: &mut Result<R, RenderError>) -> Result<&mut R, RenderError> {
    made.as_mut().map_err(|error| *error)
}

/// Draws through a `DrawTarget`, row by row.
#[inline(never)]
fn rows<S: Scalar, Q: Quality>(
    view: &View<S>,
    camera: &Camera<S>,
    quality: Q,
    take: &mut dyn FnMut(&[u8]),
) -> Result<(), RenderError> {
    let mut space = Workspace::<S, Rgb565, WIDTH, DEPTH>::new();
    let mut made = Renderer::new(&view.scene, camera, SIZE, view.settings.with_quality(quality), &mut space);
    let Ok(()) = in_place(&mut made)?.draw(&mut Wire(take));
    Ok(())
}

/// Draws blocks of 16 pixels, then finer ones.
#[inline(never)]
fn refined<S: Scalar>(view: &View<S>, take: &mut dyn FnMut(&[u8])) -> Result<(), RenderError> {
    let mut space = Workspace::<S, Rgb565, WIDTH, DEPTH>::new();
    let mut made = Renderer::new(&view.scene, &view.camera, SIZE, view.settings, &mut space);
    let renderer = in_place(&mut made)?;
    let mut progress = Progress::new(16);
    while let Ok(true) = renderer.refine(&mut progress, &mut Wire(take)) {}
    Ok(())
}

/// Draws each row for another panel, in turn, with another way of rounding.
#[inline(never)]
fn panels<S: Scalar>(view: &View<S>, take: &mut dyn FnMut(&[u8])) -> Result<(), RenderError> {
    let rounded = |dither| view.settings.with_dither(dither);
    let mask = Dither::Mask(&BLUE_NOISE);
    let View { scene, camera, .. } = view;
    let each = |first| (first..SIZE.height).step_by(5);
    striped(scene, camera, rounded(Dither::None), each(0), |color: [u8; 2]| take(&color))?;
    striped(scene, camera, rounded(mask), each(1), |color: Rgb666| {
        take(&color.into_storage().to_le_bytes());
    })?;
    striped(scene, camera, rounded(Dither::Diffused), each(2), |color: Rgb888| {
        take(&color.into_storage().to_le_bytes());
    })?;
    striped(scene, camera, rounded(Dither::Ordered), each(3), |color: Gray4| take(&[color.into_storage()]))?;
    striped(scene, camera, rounded(Dither::Diffused), each(4), |color: BinaryColor| {
        take(&[color.is_on().into()]);
    })
}

/// Draws each row through another hierarchy, in turn, that holds the first object in all its leaves.
#[inline(never)]
fn hierarchies<S: Scalar>(view: &View<S>, take: &mut dyn FnMut(&[u8])) -> Result<(), RenderError> {
    const LISTS: Lists = Lists::new(&[0, 0, 1], &[0]);
    const WHOLE: [[u16; 3]; 2] = [[0; 3], [u16::MAX; 3]];
    const SPLIT: [KdNode; 3] = [
        KdNode::Split { axis: 0, at: 1 << 15, children: 1 },
        KdNode::Leaf { list: 1 },
        KdNode::Leaf { list: 1 },
    ];
    const BRANCH: &[[Octant; 8]] = &[[Octant::leaf(1); 8]];
    let low = S::from_i32(-500);
    let lattice = Lattice::new(Vec3::new(low, low, low), S::from_i32(1000));
    let kd = Kd { lattice, bounds: WHOLE, nodes: &SPLIT, count: 1, lists: LISTS };
    let octree = Octree { lattice, bounds: WHOLE, branches: BRANCH, count: 1, lists: LISTS };
    let (low, size, cells, content) = ([0; 3], 1 << 15, [2; 3], &[1; 8]);
    let grid = Grid { lattice, low, size, cells, content, count: 1, lists: LISTS };
    let trees: [&dyn Hierarchy<S>; 3] = [&kd, &octree, &grid];
    for (first, tree) in (0..SIZE.height).zip(trees) {
        let scene = view.scene.with_hierarchy(tree);
        let rows = (first..SIZE.height).step_by(3);
        striped(&scene, &view.camera, view.settings, rows, |color: [u8; 2]| take(&color))?;
    }
    Ok(())
}

/// Draws some rows into a buffer.
#[inline(never)]
fn striped<S: Scalar, P: Encode>(
    scene: &Scene<'_, S>,
    camera: &Camera<S>,
    settings: Settings<S>,
    rows: impl Iterator<Item = u32>,
    mut take: impl FnMut(P),
) -> Result<(), RenderError> {
    let mut space = Workspace::<S, Rgb565, 0, DEPTH>::new();
    let mut made = Renderer::new(scene, camera, SIZE, settings, &mut space);
    let renderer = in_place(&mut made)?;
    let mut row = [P::DARKEST; WIDTH];
    for y in rows {
        // The row exists and is as long as the picture is wide.
        let _ = renderer.render_row(y, &mut row);
        row.iter().for_each(|color| take(*color));
    }
    Ok(())
}

#[inline(never)]
fn raster<S: Scalar>(view: &View<S>, take: &mut dyn FnMut(&[u8])) -> Result<(), RenderError> {
    let mut space = RasterWorkspace::<S, WIDTH>::new();
    let mut made = RasterRenderer::new(&view.scene, &view.camera, SIZE, view.settings, &mut space);
    let Ok(()) = in_place(&mut made)?.draw(&mut Wire(take));
    Ok(())
}

/// Is a panel that is only the end of a bus: it hands on the bytes that it is sent and keeps none, so that all of the
/// stack is the core's.
struct Wire<'t>(&'t mut dyn FnMut(&[u8]));

impl OriginDimensions for Wire<'_> {
    fn size(&self) -> Size {
        SIZE
    }
}

impl DrawTarget for Wire<'_> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let colors = pixels.into_iter().map(|Pixel(_, color)| color);
        self.fill_contiguous(&self.bounding_box(), colors)
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        _: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        colors.into_iter().for_each(|color| (self.0)(&color.to_be_bytes()));
        Ok(())
    }
}

/// Answers the 32-bit FNV-1a checksum of what is drawn.
///
/// # Errors
/// As [`draw`] does.
pub fn checksum<S: Scalar>(view: &View<S>, way: usize) -> Result<u32, RenderError> {
    let sum = Cell::new(0x811c_9dc5_u32);
    draw(view, way, &mut |bytes| {
        for byte in bytes {
            sum.set((sum.get() ^ u32::from(*byte)).wrapping_mul(0x0100_0193));
        }
    })?;
    Ok(sum.get())
}
