use super::noise::layered;
use super::on_ball;

/// Answers a colour between two.
fn mix(from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share.clamp(0.0, 1.0))
}

/// Answers the colour of a world with seas, lands, deserts and ice at its poles, sRGB levels.
pub(super) fn color(u: f64, v: f64) -> [f64; 3] {
    let direction = on_ball(u, v);
    let height = layered(direction.map(|c| 1.6 * c + 4.1), 5);
    let latitude = direction[1].abs() + 0.25 * (layered(direction.map(|c| 4.0 * c), 3) - 0.5);
    let sea = mix([0.02, 0.10, 0.35], [0.15, 0.45, 0.70], (height - 0.25) / 0.27);
    let green = mix([0.70, 0.62, 0.35], [0.13, 0.42, 0.15], latitude * 2.2);
    let land = mix(green, [0.45, 0.36, 0.28], (height - 0.60) / 0.08);
    let coast = mix(sea, land, (height - 0.515) / 0.01);
    mix(coast, [0.95, 0.97, 1.0], (latitude - 0.80) / 0.06)
}
