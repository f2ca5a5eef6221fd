//! A lesson's picture: the cells that discrete walks visit along the same line, as cubes.

use crate::shot::Picture;
use embedded_graphics::mono_font::ascii::FONT_6X10;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Line, PrimitiveStyle, Triangle};
use scanray::volume::walks::{Bresenham, Cell, Cohen, Tripod};

/// Is the columns and rows of one walk's picture.
const PANEL: [u32; 2] = [350, 260];

/// Is the cells that the walks lead between.
const ENDS: [Cell; 2] = [[0, 0, 5], [11, 4, 0]];

/// Is the points between which the tripod goes, in 256ths of a cell: in the same cells, off their middles.
const POINTS: [[i32; 3]; 2] = [[60, 230, 5 * 256 + 20], [11 * 256 + 30, 4 * 256 + 20, 240]];

/// Is a point in space, in cells.
type Place = [f64; 3];

/// Is a walk with the line that it follows.
struct Walk {
    label: String,
    cells: Vec<Cell>,
    line: [Place; 2],
}

/// Draws the three walks side by side.
pub fn sheet() -> Picture {
    let walks = walks();
    let mut page = Picture::filled([PANEL[0] * walks.len() as u32, PANEL[1]], [0; 3]);
    for (place, walk) in (0..).zip(&walks) {
        page.paste(&walk.picture(), [place * PANEL[0], 0]);
    }
    page
}

fn walks() -> [Walk; 3] {
    let [from, to] = ENDS;
    let line = ENDS.map(|cell| cell.map(|place| f64::from(place) + 0.5));
    let points = POINTS.map(|point| point.map(|place| f64::from(place) / f64::from(Tripod::STEPS)));
    [
        Walk::new("Bresenham", "corners", Bresenham::new(from, to).collect(), line),
        Walk::new("Cohen", "faces", Cohen::new(from, to).collect(), line),
        Walk::new("tripod, off the middles", "faces", Tripod::new(POINTS[0], POINTS[1]).collect(), points),
    ]
}

impl Walk {
    fn new(name: &str, through: &str, cells: Vec<Cell>, line: [Place; 2]) -> Self {
        let label = format!("{name}: {} cells, through {through}", cells.len());
        Self { label, cells, line }
    }

    /// Draws the cells as cubes from the back to the front, the line over them, and the frames of the cells that the
    /// line goes through and the walk leaves out.
    fn picture(&self) -> Picture {
        let mut panel = Picture::filled(PANEL, [24, 26, 32]);
        ground(&mut panel);
        let mut cells: Vec<(usize, Cell)> = self.cells.iter().copied().enumerate().collect();
        cells.sort_by_key(|(_, cell)| cell.iter().sum::<i32>());
        for (number, cell) in cells {
            cube(&mut panel, cell, number.is_multiple_of(2));
        }
        for cell in left_out(&self.cells) {
            frame(&mut panel, cell);
        }
        let [from, to] = self.line.map(on_paper);
        stroke(&mut panel, [from, to], Rgb888::WHITE, 2);
        panel.write_text(&self.label, [12, 10], &FONT_6X10);
        panel
    }
}

/// Lists the cells that the line between the middles goes through and a walk leaves out.
fn left_out(cells: &[Cell]) -> Vec<Cell> {
    let through: Vec<Cell> = Cohen::new(ENDS[0], ENDS[1]).collect();
    // A walk through faces leaves nothing out along its own line.
    if cells.len() >= through.len() {
        return vec![];
    }
    through.into_iter().filter(|cell| !cells.contains(cell)).collect()
}

/// Answers where a point lies on the paper, seen along (-1, -1, -1): x runs to the right, z to the left.
fn on_paper([x, y, z]: Place) -> Point {
    const SCALE: f64 = 19.0;
    let (across, down) = ((x - z) * 0.866 * SCALE, ((x + z) / 2.0 - y) * SCALE);
    Point::new(125 + across.round() as i32, 75 + down.round() as i32)
}

/// Draws the squares of the floor under the line.
fn ground(panel: &mut Picture) {
    let [x, z] = [ENDS[1][0], ENDS[0][2]].map(|place| f64::from(place) + 1.0);
    let color = Rgb888::new(58, 62, 72);
    for i in 0..=x as i32 {
        let i = f64::from(i);
        stroke(panel, [on_paper([i, 0.0, 0.0]), on_paper([i, 0.0, z])], color, 1);
    }
    for k in 0..=z as i32 {
        let k = f64::from(k);
        stroke(panel, [on_paper([0.0, 0.0, k]), on_paper([x, 0.0, k])], color, 1);
    }
}

/// Answers the corner of a cell that is so far along each axis.
fn corner(cell: Cell, offsets: [i32; 3]) -> Point {
    on_paper([0, 1, 2].map(|axis| f64::from(cell[axis] + offsets[axis])))
}

/// Draws a cube by its three faces that are seen; every second one is darker.
fn cube(panel: &mut Picture, cell: Cell, even: bool) {
    const FACES: [([[i32; 3]; 4], u8); 3] = [
        ([[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]], 255),
        ([[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]], 175),
        ([[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], 120),
    ];
    let base: [u16; 3] = if even { [240, 170, 70] } else { [205, 120, 60] };
    for (corners, light) in FACES {
        let shade = |level: u16| (level * u16::from(light) / 255) as u8;
        let color = Rgb888::new(shade(base[0]), shade(base[1]), shade(base[2]));
        let [a, b, c, d] = corners.map(|offsets| corner(cell, offsets));
        for triangle in [Triangle::new(a, b, c), Triangle::new(a, c, d)] {
            let Ok(()) = triangle.into_styled(PrimitiveStyle::with_fill(color)).draw(panel);
        }
        for edge in [[a, b], [b, c], [c, d], [d, a]] {
            stroke(panel, edge, Rgb888::new(60, 36, 20), 1);
        }
    }
}

/// Draws the edges of a cell.
fn frame(panel: &mut Picture, cell: Cell) {
    for axis in 0..3 {
        for other in 0..4 {
            let ends = [0, 1].map(|end| {
                let mut offsets = [other & 1, other >> 1, 0];
                offsets[2] = end;
                offsets.rotate_right(axis);
                corner(cell, offsets)
            });
            stroke(panel, ends, Rgb888::new(110, 190, 255), 1);
        }
    }
}

fn stroke(panel: &mut Picture, [from, to]: [Point; 2], color: Rgb888, width: u32) {
    let Ok(()) = Line::new(from, to).into_styled(PrimitiveStyle::with_stroke(color, width)).draw(panel);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bresenhams_walk_leaves_out_what_the_others_visit_beyond_its_own() {
        let [bresenham, cohen, tripod] = walks();
        assert_eq!([&bresenham, &cohen, &tripod].map(|walk| walk.cells.len()), [12, 21, 21]);
        assert!(left_out(&bresenham.cells).len() >= 9);
        assert!(left_out(&cohen.cells).is_empty() && left_out(&tripod.cells).is_empty());
        assert_ne!(cohen.cells, tripod.cells, "another line through the same ends");
    }
}
