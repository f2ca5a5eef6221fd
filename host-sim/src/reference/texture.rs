use super::description::{Bump, Sky, Texture};
use super::vector::Vector;

impl Texture {
    /// Answers the colour at texture coordinates, and the tile if there are tiles.
    pub fn look(&self, [u, v]: [f64; 2]) -> (Vector, Option<[i64; 2]>) {
        let either =
            |number: i64, even: Vector, odd: Vector| if number.rem_euclid(2) == 0 { even } else { odd };
        match self {
            Self::Solid(color) => (*color, None),
            Self::Vertices([a, b, c]) => (*a + (*b - *a) * u + (*c - *a) * v, None),
            Self::Checker { even, odd, per_unit } => {
                let tile = [u, v].map(|coordinate| (coordinate * per_unit).floor() as i64);
                (either(tile[0] + tile[1], *even, *odd), Some(tile))
            }
            Self::Stripes { even, odd, per_unit } => {
                let stripe = (u * per_unit[0] + v * per_unit[1]).floor() as i64;
                (either(stripe, *even, *odd), Some([stripe, 0]))
            }
            Self::Rings { even, odd, center, per_unit } => {
                let ring = ((u - center[0]).hypot(v - center[1]) * per_unit).floor() as i64;
                (either(ring, *even, *odd), Some([ring, 0]))
            }
            Self::Image(image) => {
                let (color, tile) = image.look([u, v]);
                (color, Some(tile))
            }
        }
    }
}

impl Bump {
    /// Answers the outward normal of the bumpy surface, by Blinn's derivatives of the moved point:
    /// `(Pu + hu n) x (Pv + hv n)`.
    pub fn turned(&self, normal: Vector, derivatives: [Vector; 2], coordinates: [f64; 2]) -> Vector {
        let [du, dv] = derivatives;
        let rise = match self {
            Self::Heights { image, height } => image.rise(coordinates).map(|rise| rise * height),
            Self::Normals { image } => {
                let [x, y, z] = image.normal(coordinates);
                [-x / z * du.norm(), -y / z * dv.norm()]
            }
        };
        // At a pole nothing rises along u, for u goes nowhere.
        let across = du.outer(dv);
        if across.norm() == 0.0 {
            return normal;
        }
        let turned = (du + normal * rise[0]).outer(dv + normal * rise[1]);
        turned.unit() * across.inner(normal).signum()
    }
}

impl Sky {
    /// Answers the light that comes from a direction of any length.
    pub fn light(&self, direction: Vector) -> Vector {
        match self {
            Self::Solid(color) => *color,
            Self::Gradient { up, nadir, zenith } => {
                let share = (1.0 + direction.unit().inner(*up)) / 2.0;
                *nadir + (*zenith - *nadir) * share
            }
            Self::Cube { faces, smooth } => {
                let size = direction.0.map(f64::abs);
                let largest = size[0].max(size[1]).max(size[2]);
                let axis = (0..3).find(|axis| size[*axis] == largest).unwrap_or(0);
                let side = direction.0[axis].signum();
                // Where the direction goes through a face of the cube from -1 to 1.
                let others = [[1, 2], [0, 2], [0, 1]][axis];
                let share = others.map(|other| (1.0 + side * direction.0[other] / largest) / 2.0);
                faces[2 * axis + usize::from(side > 0.0)].light(share, *smooth)
            }
        }
    }
}
