//! Explanations: how the light of one pixel comes about, ray by ray, beside the reference.
//!
//! The core is watched, not imitated: every value is one that it has worked with, told step by step
//! ([`Step`](scanray::trace::Step)) while it traced that very pixel.

mod column;
mod dot;
mod names;
mod parting;
mod svg;
mod text;
mod tree;
mod watcher;

pub use column::Column;
pub use names::Names;
pub use parting::{Parting, parting};
pub use tree::{LightRay, Node};

use crate::shot::{Number, Refusal, Shot};

/// Is a pixel explained.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// What decides the picture.
    pub shot: Shot,
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// The pixel in each number.
    pub columns: Vec<Column>,
    /// The pixel as it ought to be.
    pub reference: Column,
    /// The rays that any of them has.
    pub tree: Vec<Node>,
    /// What the scene's things are called.
    pub names: Names,
}

impl Explanation {
    /// Explains a pixel of a shot in some numbers; the pixel lies in the picture, whose rays go through the
    /// middles of its pixels.
    ///
    /// # Errors
    /// What keeps the core or the reference from drawing it.
    pub fn new(shot: Shot, numbers: &[Number], pixel: [u32; 2]) -> Result<Self, Refusal> {
        let column = |number: &Number| Column::new(&shot, *number, pixel);
        let columns = numbers.iter().map(column).collect::<Result<Vec<_>, _>>()?;
        let reference = Column::new(&shot, Number::Oracle, pixel)?;
        let all: Vec<Column> = columns.iter().chain([&reference]).cloned().collect();
        let (tree, names) = (tree::tree(&all), Names::of(&shot.scene));
        Ok(Self { shot, pixel, columns, reference, tree, names })
    }

    /// Answers the columns, the reference last.
    fn all(&self) -> impl Iterator<Item = &Column> {
        self.columns.iter().chain([&self.reference])
    }

    /// Answers the column that trees are drawn of: the first number's.
    fn drawn(&self) -> &Column {
        self.columns.first().unwrap_or(&self.reference)
    }
}
