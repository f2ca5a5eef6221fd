use super::description::{Light, Volume};
use super::field::Piece;
use super::roots::Ray;
use super::vector::Vector;

impl Volume {
    /// Answers colour and opacity of a value: the sum of all classes, each with the weight of its tent.
    fn class(&self, value: f64) -> (Vector, f64) {
        let last = self.classes.len() - 1;
        let value = value.clamp(self.classes[0].0, self.classes[last].0);
        let tent = |i: usize| {
            let knot = self.classes[i].0;
            let reach = if value < knot {
                knot - self.classes[i.max(1) - 1].0
            } else {
                self.classes[(i + 1).min(last)].0 - knot
            };
            if value == knot { 1.0 } else { (1.0 - (value - knot).abs() / reach).max(0.0) }
        };
        let weighted =
            self.classes.iter().enumerate().map(|(i, (_, color, opacity))| (tent(i), color, opacity));
        weighted.fold((Vector::default(), 0.0), |(colors, sum), (weight, color, opacity)| {
            (colors + *color * weight, sum + opacity * weight)
        })
    }

    /// Answers what is seen of some light behind through the part of a ray between two distances, in units of its
    /// direction.
    pub fn over(
        &self,
        behind: Vector,
        ray: &Ray,
        span: [f64; 2],
        lights: &[Light],
        ambient: Vector,
    ) -> Vector {
        let cut = |piece: &Piece| {
            let (from, to) = (piece.from.max(span[0]), piece.to.min(span[1]));
            (from < to).then_some(Piece { from, to, ..*piece })
        };
        let divided = |Piece { cell, from, to }: Piece| {
            let end = move |n: u32| from + (to - from) * f64::from(n) / f64::from(self.samples);
            (0..self.samples).map(move |n| Piece { cell, from: end(n), to: end(n + 1) })
        };
        let mut left = 1.0;
        let mut samples = vec![];
        for piece in self.field.pieces(ray).iter().filter_map(cut).flat_map(divided) {
            if left <= self.faintest {
                break;
            }
            if let Some((color, opacity)) = self.sample(ray, &piece, lights, ambient) {
                left *= 1.0 - opacity;
                samples.push((color, opacity));
            }
        }
        // From the back to the front each covers what is behind it.
        samples
            .iter()
            .rev()
            .fold(behind, |light, (color, opacity)| light * (1.0 - opacity) + *color * *opacity)
    }

    /// Answers the light and the opacity of a piece by its middle; `None` where it is transparent.
    fn sample(&self, ray: &Ray, piece: &Piece, lights: &[Light], ambient: Vector) -> Option<(Vector, f64)> {
        let point = ray.point((piece.from + piece.to) / 2.0);
        let place = self.field.counted(point);
        let place = if self.nearest { Vector(place.0.map(|c| (c + 0.5).floor())) } else { place };
        let (color, opacity) = self.class(self.field.value(piece.cell, place));
        if opacity == 0.0 {
            return None;
        }
        let length = (piece.to - piece.from) * ray.direction.norm();
        let share = 1.0 - (-self.density * opacity / 255.0 * length).exp();
        let gradient = self.field.gradient(piece.cell, place);
        let mut arriving = ambient;
        if gradient.norm() > 0.0 {
            for light in lights {
                let (toward, _, sent) = light.seen_from(point);
                arriving = arriving + sent * (-gradient.unit()).inner(toward.unit()).max(0.0);
            }
        }
        Some((arriving.filter(color), share))
    }
}
