use super::depths::Painter;
use super::slice::Slice;
use super::span::Span;
use crate::aabb::Aabb;
use crate::math::{Scalar, Vec3};
use crate::shape::Cuboid;
use crate::trace::Observer;

/// Lists the corners around each face, named by bits: a bit an axis, set where it is the high one.
const FACES: [[u8; 4]; 6] =
    [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];

/// Puts a box into the row of depths: those of its faces that can be seen, three at most from outside.
pub(super) fn paint<S: Scalar, O: Observer>(
    cuboid: &Cuboid<S>,
    slice: &Slice<S>,
    painter: &mut Painter<'_, S, O>,
) {
    let corners = slice.fan.box_corners(&Aabb::between(cuboid.low, cuboid.high));
    let sides = corners.map(|[_, _, off]| off < S::ZERO);
    if sides == [true; 8] || sides == [false; 8] {
        return;
    }
    let faces = facing(cuboid, slice);
    for ((part, face), seen) in (0..).zip(FACES).zip(faces) {
        if seen {
            let around = face.map(|at| corners.get(usize::from(at)).copied().unwrap_or([S::ZERO; 3]));
            if let Some(span) = Span::of(slice, &around) {
                span.paint(slice, part, painter);
            }
        }
    }
}

/// Tells which faces can be seen.
///
/// An eye outside sees those whose planes it is beyond, an eye inside all. Where the near plane cuts the
/// box open, and of parallel rays that may start inside, any face may be seen: depths decide.
fn facing<S: Scalar>(cuboid: &Cuboid<S>, slice: &Slice<S>) -> [bool; 6] {
    let (Vec3 { x, y, z }, Cuboid { low, high }) = (slice.fan.apex, *cuboid);
    let beyond = [x < low.x, x > high.x, y < low.y, y > high.y, z < low.z, z > high.z];
    let cut_open = slice.fan.parallel || slice.nearest < S::FAR;
    if cut_open || beyond == [false; 6] { [true; 6] } else { beyond }
}
