use super::noise::layered;
use super::on_ball;

/// Answers n directions spread evenly over a ball: a spiral of golden angles.
fn spread(n: u32) -> impl Iterator<Item = [f64; 3]> {
    (0..n).map(move |i| {
        let up = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(n);
        let (across, turn) = ((1.0 - up * up).sqrt(), 2.399_963_229_728_653 * f64::from(i));
        [across * turn.cos(), up, across * turn.sin()]
    })
}

/// Answers the height of a crater at a distance from its middle, in its radii: a bowl with a rim.
fn crater(distance: f64) -> f64 {
    let bowl = -1.0 + 1.5 * distance * distance;
    let rim = 0.5 * (1.0 - (distance - 1.0) / 0.6);
    if distance < 1.0 { bowl } else { rim.max(0.0) * rim.max(0.0) * 2.0 }
}

/// Answers the height of a small moon with craters of three sizes.
pub(super) fn craters(u: f64, v: f64) -> f64 {
    let direction = on_ball(u, v);
    let depth = |(i, center): (usize, [f64; 3])| {
        let size = [0.40, 0.24, 0.30, 0.20][i % 4];
        let square: f64 = (0..3).map(|k| (direction[k] - center[k]) * (direction[k] - center[k])).sum();
        size * crater(square.sqrt() / size)
    };
    let hills = layered(direction.map(|c| 1.7 * c + 2.0), 3) - 0.5;
    0.66 + spread(30).enumerate().map(depth).sum::<f64>() + 0.9 * hills
}

/// Answers the height of an orange's peel, which repeats beyond its rims.
pub(super) fn peel(u: f64, v: f64) -> f64 {
    // Around two rings in space the noise comes back to where it began.
    let turn = |t: f64| [(t * std::f64::consts::TAU).cos(), (t * std::f64::consts::TAU).sin()];
    let ([a, b], [c, d]) = (turn(u), turn(v));
    let first = layered([1.7 * a + 3.0, 1.7 * b, 1.3 * c], 2);
    let second = layered([1.7 * c + 9.0, 1.7 * d, 1.3 * a + 5.0], 2);
    (first + second - 0.6) * 1.3
}

/// Computes normals of a round dimple in the middle of a flat square, as `Rgb888`.
pub(super) fn dimples(side: u32) -> Vec<u8> {
    let normal = |[u, v]: [f64; 2]| {
        let [x, y] = [u - 0.5, v - 0.5].map(|c| c / 0.44);
        let square = x * x + y * y;
        // A bowl whose walls are steepest halfway and which meets the rim without an edge.
        let steepness = if square < 1.0 { 3.2 * (1.0 - square) } else { 0.0 };
        let (x, y) = (-steepness * x, -steepness * y);
        let length = (x * x + y * y + 1.0).sqrt();
        [x, y, 1.0].map(|c| ((c / length + 1.0) / 2.0 * 255.0).round() as u8)
    };
    super::places([side, side]).flat_map(normal).collect()
}
