use super::Thing;
use crate::bake::Bounds;

/// Is how many things a hierarchy holds, at most.
const MOST: usize = 65_535;

/// Answers the things in as few halves of halves as hold no more than a hierarchy does, each cut where as
/// many things lie on both sides, across the axis along which they reach farthest.
pub(super) fn parts(things: &[Thing]) -> Vec<Vec<Thing>> {
    let (mut whole, mut parts) = (vec![things.to_vec()], Vec::new());
    while let Some(mut part) = whole.pop() {
        if part.len() <= MOST {
            parts.push(part);
            continue;
        }
        let sides = Bounds::of(part.iter().map(Thing::bounds)).sides();
        let axis = (0..3).max_by(|a, b| sides[*a].total_cmp(&sides[*b])).unwrap_or(0);
        let middle = |thing: &Thing| thing.bounds().low[axis] + thing.bounds().high[axis];
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
        let rest = part.split_off(half);
        whole.extend([part, rest]);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_things_than_a_hierarchy_holds_lie_in_halves_apart() {
        let balls: Vec<Thing> =
            (0..70_000).map(|n| Thing::Ball([0.0, f64::from(n * 7 % 70_000), 1.0], 0.25)).collect();
        let parts = parts(&balls);
        let mut sizes: Vec<usize> = parts.iter().map(Vec::len).collect();
        sizes.sort();
        assert_eq!(sizes, [35_000, 35_000]);
        let mut reaches =
            parts.iter().map(|part| Bounds::of(part.iter().map(Thing::bounds))).collect::<Vec<_>>();
        reaches.sort_by(|a, b| a.low[1].total_cmp(&b.low[1]));
        assert!(reaches[0].high[1] < reaches[1].low[1], "{reaches:?}");
        assert_eq!(super::parts(&balls[..MOST]).len(), 1);
    }
}
