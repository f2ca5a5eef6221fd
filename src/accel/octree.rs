use super::breadth_first::BreadthFirst;
use super::lattice::{Lattice, Passage};
use super::lists::Lists;
use super::{Hierarchy, Visit};
use crate::fault::Fault;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};

/// Is how often the cube can be halved: then octants are a step wide.
const LEVELS: usize = 16;

/// Is a tree that cuts a cube into eight, and each part again (row K2; A. Glassner 1984, "Space Subdivision
/// for Fast Ray Tracing").
///
/// A ray goes from leaf to leaf. A place in the next one is where it leaves the last one; the bits of its
/// coordinates name the octants that lead to it, from the one on that both share. Each place is taken from
/// the ray anew, so that no rounding adds up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octree<S: 'static = f32> {
    /// The cube that is cut.
    pub lattice: Lattice<S>,
    /// The box around all things, in steps of the lattice.
    pub bounds: [[u16; 3]; 2],
    /// What is cut into eight octants, the whole cube first, then level by level in the order in which
    /// octants name them: never more than 32767. Bit 0 of an octant's place is set in the half of higher x,
    /// bit 1 of y, bit 2 of z.
    pub branches: &'static [[Octant; 8]],
    /// How many things the lists name together.
    pub count: u16,
    /// What leaves hold.
    pub lists: Lists,
}

/// Is an eighth of a cube, in 2 bytes: one that is cut again, or a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Octant(u16);

impl Octant {
    /// Makes one that is cut again, of the number of its branch: at most 32767.
    pub const fn branch(number: u16) -> Self {
        Self(number << 1)
    }

    /// Makes a leaf, of the number of its list: at most 32767.
    pub const fn leaf(list: u16) -> Self {
        Self(list << 1 | 1)
    }

    /// Answers what it holds.
    pub const fn content(self) -> Content {
        if self.0 & 1 == 1 { Content::List(self.0 >> 1) } else { Content::Branch(self.0 >> 1) }
    }
}

/// Is what an octant holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Eight octants: the number of the branch.
    Branch(u16),
    /// Things: the number of their list.
    List(u16),
}

/// Is a place in the tree, with the branches that lead to it.
struct Place {
    /// Steps along each axis.
    steps: [u16; 3],
    /// Numbers of the branches on the way down, by level.
    path: [u16; LEVELS],
    level: u16,
}

impl Place {
    /// Goes down to the leaf that holds the place and answers its list.
    fn descend(&mut self, branches: &[[Octant; 8]]) -> Option<u16> {
        loop {
            let branch = *self.path.get(usize::from(self.level))?;
            let shift = 15_u16.checked_sub(self.level)?;
            let [x, y, z] = self.steps.map(|step| usize::from(step >> shift & 1));
            match branches.get(usize::from(branch))?.get(x | y << 1 | z << 2)?.content() {
                Content::List(list) => return Some(list),
                Content::Branch(next) => {
                    self.level += 1;
                    *self.path.get_mut(usize::from(self.level))? = next;
                }
            }
        }
    }

    /// Goes to where a ray leaves the leaf that holds the place, unless that is beyond the ray's far end or
    /// the cube.
    fn leave<S: Scalar>(&mut self, passage: &Passage<S>) -> Option<()> {
        let inner = u16::MAX >> 1 >> self.level;
        let ends = self.steps.map(|step| (step & !inner, step | inner));
        let (mut axis, mut exit, mut next) = (0, S::FAR, None);
        for (candidate, (low, high)) in ends.into_iter().enumerate() {
            let (face, beyond) = if passage.descends(candidate) {
                (Some(low), low.checked_sub(1))
            } else {
                let beyond = high.checked_add(1);
                (beyond, beyond)
            };
            // The cube's own end at higher coordinates is no step.
            let reach = face.map_or(S::FAR, |face| passage.reach(candidate, face));
            if reach < exit {
                (axis, exit, next) = (candidate, reach, beyond);
            }
        }
        let next = next.filter(|_| exit <= passage.far())?;
        let mut parted = 0;
        for (candidate, (step, (low, high))) in self.steps.iter_mut().zip(ends).enumerate() {
            let to = if candidate == axis {
                next
            } else if passage.descends(candidate) {
                // Never back, and never out of the leaf.
                passage.step_at(candidate, exit).min(*step).max(low)
            } else {
                passage.step_at(candidate, exit).max(*step).min(high)
            };
            parted |= *step ^ to;
            *step = to;
        }
        // The first bit in which both places differ tells the smallest branch that holds both.
        self.level = self.level.min(parted.leading_zeros() as u16);
        Some(())
    }
}

impl<S: Scalar> Hierarchy<S> for Octree<S> {
    fn walk(&self, ray: &Ray<S>, interval: &Interval<S>, visit: Visit<'_, S>) {
        let Some(entry) = self.lattice.enter(ray, interval) else { return };
        let mut passage = Passage::new(entry);
        let Some((near, _)) = passage.span(&self.bounds) else { return };
        let steps = [0, 1, 2].map(|axis| passage.step_at(axis, near));
        let mut place = Place { steps, path: [0; LEVELS], level: 0 };
        while let Some(list) = place.descend(self.branches) {
            if !self.lists.visit(list, &mut passage, interval.near, visit) || place.leave(&passage).is_none()
            {
                return;
            }
        }
    }

    fn count(&self) -> u16 {
        self.count
    }

    fn check(&self) -> Result<(), Fault> {
        let mut tree = BreadthFirst::new();
        let linked = (0..self.branches.len()).zip(self.branches).all(|(number, octants)| {
            tree.goes_to(number)
                && usize::from(tree.depth) < LEVELS
                && octants.iter().all(|octant| match octant.content() {
                    Content::Branch(branch) => tree.names(branch, 1),
                    Content::List(list) => self.lists.has(list),
                })
        });
        let whole = tree.ends_at(self.branches.len());
        if linked && whole && self.lattice.is_in_range() && self.lists.are_sound(self.count) {
            Ok(())
        } else {
            Err(Fault::Hierarchy)
        }
    }
}
