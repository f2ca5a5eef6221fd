use super::{Crowd, Sample};
use crate::bake::Accel;
use crate::shot::Picture;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, Line, PrimitiveStyle};
use embedded_graphics::text::{Alignment, Text};

/// Width and height of a diagram's field in pixels, and what is left free around it for text.
const FIELD: [i32; 2] = [380, 300];
const MARGIN: [i32; 2] = [52, 40];
const RIGHT: i32 = 56;

/// Lines are drawn four times as large and shrunk, so that they are smooth.
const FINE: i32 = 4;

const PAPER: Rgb888 = Rgb888::new(22, 24, 28);
const GRID: Rgb888 = Rgb888::new(52, 56, 64);
const INK: Rgb888 = Rgb888::new(214, 218, 224);

fn color(accel: Accel) -> Rgb888 {
    match accel {
        Accel::Bvh => Rgb888::new(255, 196, 61),
        Accel::Kd => Rgb888::new(92, 200, 255),
        Accel::Octree => Rgb888::new(120, 220, 130),
        Accel::Grid => Rgb888::new(240, 120, 200),
        Accel::None => Rgb888::new(150, 156, 166),
    }
}

/// Draws the time of a ray in `f32` against the number of things, both by powers of ten, a diagram for each
/// crowd.
pub fn plot(samples: &[Sample]) -> Picture {
    let diagrams: Vec<Diagram<'_>> = Crowd::ALL.iter().map(|crowd| Diagram::new(*crowd, samples)).collect();
    let [width, height] = [MARGIN[0] + FIELD[0] + RIGHT, 2 * MARGIN[1] + FIELD[1]];
    let columns = diagrams.len() as i32;
    let paper = [PAPER.r(), PAPER.g(), PAPER.b()];
    let mut fine = Picture::filled([(columns * width * FINE) as u32, (height * FINE) as u32], paper);
    for (diagram, left) in diagrams.iter().zip((0..).step_by(width as usize)) {
        diagram.draw_lines(&mut fine, Point::new(left + MARGIN[0], MARGIN[1]));
    }
    let mut page = shrunk(&fine);
    for (diagram, left) in diagrams.iter().zip((0..).step_by(width as usize)) {
        diagram.write(&mut page, Point::new(left + MARGIN[0], MARGIN[1]));
    }
    page
}

/// Is what is drawn of one crowd.
struct Diagram<'s> {
    crowd: Crowd,
    samples: Vec<&'s Sample>,
    /// The lowest power of ten shown along each axis, and the one after the highest.
    powers: [[i32; 2]; 2],
}

/// Answers the time of a ray, in nanoseconds: of one above 0 there is a logarithm.
fn nanoseconds(sample: &Sample) -> f64 {
    (sample.time.as_nanos() as f64).max(1.0)
}

impl<'s> Diagram<'s> {
    fn new(crowd: Crowd, samples: &'s [Sample]) -> Self {
        let samples: Vec<&Sample> = samples.iter().filter(|sample| sample.crowd == crowd).collect();
        let range = |values: Vec<f64>| {
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(1.0, f64::max);
            let low = low.min(high).log10().floor() as i32;
            [low, (high.log10().ceil() as i32).max(low + 1)]
        };
        let things = samples.iter().map(|sample| sample.things as f64).collect();
        let times = samples.iter().map(|sample| nanoseconds(sample)).collect();
        Self { crowd, powers: [range(things), range(times)], samples }
    }

    /// Answers a value's place in the field, from 0 at its lower left corner, in pixels.
    fn along(&self, axis: usize, value: f64) -> f64 {
        let [low, high] = self.powers[axis].map(f64::from);
        (value.log10() - low) / (high - low) * f64::from(FIELD[axis])
    }

    fn place(&self, things: f64, time: f64) -> [f64; 2] {
        [self.along(0, things), f64::from(FIELD[1]) - self.along(1, time)]
    }

    /// Answers the samples of a kind, from few things to many.
    fn curve(&self, accel: Accel) -> impl Iterator<Item = [f64; 2]> + '_ {
        let samples = self.samples.iter().filter(move |sample| sample.accel == accel);
        samples.map(|sample| self.place(sample.things as f64, nanoseconds(sample)))
    }

    /// Answers the powers of ten of an axis.
    fn tens(&self, axis: usize) -> impl Iterator<Item = f64> + use<> {
        let [low, high] = self.powers[axis];
        (low..=high).map(|power| 10_f64.powi(power))
    }

    fn draw_lines(&self, page: &mut Picture, corner: Point) {
        let fine = |[x, y]: [f64; 2]| {
            let scale = f64::from(FINE);
            Point::new((x * scale) as i32, (y * scale) as i32) + corner * FINE
        };
        let [width, height] = FIELD.map(f64::from);
        let mut line = |from: [f64; 2], to: [f64; 2], color, stroke| {
            let line = Line::new(fine(from), fine(to));
            let Ok(()) = line.into_styled(PrimitiveStyle::with_stroke(color, stroke)).draw(page);
        };
        for x in self.tens(0).map(|things| self.along(0, things)) {
            line([x, 0.0], [x, height], GRID, 4);
        }
        for y in self.tens(1).map(|time| height - self.along(1, time)) {
            line([0.0, y], [width, y], GRID, 4);
        }
        for accel in Accel::ALL {
            let points: Vec<[f64; 2]> = self.curve(accel).collect();
            for pair in points.windows(2) {
                line(pair[0], pair[1], color(accel), 7);
            }
        }
        for accel in Accel::ALL {
            for point in self.curve(accel) {
                let dot = Circle::with_center(fine(point), 6 * FINE as u32);
                let Ok(()) = dot.into_styled(PrimitiveStyle::with_fill(color(accel))).draw(page);
            }
        }
    }

    fn write(&self, page: &mut Picture, corner: Point) {
        let [width, height] = FIELD;
        let mut text = |text: &str, x: i32, y: i32, color, alignment| {
            let style = MonoTextStyle::new(&FONT_6X10, color);
            let Ok(_) = Text::with_alignment(text, corner + Point::new(x, y), style, alignment).draw(page);
        };
        text("nanoseconds for a ray", -MARGIN[0] + 8, -22, INK, Alignment::Left);
        text(self.crowd.name(), width / 2, height + 32, INK, Alignment::Center);
        for things in self.tens(0) {
            text(&short(things), self.along(0, things) as i32, height + 16, INK, Alignment::Center);
        }
        for time in self.tens(1) {
            let y = height - self.along(1, time) as i32;
            text(&short(time), -8, y + 3, INK, Alignment::Right);
        }
        for (accel, y) in apart(self.ends()) {
            text(accel.name(), width + 6, y + 3, color(accel), Alignment::Left);
        }
    }

    /// Answers how far down each curve ends.
    fn ends(&self) -> Vec<(Accel, i32)> {
        let end = |accel: Accel| self.curve(accel).last().map(|[_, y]| (accel, y as i32));
        Accel::ALL.into_iter().filter_map(end).collect()
    }
}

/// Moves names apart that would lie on each other, downward.
fn apart(mut names: Vec<(Accel, i32)>) -> Vec<(Accel, i32)> {
    const LINE: i32 = 12;
    names.sort_by_key(|(_, y)| *y);
    let mut free = i32::MIN;
    for (_, y) in &mut names {
        *y = free.max(*y);
        free = *y + LINE;
    }
    names
}

/// Writes a power of ten in few digits.
fn short(value: f64) -> String {
    match value {
        1e6.. => format!("{}M", value / 1e6),
        1e3.. => format!("{}k", value / 1e3),
        _ => format!("{value}"),
    }
}

/// Takes the mean of each square of `FINE` pixels.
fn shrunk(fine: &Picture) -> Picture {
    let [columns, rows] = fine.size.map(|side| side / FINE as u32);
    let mut page = Picture::filled([columns, rows], [0; 3]);
    let across = fine.size[0] as usize;
    for (i, pixel) in page.pixels.iter_mut().enumerate() {
        let (x, y) = (i % columns as usize * FINE as usize, i / columns as usize * FINE as usize);
        let mut sum = [0_u32; 3];
        for row in fine.pixels.chunks(across).skip(y).take(FINE as usize) {
            for fine in &row[x..x + FINE as usize] {
                sum = [0, 1, 2].map(|c| sum[c] + u32::from(fine[c]));
            }
        }
        *pixel = sum.map(|sum| (sum / (FINE * FINE) as u32) as u8);
    }
    page
}
