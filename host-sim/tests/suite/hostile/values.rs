//! Values that numbers break on.

use super::dice::Dice;
use host_sim::rounded::Rounded;
use scanray::{Rgb, Vec3};

/// Is how many values are remembered, to come again.
const PAST: usize = 6;

/// Throws the values of one scene.
///
/// A scene has a temper: how often a value is one that no scene may hold, how often one from the ends of what it may
/// hold, and how large the others are. Were it the same for all, nearly every scene would fail at its first list.
pub struct Values<S> {
    pub dice: Dice,
    /// One in so many is outside of what scenes may hold; 0 for none.
    outlaws: usize,
    /// One in so many lies on an edge of it; 0 for none.
    edges: usize,
    /// About how large the others are.
    size: f64,
    past: [S; PAST],
}

impl<S: Rounded> Values<S> {
    pub fn new(mut dice: Dice) -> Self {
        let outlaws = dice.pick(&[0, 0, 0, 0, 0, 300, 60, 10]);
        let edges = dice.pick(&[0, 0, 100, 30, 10, 4, 2]);
        let size = 10_f64.powf(dice.share() * 5.0 - 2.0);
        Self { dice, outlaws, edges, size, past: [S::ZERO; PAST] }
    }

    fn is_one_in(&mut self, times: usize) -> bool {
        times > 0 && self.dice.one_in(times)
    }

    /// Answers a value that no scene may hold.
    fn outlaw(&mut self) -> S {
        let above = S::LIMIT.next_up();
        let far = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, f64::from(f32::MAX)];
        let far = far.map(S::round);
        self.dice.pick(&[above, -above, S::FAR, far[0], far[1], far[2], far[3], far[4], far[5]])
    }

    /// Answers a value at an end of what a scene may hold, or the same as one before.
    fn edge(&mut self) -> S {
        if self.dice.one_in(3) {
            return self.dice.pick(&self.past);
        }
        let least = S::ZERO.next_up();
        let half_limit = S::LIMIT * S::HALF;
        let plain = [-0.0, 1e-40, 1e-310, 1e-37, 1e-6, 1.0 / 1024.0, 2.0, 1023.9, -1e-6, 1e9].map(S::round);
        let ends = [S::ZERO, least, -least, S::ONE, -S::ONE, S::BELOW_ONE, S::ONE.next_up(), S::HALF];
        let large = [S::LIMIT, -S::LIMIT, half_limit, S::SKIN, S::PARALLEL, S::SLACK];
        match self.dice.below(3) {
            0 => self.dice.pick(&plain),
            1 => self.dice.pick(&ends),
            _ => self.dice.pick(&large),
        }
    }

    /// Answers a value, or now and then what is none, in place of a usual one.
    fn or_odd(&mut self, usual: f64) -> S {
        let value = if self.is_one_in(self.outlaws) {
            self.outlaw()
        } else if self.is_one_in(self.edges) {
            self.edge()
        } else {
            S::round(usual)
        };
        let place = self.dice.below(PAST);
        self.past[place] = value;
        value
    }

    /// Answers a coordinate.
    pub fn length(&mut self) -> S {
        let usual = self.size * (2.0 * self.dice.share() - 1.0);
        self.or_odd(usual)
    }

    /// Answers a radius or another length that should be above 0.
    pub fn radius(&mut self) -> S {
        let usual = self.size * 0.5 * self.dice.share();
        self.or_odd(usual)
    }

    /// Answers a value that should lie between two others.
    pub fn between(&mut self, low: f64, high: f64) -> S {
        let usual = low + (high - low) * self.dice.share();
        self.or_odd(usual)
    }

    /// Answers a count of repetitions to a unit.
    pub fn per_unit(&mut self) -> S {
        let usual = 10_f64.powf(self.dice.share() * 4.0 - 2.0);
        self.or_odd(usual)
    }

    pub fn point(&mut self) -> Vec3<S> {
        Vec3::new(self.length(), self.length(), self.length())
    }

    /// Answers a direction of unit length, or along an axis, or of any length, or of none.
    pub fn direction(&mut self) -> Vec3<S> {
        let any = self.point();
        match self.dice.below(8) {
            0 => any,
            1 => Vec3::new(S::ZERO, S::ONE, S::ZERO),
            2 => Vec3::new(-S::ONE, S::ZERO, S::ZERO),
            _ => any.normalize().map_or(any, |(unit, _)| unit),
        }
    }

    pub fn color(&mut self) -> Rgb<S> {
        Rgb::new(self.between(0.0, 1.0), self.between(0.0, 1.0), self.between(0.0, 1.0))
    }

    /// Answers texture coordinates.
    pub fn place(&mut self) -> [S; 2] {
        [self.per_unit(), self.per_unit()]
    }
}
