//! Discrete walks begin and end where they ought to, hang together and miss what they say they miss.

use scanray::volume::walks::{Bresenham, Cell, Cohen, Tripod};

/// Lists cells on all sides of the origin.
fn ends() -> impl Iterator<Item = Cell> {
    let along = |n: i32| [-7, -5, -4, -2, -1, 0, 1, 3, 6][n as usize];
    (0..9 * 9 * 9).map(move |n| [along(n % 9), along(n / 9 % 9), along(n / 81)])
}

/// Answers by how much two cells differ along each axis.
fn apart(a: Cell, b: Cell) -> [i32; 3] {
    [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs())
}

/// Answers the most that neighbours of a walk differ along one axis, and along all of them together.
fn strides(walk: &[Cell]) -> [i32; 2] {
    walk.windows(2)
        .map(|pair| apart(pair[0], pair[1]))
        .fold([0, 0], |[most, sum], [x, y, z]| [most.max(x).max(y).max(z), sum.max(x + y + z)])
}

/// Tells whether a line between two points goes through the inside of a cell; all is counted in so many parts of a cell.
///
/// Its shares of the way through the three slabs are compared as fractions, so that nothing is rounded.
fn goes_through(from: [i64; 3], to: [i64; 3], cell: Cell, parts: i64, open: bool) -> bool {
    // The interval of shares inside all slabs so far, as fractions of positive denominators.
    let (mut enter, mut leave) = ((0_i64, 1_i64), (1_i64, 1_i64));
    let less = |(a, b): (i64, i64), (c, d): (i64, i64)| a * d < c * b;
    for axis in 0..3 {
        let (low, way) = (i64::from(cell[axis]) * parts, to[axis] - from[axis]);
        let (mut first, mut last) = (low - from[axis], low + parts - from[axis]);
        if way == 0 {
            if first > 0 || last < 0 || open && (first == 0 || last == 0) {
                return false;
            }
            continue;
        }
        if way < 0 {
            (first, last) = (-last, -first);
        }
        let (first, last) = ((first, way.abs()), (last, way.abs()));
        if less(enter, first) {
            enter = first;
        }
        if less(last, leave) {
            leave = last;
        }
    }
    if open { less(enter, leave) } else { !less(leave, enter) }
}

/// Lists the cells of the box around two cells.
fn box_of(a: Cell, b: Cell) -> impl Iterator<Item = Cell> {
    let range = move |axis: usize| a[axis].min(b[axis])..=a[axis].max(b[axis]);
    range(0).flat_map(move |x| range(1).flat_map(move |y| range(2).map(move |z| [x, y, z])))
}

/// Checks a walk through faces against all cells around.
#[track_caller]
fn assert_complete(walk: &[Cell], from: [i64; 3], to: [i64; 3], parts: i64) {
    let cell = |point: [i64; 3]| point.map(|place| place.div_euclid(parts) as i32);
    let (first, last) = (cell(from), cell(to));
    assert_eq!((walk.first(), walk.last()), (Some(&first), Some(&last)));
    assert_eq!(walk.len() as i32, apart(first, last).iter().sum::<i32>() + 1);
    assert!(strides(walk)[1] <= 1, "{walk:?}");
    for visited in walk {
        assert!(goes_through(from, to, *visited, parts, false), "{visited:?} lies beside the line");
    }
    let missed =
        box_of(first, last).find(|cell| goes_through(from, to, *cell, parts, true) && !walk.contains(cell));
    assert_eq!(missed, None, "from {from:?} to {to:?}");
}

#[test]
fn bresenhams_walk_takes_the_steps_of_the_longest_axis_and_stays_within_half_a_cell_of_the_line() {
    let from = [2, -1, 3];
    for way in ends() {
        let to = [0, 1, 2].map(|axis| from[axis] + way[axis]);
        let walk: Vec<Cell> = Bresenham::new(from, to).collect();
        let longest = way.iter().map(|n| n.abs()).max().unwrap_or(0);
        assert_eq!((walk.first(), walk.last(), walk.len() as i32), (Some(&from), Some(&to), longest + 1));
        assert!(strides(&walk)[0] <= 1, "26-connected: {walk:?}");
        for (step, cell) in (0..).zip(&walk) {
            for axis in 0..3 {
                let off = 2 * ((cell[axis] - from[axis]) * longest - way[axis] * step);
                assert!(off.abs() <= longest, "{cell:?} of {walk:?}");
            }
        }
    }
}

#[test]
fn cohens_walk_visits_every_cell_that_the_line_goes_through() {
    for to in ends() {
        let walk: Vec<Cell> = Cohen::new([0; 3], to).collect();
        let middle = |cell: Cell| cell.map(|place| 2 * i64::from(place) + 1);
        assert_complete(&walk, middle([0; 3]), middle(to), 2);
    }
}

#[test]
fn the_tripod_between_middles_goes_where_cohens_walk_goes() {
    for to in ends() {
        assert!(Tripod::between([1, 2, -3], to).eq(Cohen::new([1, 2, -3], to)), "{to:?}");
    }
}

#[test]
fn the_tripod_visits_every_cell_between_any_two_points() {
    let scattered = |seed: u32, n: u32| {
        let bits =
            |k: u32| (n * 3 + k).wrapping_mul(0x9e37_79b9 ^ seed).rotate_left(11).wrapping_mul(0x85eb_ca6b);
        // Every fourth lies on a plane between cells.
        let place = |k: u32| bits(k) as i32 >> 20;
        [0, 1, 2].map(|k| if bits(k) & 3 == 0 { place(k) & !255 } else { place(k) })
    };
    for n in 0..400 {
        let (from, to) = (scattered(1, n), scattered(77, n));
        let walk: Vec<Cell> = Tripod::new(from, to).collect();
        assert_complete(&walk, from.map(i64::from), to.map(i64::from), 256);
    }
}

#[test]
fn walks_from_end_to_end_of_all_integers_begin() {
    let (low, high) = ([i32::MIN; 3], [i32::MAX; 3]);
    assert_eq!(Bresenham::new(low, high).nth(2), Some([i32::MIN + 2; 3]));
    assert_eq!(Cohen::new(low, high).nth(3), Some([i32::MIN + 1; 3]));
    assert_eq!(Tripod::new(low, high).nth(3), Some([i32::MIN / 256 + 1; 3]));
}
