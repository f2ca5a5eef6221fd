/// Answers a number from 0 to 1 of a point of the lattice, without any pattern.
fn lattice(point: [i32; 3]) -> f64 {
    let mixed = point.iter().fold(0x9e37_79b9_u32, |hash, c| {
        let hash = (hash ^ *c as u32).wrapping_mul(0x85eb_ca6b);
        (hash ^ hash >> 13).wrapping_mul(0xc2b2_ae35)
    });
    f64::from(mixed ^ mixed >> 16) / f64::from(u32::MAX)
}

/// Answers smooth noise from 0 to 1 with hills a unit wide: values on a lattice, mixed by cubic steps.
fn value([x, y, z]: [f64; 3]) -> f64 {
    let floor = [x, y, z].map(f64::floor);
    let share: [f64; 3] = std::array::from_fn(|i| {
        let t = [x, y, z][i] - floor[i];
        t * t * (3.0 - 2.0 * t)
    });
    let corner = |c: u32| {
        let side = |axis: usize| (c >> axis & 1) as i32;
        let weight = |axis: usize| if side(axis) == 1 { share[axis] } else { 1.0 - share[axis] };
        let point = std::array::from_fn(|axis| floor[axis] as i32 + side(axis));
        weight(0) * weight(1) * weight(2) * lattice(point)
    };
    (0..8).map(corner).sum()
}

/// Answers noise from 0 to 1 with so many layers, each twice as fine and half as strong as the last.
pub(super) fn layered(point: [f64; 3], layers: u32) -> f64 {
    let layer = |k: u32| value(point.map(|c| c * f64::from(1 << k) + 7.3 * f64::from(k))) / f64::from(1 << k);
    (0..layers).map(layer).sum::<f64>() / (2.0 - 2.0 / f64::from(1 << layers))
}
