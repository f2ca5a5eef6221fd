use super::image::{Image, Spot, last_texel, levels};
use super::texels::Bitmap;
use crate::hit::Tangent;
use crate::math::{Scalar, Vec3, Wide};

/// Names what the texels of a bump map say.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Relief<S = f32> {
    /// Height above the surface: black is 0, green at its full level this length.
    Heights(S),
    /// A unit normal: red, green and blue are its parts along u, along v and outward, from -1 at level 0
    /// to 1 at level 255.
    Normals,
}

/// Is roughness that only light sees: the normal is turned, the surface stays (row T2).
///
/// The relief's slopes a along u and b along v turn the normal into
/// `n' = unit(n + rho)`, `rho = (a (n x tv) - b (n x tu)) / n.(tu x tv)`, with tu and tv the unit vectors
/// along which u and v grow (Blinn 1978); where these stand at a right angle rho is `-a tu - b tv`. A
/// normal that would look away from the viewer is mirrored at the line of sight, so that it looks
/// sideways as much as it looked away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump<S = f32> {
    /// Where the relief comes from; it is always smoothed.
    pub image: Image<S>,
    /// What its texels say.
    pub relief: Relief<S>,
}

impl<S: Scalar> Bump<S> {
    /// Makes bumps of a map of heights; the highest have this height.
    pub const fn heights(image: Image<S>, height: S) -> Self {
        Self { image, relief: Relief::Heights(height) }
    }

    /// Makes bumps of a map of normals.
    pub const fn normals(image: Image<S>) -> Self {
        Self { image, relief: Relief::Normals }
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        let height = match self.relief {
            Relief::Heights(height) => height,
            Relief::Normals => S::ZERO,
        };
        self.image.in_range() && height.in_range()
    }

    /// Answers how steeply the relief rises along each tangent at texture coordinates.
    #[inline(never)]
    pub(crate) fn slopes(&self, u: S, v: S, tangents: &[Tangent<S>; 2]) -> [S; 2] {
        let spot = self.image.spot(u, v);
        match self.relief {
            Relief::Heights(height) => rise(&self.image, &spot, height, tangents),
            Relief::Normals => lean(&self.image, &spot),
        }
    }
}

/// Answers the slopes of a map of heights: the difference over the texel around the place.
///
/// Heights half a texel before and behind a place make slopes that do not jump from texel to texel.
pub(crate) fn rise<S: Scalar>(
    image: &Image<S>,
    spot: &Spot<S>,
    height: S,
    tangents: &[Tangent<S>; 2],
) -> [S; 2] {
    let [columns, rows] = last_texel(&image.bitmap);
    let green = |right: S, down: S| levels(&image.bitmap, &Spot::at(right, down)).g;
    let around = |at: S, last: S| {
        let (before, behind) = (at - S::HALF, at + S::HALF);
        // Beyond the rim the next copy begins.
        let before = if before < S::ZERO { before + last } else { before };
        (before.max(S::ZERO), if behind > last { behind - last } else { behind })
    };
    let ((left, right), (above, below)) = (around(spot.right, columns), around(spot.down, rows));
    let differences = [
        green(right, spot.down) - green(left, spot.down),
        green(spot.right, above) - green(spot.right, below),
    ];
    let [u, v] = tangents;
    let [per_u, per_v] = image.per_unit;
    let [of_columns, of_rows] = image.bitmap.size().map(|side| side.saturating_sub(1).min(Bitmap::LARGEST));
    // How steep it is from black in one texel to full green in the next, times the share of that. Both are
    // products of wide numbers: many tiles leave the number, small heights would keep few of its digits.
    let slope = |difference: S, texels: u32, per_unit: S, tangent: &Tangent<S>| {
        let (rise, run) =
            (height.mul_wide(per_unit).scale(texels as i32, 1), tangent.length.mul_wide(S::ONE));
        // At a pole u has no length, and no slope along it.
        let full = if run == S::Wide::ZERO { S::ZERO } else { S::div(rise, run) };
        S::narrow(full.mul_wide(difference).scale(1, 255))
    };
    [slope(differences[0], of_columns, per_u, u), slope(differences[1], of_rows, per_v, v)]
}

/// Answers the slopes of a map of normals, which mirrored copies mirror.
fn lean<S: Scalar>(image: &Image<S>, spot: &Spot<S>) -> [S; 2] {
    let levels = levels(&image.bitmap, spot);
    // Twice the level less 255 is 255 times the part; one that does not look outward lies almost flat.
    let part = |level: S| level + level - S::from_i32(255);
    let outward = part(levels.b).max(S::ONE);
    let [u, v] = image.per_unit;
    let slope = |level: S, count: S| {
        let slope = part(level).ratio(outward);
        if count < S::ZERO { slope } else { -slope }
    };
    [slope(levels.r, u), slope(levels.g, v)]
}

/// Turns a unit normal by the slopes along two tangents.
pub(crate) fn bend<S: Scalar>(normal: Vec3<S>, tangents: &[Tangent<S>; 2], [a, b]: [S; 2]) -> Vec3<S> {
    let [u, v] = tangents.map(|tangent| tangent.direction);
    let sine = normal.dot(u.cross(v));
    if sine == S::ZERO {
        return normal;
    }
    let turn = normal.cross(v) * a.ratio(sine) - normal.cross(u) * b.ratio(sine);
    (normal + turn).normalize().map_or(normal, |(unit, _)| unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Fixed;
    use embedded_graphics::image::ImageRaw;
    use embedded_graphics::pixelcolor::Rgb888;

    const ALONG: [Vec3<f64>; 3] =
        [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)];

    #[test]
    fn the_normal_of_a_slope_is_that_of_the_inclined_plane_whichever_way_round_u_and_v_run() {
        for [u, v, n] in [[0, 1, 2], [1, 0, 2], [0, 2, 1], [2, 1, 0]].map(|axes| axes.map(|i| ALONG[i])) {
            let tangents = [u, v].map(|direction| Tangent { direction, length: 1.0 });
            let bent = bend(n, &tangents, [0.75, -2.0]);
            // Along (1, 0, 0.75) and (0, 1, -2) the inclined plane runs.
            assert!(bent.dot(u + n * 0.75).abs() < 1e-12 && bent.dot(v - n * 2.0).abs() < 1e-12);
            assert!(bent.dot(n) > 0.0 && (bent.length() - 1.0).abs() < 1e-12);
        }
    }

    /// Is black, full green and black again.
    static RIDGE: ImageRaw<Rgb888> = ImageRaw::new(&[0, 0, 0, 0, 255, 0, 0, 0, 0], 3);

    /// Answers the slopes of ridges in the middle of the rising half of one.
    fn on_a_ridge<S: Scalar>(number: fn(f64) -> S, [tiles, height, length]: [f64; 3]) -> S {
        let image = Image::new(Bitmap::new(&RIDGE)).with_tiles(number(tiles), S::ONE);
        let along = Tangent { direction: Vec3::ZERO, length: number(length) };
        let bump = Bump::heights(image, number(height));
        let [slope, _] = bump.slopes(number(0.25 / tiles), S::ZERO, &[along, along]);
        slope
    }

    #[test]
    fn a_slope_is_the_height_over_the_width_of_a_texel_however_many_and_however_high() {
        // From many tiles over small heights to few over mountains: 2 texels a tile.
        for [tiles, height, length] in
            [[1.0, 0.5, 4.0], [1024.0, 1.0 / 64.0, 64.0], [1024.0, 0.5, 1024.0], [4.0, 1000.0, 2000.0]]
        {
            let exact = 2.0 * tiles * height / length;
            let found = on_a_ridge(|x| x as f32, [tiles, height, length]);
            assert!((f64::from(found) - exact).abs() < 1e-6 * exact, "f32: {found}, not {exact}");
            let found = on_a_ridge(Fixed::new, [tiles, height, length]).to_f64();
            assert!((found - exact).abs() < 4e-6, "fixed: {found}, not {exact}");
        }
    }

    #[test]
    fn slopes_along_slanting_tangents_are_met_along_each_of_them() {
        let slant = Vec3::new(0.6, 0.8, 0.0);
        let tangents = [ALONG[0], slant].map(|direction| Tangent { direction, length: 1.0 });
        let bent = bend(ALONG[2], &tangents, [0.5, 0.25]);
        assert!(bent.dot(ALONG[0] + ALONG[2] * 0.5).abs() < 1e-12);
        assert!(bent.dot(slant + ALONG[2] * 0.25).abs() < 1e-12);
    }
}
