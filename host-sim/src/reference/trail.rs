/// Is one surface on the way of a ray.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stop {
    /// Place of the object in the scene's list.
    pub object: usize,
    /// Face of a box, else 0.
    pub part: u8,
    /// Tile of a chessboard, along its two coordinates.
    pub tile: Option<[i64; 2]>,
    /// Which lights reach the surface from its visible side; none where it is not lit.
    pub lights: Vec<bool>,
}

/// Lists the surfaces a ray and its reflections met, in order; empty where it met the sky.
pub type Trail = Vec<Stop>;

/// Marks the pixels beside a silhouette: those with a trail unlike that of one of their eight
/// neighbours.
///
/// An edge that passes between the centres of two pixels marks both. Edges are those of objects,
/// faces, tiles and shadows, seen directly or in a mirror.
pub(super) fn silhouettes(trails: &[Trail], [columns, rows]: [u32; 2]) -> Vec<bool> {
    let (columns, rows) = (columns as usize, rows as usize);
    let near = |i: usize, end: usize| i.saturating_sub(1)..=(i + 1).min(end - 1);
    let differs = |x: usize, y: usize| {
        let here = &trails[y * columns + x];
        near(y, rows).any(|j| near(x, columns).any(|i| trails[j * columns + i] != *here))
    };
    (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(|(x, y)| differs(x, y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_odd_pixel_marks_itself_and_its_eight_neighbours_within_the_picture() {
        let odd = vec![Stop { object: 0, part: 0, tile: None, lights: vec![] }];
        let mut trails = vec![Trail::new(); 20];
        trails[3] = odd;
        let mask = silhouettes(&trails, [5, 4]);
        let marked: Vec<usize> = (0..20).filter(|i| mask[*i]).collect();
        assert_eq!(marked, [2, 3, 4, 7, 8, 9]);
    }
}
