use super::Volume;
use super::classes::{are_clear, classify};
use super::partition::{Course, Piece};
use crate::brdf;
use crate::color::Rgb;
use crate::light::{Light, Spot};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is what a volume does to the light behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Veil<S> {
    /// Light that the volume sends itself, weighted by what is before it.
    pub color: Rgb<S>,
    /// Share of the light behind that comes through, from 0 to 1.
    pub transparency: S,
    /// A number of the first cell that is seen: pixels that see others are not taken for alike.
    pub mark: u32,
}

impl<S: Scalar> Veil<S> {
    /// Is where there is no volume.
    pub const CLEAR: Self = Self { color: Rgb::BLACK, transparency: S::ONE, mark: 0 };

    /// Lays a sample of so much opacity behind what there is (row V6): `Cout = Cin + (1 - ain) a C` and
    /// `1 - aout = (1 - ain) (1 - a)`, where the veil holds `C` weighted by its opacity and `1 - a`.
    fn add(&mut self, color: Rgb<S>, opacity: S) {
        self.color += color * (opacity * self.transparency);
        self.transparency = self.transparency * (S::ONE - opacity);
    }

    /// Answers what is seen of light behind the veil: `I = t Ib + (1 - t) I0`.
    pub fn over(&self, behind: Rgb<S>) -> Rgb<S> {
        self.color + behind * self.transparency
    }
}

/// Remembers whether the block is transparent that was asked for last.
struct Block {
    cell: Option<[u16; 3]>,
    clear: bool,
}

impl<S: Scalar> Volume<S> {
    /// Answers what the volume does to the light behind an interval of a ray, front to back.
    #[inline(never)]
    pub fn veil(
        &self,
        ray: &Ray<S>,
        interval: &Interval<S>,
        lights: &[Light<S>],
        ambient: Rgb<S>,
    ) -> Veil<S> {
        let mut veil = Veil::CLEAR;
        let Some(course) = Course::of(&self.grid, ray, interval) else { return veil };
        let mut block = Block { cell: None, clear: false };
        for piece in course.pieces(&self.grid, ray) {
            if self.is_clear(&mut block, piece.cell) {
                continue;
            }
            for part in piece.divided(self.samples) {
                self.sample(&course, &part, ray, lights, ambient, &mut veil);
                if veil.transparency <= self.faintest {
                    return veil;
                }
            }
        }
        veil
    }

    /// Tells whether a cell lies in a block that is known to be transparent.
    fn is_clear(&self, block: &mut Block, cell: [u16; 3]) -> bool {
        let named = Some(cell.map(|place| place / super::Voxels::BLOCK));
        if block.cell != named {
            let range = self.grid.voxels.of_block(cell);
            *block = Block { cell: named, clear: range.is_some_and(|range| are_clear(self.classes, range)) };
        }
        block.clear
    }

    /// Lays a piece of a ray behind what there is: by its middle, as deep as it is long.
    fn sample(
        &self,
        course: &Course<S>,
        piece: &Piece<S>,
        ray: &Ray<S>,
        lights: &[Light<S>],
        ambient: Rgb<S>,
        veil: &mut Veil<S>,
    ) {
        let length = piece.to - piece.from;
        let middle = piece.from.add_product(length, S::HALF);
        let place = self.reconstruction.of(course.place(piece.cell, middle));
        let (color, share) = classify(self.classes, self.grid.value(&place));
        if share <= S::ZERO {
            return;
        }
        let depth = share * self.density.ratio(S::from_i32(255)) * length;
        let normal = self.gradient.normal(&self.grid, &place);
        let arriving = normal.map_or(Rgb::BLACK, |normal| arriving(lights, ray.at(middle), normal));
        if veil.transparency == S::ONE {
            let [x, y, z] = piece.cell.map(u32::from);
            veil.mark = x ^ y << 10 ^ z << 20;
        }
        veil.add((ambient + arriving) * color, S::ONE - depth.exp_neg());
    }
}

/// Answers the light that falls on a place across a normal, nothing in its way: the sum of `C (N.L)` (row V5).
fn arriving<S: Scalar>(lights: &[Light<S>], point: Vec3<S>, normal: Vec3<S>) -> Rgb<S> {
    lights.iter().fold(Rgb::BLACK, |sum, light| {
        let toward = match *light {
            Light::Point { position, .. } | Light::Spot(Spot { position, .. }) => position - point,
            Light::Directional { toward, .. } => toward,
        };
        let Some((direction, _)) = toward.normalize() else { return sum };
        let color = light.arriving(direction).unwrap_or(Rgb::BLACK);
        sum + color * brdf::lambert(normal, direction)
    })
}
