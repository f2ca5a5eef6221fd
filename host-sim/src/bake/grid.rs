use super::Bounds;
use super::boxes::{Boxes, Steps};
use super::lists::Lists;
use crate::rounded::Rounded;
use scanray::accel;

/// Is how many cells there are for a thing.
const DENSITY: f64 = 4.0;

/// Is how many cells lie along an axis, at most.
const MOST: u16 = 256;

/// Is a box of equal cubes, about as many along each axis as the cube root of their number.
#[derive(Clone, Debug)]
pub struct Grid {
    boxes: Boxes,
    size: u16,
    cells: [u16; 3],
    content: Vec<u16>,
    lists: Lists,
}

impl Grid {
    /// Builds the grid over things that lie in boxes, at most 65535.
    pub fn build(things: &[Bounds]) -> Self {
        // Where there are more lists than a cell can name, larger cells have fewer.
        let densities = std::iter::successors(Some(DENSITY), |density| Some(density / 2.0));
        densities
            .map(|density| Self::with_density(things, density))
            .find(|grid| grid.lists.len() <= 65_535)
            .unwrap()
    }

    fn with_density(things: &[Bounds], density: f64) -> Self {
        let boxes = Boxes::new(things);
        let most = density * things.len() as f64;
        let (size, cells) = if things.is_empty() { (1, [0; 3]) } else { cut(&boxes.whole, most) };
        let mut grid = Self { boxes, size, cells, content: vec![], lists: Lists::new() };
        for list in grid.held() {
            let number = grid.lists.number(list);
            grid.content.push(number);
        }
        grid
    }

    /// Answers what each cell holds.
    fn held(&self) -> Vec<Vec<u16>> {
        let [columns, rows, layers] = self.cells.map(usize::from);
        let mut held = vec![vec![]; columns * rows * layers];
        for ([low, high], thing) in self.boxes.each.iter().zip(0..) {
            // A box that ends where a cell begins does not reach into it.
            let cell = |step: u16, axis: usize| usize::from((step - self.boxes.whole[0][axis]) / self.size);
            let [x, y, z] = [0, 1, 2].map(|axis| cell(low[axis], axis)..=cell(high[axis] - 1, axis));
            for (layer, row) in z.flat_map(|layer| y.clone().map(move |row| (layer, row))) {
                for column in x.clone() {
                    held[(layer * rows + row) * columns + column].push(thing);
                }
            }
        }
        held
    }

    /// Answers the grid in a number; its lists live as long as the program.
    pub fn leak<S: Rounded>(&self) -> accel::Grid<S> {
        accel::Grid {
            lattice: self.boxes.cube.lattice(),
            low: self.boxes.whole[0],
            size: self.size,
            cells: self.cells,
            content: self.content.clone().leak(),
            count: self.boxes.each.len() as u16,
            lists: self.lists.leak(),
        }
    }

    /// Counts the bytes that the grid takes in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.content) + self.lists.bytes()
    }
}

/// Answers the smallest cells that a box is cut into no more than `most` of, by their size, and how many of
/// them lie along each axis. Of a cube, that is the cube root of `most`.
fn cut([low, high]: &Steps, most: f64) -> (u16, [u16; 3]) {
    let along = |size: u16| [0, 1, 2].map(|axis| (high[axis] - low[axis]).div_ceil(size).max(1));
    let fits = |cells: [u16; 3]| {
        cells.iter().all(|cells| *cells <= MOST) && cells.into_iter().map(f64::from).product::<f64>() <= most
    };
    let size = (1..u16::MAX).find(|size| fits(along(*size))).unwrap_or(u16::MAX);
    (size, along(size))
}
