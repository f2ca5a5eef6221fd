use crate::math::Scalar;
use crate::trace::{LANES, Observer, RayKind, Step};

/// Marks each ray of a packet by all that it met.
pub(super) struct Marks<'o, O> {
    observer: &'o mut O,
    marks: [u32; LANES],
}

impl<'o, O> Marks<'o, O> {
    /// Makes the marks of rays that have met nothing; what they meet is passed on.
    pub fn new(observer: &'o mut O) -> Self {
        Self { observer, marks: [0; LANES] }
    }

    /// Begins with other rays.
    pub fn clear(&mut self) {
        self.marks = [0; LANES];
    }

    /// Answers the marks: those of rays that met the same are equal.
    pub fn marks(&self) -> &[u32; LANES] {
        &self.marks
    }

    fn note(&mut self, lane: u8, what: u32) {
        let mark = &mut self.marks[usize::from(lane) % LANES];
        // 2^32 over the golden ratio: what differs by little differs in the high bits, which the turn
        // brings down to the next product.
        *mark = (mark.rotate_left(5) ^ what).wrapping_mul(0x9e37_79b1);
    }
}

impl<O: Observer> Observer for Marks<'_, O> {
    fn ray(&mut self, kind: RayKind) {
        self.observer.ray(kind);
    }

    fn met(&mut self, lane: u8, object: u16, tile: u32) {
        self.note(lane, u32::from(object));
        self.note(lane, tile);
        self.observer.met(lane, object, tile);
    }

    fn lit(&mut self, lane: u8, light: u16) {
        self.note(lane, !u32::from(light));
        self.observer.lit(lane, light);
    }

    fn step<'c, S: Scalar>(&mut self, lane: u8, step: impl FnOnce() -> Step<'c, S>) {
        self.observer.step(lane, step);
    }
}
