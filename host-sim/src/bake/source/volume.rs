//! Fields in source: the values of voxels as rows of data, and what they look like.

use super::layout::Layout;
use super::literal::Literal;
use super::pool::Pool;
use crate::bake::Bill;
use scanray::{Class, Gradient, Grid, Reconstruction, Volume, Voxels};

/// Writes the volume of a scene, and the classes that it borrows.
pub(super) fn write<S: Literal>(
    volume: &Volume<S>,
    pool: &mut Pool<'_, S>,
    layout: &mut Layout,
    bill: &mut Bill,
) {
    bill.volumes += size_of_val(volume) + size_of_val(volume.classes);
    let usual = Volume::new(volume.grid, volume.classes, volume.density);
    let (grid, density) = (grid(&volume.grid, pool), volume.density.number());
    let mut item = format!(
        "static VOLUME: Volume<{}> = Volume::new(\n    {grid},\n    &CLASSES,\n    {density},\n)",
        S::NAME
    );
    if volume.reconstruction != usual.reconstruction {
        item += &format!("\n.with_reconstruction({})", reconstruction(volume.reconstruction));
    }
    if volume.samples != usual.samples {
        item += &format!("\n.with_samples({})", volume.samples);
    }
    if volume.gradient != usual.gradient {
        item += &format!("\n.with_gradient({})", gradient(volume.gradient));
    }
    if volume.faintest != usual.faintest {
        item += &format!("\n.with_faintest({})", volume.faintest.number());
    }
    layout.item("", &item);
    let classes: Vec<String> = volume.classes.iter().map(class).collect();
    layout.list("CLASSES", &format!("Class<{}>", S::NAME), &classes);
}

fn class<S: Literal>(class: &Class<S>) -> String {
    format!("Class::new({}, {}, {})", class.value, S::color(class.color), class.opacity)
}

/// Writes a grid, of voxels that are borrowed.
pub(super) fn grid<S: Literal>(grid: &Grid<S>, pool: &mut Pool<'_, S>) -> String {
    let [low, spacing] = [grid.low, grid.spacing].map(S::vector);
    format!("Grid::new({}, {low}, {spacing})", pool.voxels(grid.voxels))
}

fn reconstruction(reconstruction: Reconstruction) -> &'static str {
    match reconstruction {
        Reconstruction::Nearest => "Reconstruction::Nearest",
        Reconstruction::Trilinear => "Reconstruction::Trilinear",
    }
}

/// Writes how normals are found.
pub(super) fn gradient(gradient: Gradient) -> &'static str {
    match gradient {
        Gradient::First => "Gradient::First",
        Gradient::Second => "Gradient::Second",
    }
}

/// Writes voxels with their blocks, whether those were there or not: the picture is the same.
pub(super) fn write_voxels(place: usize, voxels: &Voxels, layout: &mut Layout, bill: &mut Bill) {
    let values: Vec<u8> = places(voxels.sides()).map(|voxel| voxels.value(voxel)).collect();
    let blocks: Vec<u8> = places(voxels.block_sides()).flat_map(|block| voxels.extremes(block)).collect();
    bill.voxels += values.len() + blocks.len();
    bill.voxel_count += values.len();
    let item = format!(
        "const VOXELS_{place}: Voxels = Voxels::new({:?}, &VALUES_{place}).with_blocks(&BLOCKS_{place})",
        voxels.sides()
    );
    layout.item("", &item);
    for (name, bytes) in [("VALUES", values), ("BLOCKS", blocks)] {
        layout.rows(&format!("{name}_{place}"), "u8", bytes.iter().map(u8::to_string));
    }
}

/// Lists places of a grid: x runs fastest, then y, then z.
fn places([columns, rows, layers]: [u16; 3]) -> impl Iterator<Item = [u16; 3]> {
    let row = move |y, z| (0..columns).map(move |x| [x, y, z]);
    (0..layers).flat_map(move |z| (0..rows).flat_map(move |y| row(y, z)))
}
