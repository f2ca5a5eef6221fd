use std::collections::HashMap;

/// Is a place in the tree of calls: where one function calls another, on the way from the root.
#[derive(Clone, Copy, Debug)]
struct Call {
    /// Index of the call on whose behalf this one is made; the root's own.
    by: u32,
    /// Address of the calling instruction.
    site: u32,
}

/// Counts executed addresses, each with the calls that led there.
#[derive(Debug, Default)]
pub struct Counts {
    calls: Vec<Call>,
    known: HashMap<(u32, u32), u32>,
    counts: HashMap<(u32, u32), u64>,
}

/// Is the index of what is not called by anything.
const ROOT: u32 = 0;

impl Counts {
    /// Answers the index of the call at `site` on behalf of the call `by`.
    fn call(&mut self, by: u32, site: u32) -> u32 {
        let Self { calls, known, .. } = self;
        *known.entry((by, site)).or_insert_with(|| {
            calls.push(Call { by, site });
            calls.len() as u32
        })
    }

    /// Answers each address with the addresses of the calls that led there, the outermost first, and its
    /// count.
    pub fn by_sites(&self) -> impl Iterator<Item = (Vec<u32>, u64)> {
        self.counts.iter().map(|((call, address), count)| {
            let mut sites = vec![*address];
            let mut at = *call;
            while at != ROOT {
                let Call { by, site } = self.calls[at as usize - 1];
                sites.push(site);
                at = by;
            }
            sites.reverse();
            (sites, *count)
        })
    }
}

/// Is what an instruction is, as far as calls matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Bytes it takes.
    pub length: u32,
    /// Whether it may call a function; a branch that is too far away for others takes the same form on the
    /// M0+.
    pub calls: bool,
    /// Whether it is the first of a function.
    pub begins: bool,
}

impl Instruction {
    /// Reads a Thumb instruction.
    pub fn read([first, second]: [u16; 2], begins: bool) -> Self {
        let is_wide = first >> 11 > 0b11100;
        let is_bl = first >> 11 == 0b11110 && second & 0xd000 == 0xd000;
        let is_blx = first & 0xff87 == 0x4780;
        Self { length: if is_wide { 4 } else { 2 }, calls: is_bl || is_blx, begins }
    }
}

/// Follows calls and returns from one executed address to the next.
#[derive(Debug, Default)]
pub struct Walk {
    /// What has been counted.
    pub counts: Counts,
    /// Where each function that is not done goes on when it is, with the call that led to it.
    open: Vec<(u32, u32)>,
    last: Option<(u32, Instruction)>,
}

impl Walk {
    /// Counts an executed address.
    pub fn step(&mut self, address: u32, instruction: Instruction) {
        if let Some((last, before)) = self.last {
            let next = last + before.length;
            if address != next && before.calls && instruction.begins {
                let call = self.counts.call(self.here(), last);
                self.open.push((next, call));
            } else if address != next
                && let Some(depth) = self.open.iter().rposition(|(back, _)| *back == address)
            {
                self.open.truncate(depth);
            }
        }
        *self.counts.counts.entry((self.here(), address)).or_default() += 1;
        self.last = Some((address, instruction));
    }

    fn here(&self) -> u32 {
        self.open.last().map_or(ROOT, |(_, call)| *call)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: Instruction = Instruction { length: 2, calls: false, begins: false };
    const BEGIN: Instruction = Instruction { begins: true, ..PLAIN };
    const CALL: Instruction = Instruction { length: 4, calls: true, begins: false };

    fn counted(steps: &[(u32, Instruction)]) -> Vec<Vec<u32>> {
        let mut walk = Walk::default();
        for (address, instruction) in steps {
            walk.step(*address, *instruction);
        }
        let mut counted: Vec<_> = walk.counts.by_sites().map(|(sites, _)| sites).collect();
        counted.sort();
        counted
    }

    #[test]
    fn calls_are_told_from_other_instructions() {
        assert_eq!(Instruction::read([0xf000, 0xf800], false), CALL); // bl
        assert_eq!(
            Instruction::read([0x4798, 0], true),
            Instruction { length: 2, calls: true, begins: true }
        ); // blx r3
        assert_eq!(Instruction::read([0x4770, 0], false), PLAIN); // bx lr
        assert_eq!(Instruction::read([0xf000, 0xb800], false), Instruction { length: 4, ..PLAIN }); // b.w
    }

    /// The function at 100 calls that at 200, which ends in a jump to that at 300, which returns.
    #[test]
    fn an_address_is_counted_with_its_callers_even_after_a_tail_call() {
        let steps = [(100, CALL), (200, BEGIN), (300, BEGIN), (104, PLAIN), (106, PLAIN)];
        assert_eq!(counted(&steps), [vec![100], vec![100, 200], vec![100, 300], vec![104], vec![106]]);
    }

    #[test]
    fn a_far_branch_in_the_form_of_a_call_is_none() {
        assert_eq!(counted(&[(100, CALL), (200, PLAIN), (202, PLAIN)]), [vec![100], vec![200], vec![202]]);
    }
}
