use super::noise::layered;

/// Names the faces' files in the order of [`FACES`].
pub(super) const NAMES: [&str; 6] = [
    "dusk_low_x_32x32.rgb565",
    "dusk_high_x_32x32.rgb565",
    "dusk_low_y_32x32.rgb565",
    "dusk_high_y_32x32.rgb565",
    "dusk_low_z_32x32.rgb565",
    "dusk_high_z_32x32.rgb565",
];

/// Lists the directions that texture coordinates name on each face: `a = m (2u - 1)`, `b = m (2v - 1)`.
pub(super) const FACES: [fn(f64, f64) -> [f64; 3]; 6] = [
    |u, v| [-1.0, 1.0 - 2.0 * u, 1.0 - 2.0 * v],
    |u, v| [1.0, 2.0 * u - 1.0, 2.0 * v - 1.0],
    |u, v| [1.0 - 2.0 * u, -1.0, 1.0 - 2.0 * v],
    |u, v| [2.0 * u - 1.0, 1.0, 2.0 * v - 1.0],
    |u, v| [1.0 - 2.0 * u, 1.0 - 2.0 * v, -1.0],
    |u, v| [2.0 * u - 1.0, 2.0 * v - 1.0, 1.0],
];

/// Is where the sun has just gone down, of unit length but for its height.
const SUN: [f64; 3] = [-0.6, 0.04, -0.8];

fn mix(from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share.clamp(0.0, 1.0))
}

/// Answers what is seen of a dusk in a direction of any length, sRGB levels: a glow, clouds, hills, a lake.
pub(super) fn color(direction: [f64; 3]) -> [f64; 3] {
    let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [x, y, z] = direction.map(|c| c / length);
    let hills = 0.02 + 0.13 * layered([5.0 * x + 3.0, 1.5, 5.0 * z], 3);
    if y < -0.02 {
        // The lake mirrors the sky, darker the steeper it is looked into.
        return mix(sky([x, -y, z]), [0.04, 0.07, 0.12], 0.35 - y);
    }
    let ridge = mix([0.16, 0.10, 0.16], [0.30, 0.15, 0.18], toward_sun([x, y, z]));
    mix(ridge, sky([x, y, z]), (y - hills) / 0.03)
}

/// Answers how much a direction looks toward the sun, from 0 to 1.
fn toward_sun(direction: [f64; 3]) -> f64 {
    let cosine: f64 = (0..3).map(|i| direction[i] * SUN[i]).sum();
    (0.5 + 0.5 * cosine).clamp(0.0, 1.0)
}

fn sky([x, y, z]: [f64; 3]) -> [f64; 3] {
    let near = toward_sun([x, y, z]);
    let low = mix([0.42, 0.36, 0.55], [1.0, 0.55, 0.22], near * near);
    let high = mix([0.06, 0.09, 0.28], [0.30, 0.25, 0.50], near);
    let clear = mix(low, high, y * 1.5);
    // Clouds are flat: seen in a plane above.
    let (across, along) = (x / (y + 0.25), z / (y + 0.25));
    let cloud = layered([1.3 * across, 0.4, 1.3 * along], 3) - 0.48;
    let lit = mix([0.55, 0.40, 0.55], [1.0, 0.72, 0.45], near * near);
    let veiled = mix(clear, lit, cloud * 4.0 * (1.0 - 0.6 * y));
    let glow = near * near;
    let glow = glow * glow * glow * glow;
    mix(veiled, [1.0, 0.93, 0.70], glow * glow * glow * 1.2)
}
