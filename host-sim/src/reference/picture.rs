use super::account::{Account, Notes};
use super::camera::Lens;
use super::description::{Description, Output};
use super::display::Display;
use super::trail::{Trail, silhouettes};
use super::vector::Vector;
use std::iter;
use std::num::NonZero;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{self, Sender};
use std::thread::{self, Builder};

/// Is a picture as it ought to be, row by row from the top.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Linear light of every pixel after exposure.
    pub light: Vec<Vector>,
    /// What every pixel's ray and its reflections met.
    pub trails: Vec<Trail>,
}

type Row = Vec<(Vector, Trail)>;

/// Traces a picture with the reference, on all processors.
///
/// Scene and camera are taken to be sound, as the core's own check finds them. `row_done` is told
/// each finished row, in whatever order they finish.
pub fn trace(description: &Description, size: [u32; 2], mut row_done: impl FnMut(u32)) -> Picture {
    let lens = Lens::of(&description.camera, size);
    let [columns, height] = size;
    let row = |y: u32| -> Row {
        let pixel = |x| {
            let mut notes = Notes::default();
            (look(description, &lens, [x, y], &mut notes), notes.trail)
        };
        (0..columns).map(pixel).collect()
    };
    let mut rows: Vec<Row> = vec![vec![]; height as usize];
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    let (sender, finished) = mpsc::channel();
    let next = AtomicU32::new(0);
    // The receiver lives as long as the scope: sending cannot fail.
    let work = |sender: Sender<(u32, Row)>| {
        let rows = iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed)).take_while(|y| *y < height);
        rows.map(|y| (y, row(y))).try_for_each(|row| sender.send(row))
    };
    thread::scope(|scope| {
        let start = |sender| Builder::new().spawn_scoped(scope, move || work(sender)).is_ok();
        let started = (0..workers).filter(|_| start(sender.clone())).count();
        if started == 0 {
            // A browser hands out no threads.
            let _ = work(sender.clone());
        }
        drop(sender);
        for (y, pixels) in finished {
            rows[y as usize] = pixels;
            row_done(y);
        }
    });
    let (light, trails) = rows.into_iter().flatten().unzip();
    Picture { size, light, trails }
}

/// Answers how the light of the pixel in column `x` and row `y` comes about.
pub fn account(description: &Description, size: [u32; 2], pixel: [u32; 2]) -> Account {
    let mut notes = Notes::with_account();
    let light = look(description, &Lens::of(&description.camera, size), pixel, &mut notes);
    notes.into_account(light)
}

/// Answers the light of a pixel.
fn look(description: &Description, lens: &Lens, [x, y]: [u32; 2], notes: &mut Notes) -> Vector {
    let ray = lens.ray(x, y);
    description.seen_along(&ray, |point| lens.sees(point), lens.span(&ray), notes)
}

impl Picture {
    /// Answers what a panel shows, in 8 bits a channel, with exact curves and thresholds.
    pub fn on_panel(&self, output: Output) -> Vec<[u8; 3]> {
        let display = Display::of(output);
        let columns = self.size[0].max(1) as usize;
        let rows = self.light.chunks(columns).enumerate();
        rows.flat_map(|(y, light)| display.row(light, y)).collect()
    }

    /// Answers the picture each of whose pixels is the mean of `side` x `side` pixels of this one (row S1), and
    /// whose trails are theirs, one after the other.
    pub fn averaged(&self, side: u32) -> Self {
        let [columns, rows] = self.size.map(|n| n / side);
        let pixels = (0..rows).flat_map(|y| (0..columns).map(move |x| [x, y])).map(|[x, y]| {
            let squares =
                (0..side * side).map(|n| (y * side + n / side) * self.size[0] + x * side + n % side);
            let places: Vec<usize> = squares.map(|place| place as usize).collect();
            let sum = places.iter().fold(Vector::default(), |sum, place| sum + self.light[*place]);
            let trail = places.iter().flat_map(|place| self.trails[*place].clone()).collect();
            (sum * (1.0 / f64::from(side * side)), trail)
        });
        let (light, trails) = pixels.unzip();
        Self { size: [columns, rows], light, trails }
    }

    /// Marks the pixels beside an edge of whatever is seen: of an object, a face, a tile, a shadow
    /// or any of these in a mirror.
    pub fn silhouettes(&self) -> Vec<bool> {
        silhouettes(&self.trails, self.size)
    }
}
