use super::vector::Vector;
use std::sync::Arc;

/// Is an image: rows from the top, sRGB levels of 8 bits.
#[derive(Clone, Debug)]
pub(super) struct Raster {
    pub rows: Vec<Vec<[u8; 3]>>,
}

/// Is an image laid over texture coordinates.
#[derive(Clone, Debug)]
pub(super) struct Image {
    pub raster: Arc<Raster>,
    pub per_unit: [f64; 2],
    pub smooth: bool,
}

/// Answers the light of a level by the curve (IEC 61966-2-1), rounded to 2^-24 as the core says it is.
fn light(level: f64) -> f64 {
    let x = level / 255.0;
    let light = if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) };
    (light * 16_777_216.0).round() / 16_777_216.0
}

/// Answers how much a texel counts at a distance from its middle: a tent.
fn tent(distance: f64) -> f64 {
    (1.0 - distance.abs()).max(0.0)
}

impl Raster {
    /// Answers the columns and rows less one: the texels' middles span the image.
    fn span(&self) -> [f64; 2] {
        [self.rows[0].len() as f64 - 1.0, self.rows.len() as f64 - 1.0]
    }

    /// Answers what a function makes of the levels at a column and a row from below, mixed by tents.
    fn mixed(&self, [column, row]: [f64; 2], read: impl Fn(f64) -> f64) -> Vector {
        let mut sum = Vector([0.0; 3]);
        for (from_below, texels) in self.rows.iter().rev().enumerate() {
            let share = tent(row - from_below as f64);
            if share > 0.0 {
                let first = (column.floor() as usize).min(texels.len() - 1);
                for (place, texel) in texels.iter().enumerate().skip(first).take(2) {
                    let weight = share * tent(column - place as f64);
                    sum = sum + Vector(texel.map(|level| read(f64::from(level)))) * weight;
                }
            }
        }
        sum
    }

    /// Answers the light at shares of the width and of the height from below.
    pub fn light(&self, share: [f64; 2], smooth: bool) -> Vector {
        let span = self.span();
        let place = [share[0] * span[0], share[1] * span[1]];
        if smooth {
            return self.mixed(place, light);
        }
        // Halfway between two rows the lower one counts, for rows are counted from the top.
        self.mixed([(place[0] + 0.5).floor(), (place[1] - 0.5).ceil()], light)
    }
}

impl Image {
    /// Answers a place's shares of the width and the height, and which copy of the image it lies in.
    fn place(&self, coordinates: [f64; 2]) -> ([f64; 2], [i64; 2]) {
        let along = |i: usize| coordinates[i] * self.per_unit[i];
        ([along(0).rem_euclid(1.0), along(1).rem_euclid(1.0)], [along(0), along(1)].map(|a| a.floor() as i64))
    }

    /// Answers the light, and the copy or the texel that it belongs to.
    pub fn look(&self, coordinates: [f64; 2]) -> (Vector, [i64; 2]) {
        let (share, copy) = self.place(coordinates);
        let span = self.raster.span();
        let texel = |i: usize| copy[i] * (span[i] as i64 + 1) + (share[i] * span[i]).round() as i64;
        let tile = if self.smooth { copy } else { [texel(0), texel(1)] };
        (self.raster.light(share, self.smooth), tile)
    }

    /// Answers the green level as a share of 255, smoothed.
    pub fn height(&self, coordinates: [f64; 2]) -> f64 {
        let (share, _) = self.place(coordinates);
        let span = self.raster.span();
        self.raster.mixed([share[0] * span[0], share[1] * span[1]], |level| level / 255.0).0[1]
    }

    /// Answers the derivatives of the height by u and v: differences over the texel around the place.
    pub fn rise(&self, coordinates: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|i| {
            let texels = self.raster.span()[i] * self.per_unit[i];
            let at = |side: f64| {
                let mut moved = coordinates;
                moved[i] += side * 0.5 / texels;
                self.height(moved)
            };
            if texels == 0.0 { 0.0 } else { (at(1.0) - at(-1.0)) * texels }
        })
    }

    /// Answers the normal that the levels stand for, of any length, on the axes of u, v and outward.
    pub fn normal(&self, coordinates: [f64; 2]) -> [f64; 3] {
        let (share, _) = self.place(coordinates);
        let span = self.raster.span();
        let part = self.raster.mixed([share[0] * span[0], share[1] * span[1]], |level| 2.0 * level - 255.0);
        let [x, y, z] = part.0;
        [x * self.per_unit[0].signum(), y * self.per_unit[1].signum(), z.max(1.0)]
    }
}
