use super::lane::{LANES, Lane};
use super::observer::Observer;
use super::step::Step;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::Scalar;
use crate::shape::Intersect;
use crate::volume::{Veil, Volume};

/// Stands for the volume among the objects that an observer is told of.
const VOLUME: u16 = u16::MAX - 1;

impl<S: Scalar, X: Intersect<S>> Tracer<'_, '_, S, X> {
    /// Lights what the rays have met as far as it is seen through a volume before it, and what the volume sends.
    ///
    /// Called, never inlined: scenes without a volume pay for one test of eight rays.
    #[inline(never)]
    pub(super) fn follow_behind(
        &mut self,
        volume: &Volume<S>,
        lanes: &mut [Lane<S>],
        light: &mut [Rgb<S>],
        observer: &mut impl Observer,
    ) {
        let mut veils = [Veil::CLEAR; LANES];
        for (lane, veil) in lanes.iter().zip(&mut veils) {
            *veil = volume.veil(&lane.ray, &lane.interval, self.scene.lights, self.scene.ambient);
            if veil.transparency < S::ONE {
                observer.met(lane.number, VOLUME, veil.mark);
                let Veil { color, transparency, .. } = *veil;
                observer.step(lane.number, move || Step::Veiled { color, transparency });
            }
        }
        self.follow(lanes, light, observer);
        for (veil, light) in veils.iter().zip(light) {
            *light = Veil { color: self.exposure * veil.color, ..*veil }.over(*light);
        }
    }
}
