//! Triangles as the text of an OBJ file.

use crate::model::Corner;
use std::collections::HashMap;
use std::fmt::Write;

/// Writes triangles; each number has the digits that bring back its bits, each place, normal and pair of
/// texture coordinates is given once.
pub fn write(triangles: &[[Corner; 3]]) -> String {
    let [mut places, mut texture, mut normals] = ["v", "vt", "vn"].map(List::new);
    let mut faces = String::new();
    for triangle in triangles {
        faces.push('f');
        for corner in triangle {
            let place = places.number(&corner.place);
            let texture = corner.texture.map(|texture_at| texture.number(&texture_at));
            let normal = corner.normal.map(|normal| normals.number(&normal));
            let _ = match (texture, normal) {
                (None, None) => write!(faces, " {place}"),
                (Some(texture), None) => write!(faces, " {place}/{texture}"),
                (None, Some(normal)) => write!(faces, " {place}//{normal}"),
                (Some(texture), Some(normal)) => write!(faces, " {place}/{texture}/{normal}"),
            };
        }
        faces.push('\n');
    }
    [places.text, texture.text, normals.text, faces].concat()
}

/// Is the lines that begin with a word, each there once.
struct List {
    word: &'static str,
    text: String,
    known: HashMap<Vec<u64>, usize>,
}

impl List {
    fn new(word: &'static str) -> Self {
        Self { word, text: String::new(), known: HashMap::new() }
    }

    /// Answers the number of a line, from 1 on.
    fn number(&mut self, values: &[f64]) -> usize {
        let next = self.known.len() + 1;
        let text = &mut self.text;
        *self.known.entry(values.iter().map(|value| value.to_bits()).collect()).or_insert_with(|| {
            text.push_str(self.word);
            for value in values {
                let _ = write!(text, " {value:?}");
            }
            text.push('\n');
            next
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_corners_share_is_given_once() {
        let corner = |x: f64| Corner { place: [x, 0.1, -0.0], normal: Some([0.0, 0.0, 1.0]), texture: None };
        let text = write(&[[0.0, 1.0, 2.0], [2.0, 1.0, 1e-9]].map(|triangle| triangle.map(corner)));
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines,
            [
                "v 0.0 0.1 -0.0",
                "v 1.0 0.1 -0.0",
                "v 2.0 0.1 -0.0",
                "v 1e-9 0.1 -0.0",
                "vn 0.0 0.0 1.0",
                "f 1//1 2//1 3//1",
                "f 3//1 2//1 4//1",
            ]
        );
    }
}
