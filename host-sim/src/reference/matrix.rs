use super::vector::Vector;

/// Is a square matrix of homogeneous coordinates, by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Matrix([[f64; 4]; 4]);

impl Matrix {
    /// Makes the matrix that takes the world to the eye, as gluLookAt does.
    pub fn look_at(eye: Vector, center: Vector, up: Vector) -> Self {
        let forward = (center - eye).unit();
        let side = forward.outer(up.unit()).unit();
        let above = side.outer(forward);
        let row = |axis: Vector| {
            let [x, y, z] = axis.0;
            [x, y, z, -axis.inner(eye)]
        };
        Self([row(side), row(above), row(-forward), [0.0, 0.0, 0.0, 1.0]])
    }

    /// Makes the projection of glFrustum.
    pub fn frustum([left, right, bottom, top]: [f64; 4], near: f64, far: f64) -> Self {
        let (width, height, depth) = (right - left, top - bottom, far - near);
        Self([
            [2.0 * near / width, 0.0, (right + left) / width, 0.0],
            [0.0, 2.0 * near / height, (top + bottom) / height, 0.0],
            [0.0, 0.0, -(far + near) / depth, -2.0 * far * near / depth],
            [0.0, 0.0, -1.0, 0.0],
        ])
    }

    /// Makes the projection of glOrtho, its window around the line of sight.
    pub fn orthographic(width: f64, height: f64, near: f64, far: f64) -> Self {
        let depth = far - near;
        Self([
            [2.0 / width, 0.0, 0.0, 0.0],
            [0.0, 2.0 / height, 0.0, 0.0],
            [0.0, 0.0, -2.0 / depth, -(far + near) / depth],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// Answers the inverse by Gauss's and Jordan's elimination, the largest pivot first.
    pub fn inverse(self) -> Self {
        let mut left = self.0;
        let mut right = [[0.0; 4]; 4];
        (0..4).for_each(|i| right[i][i] = 1.0);
        for column in 0..4 {
            let larger = |a: &usize, b: &usize| left[*a][column].abs().total_cmp(&left[*b][column].abs());
            let pivot = (column..4).max_by(larger).unwrap_or(column);
            left.swap(column, pivot);
            right.swap(column, pivot);
            let scale = left[column][column];
            left[column] = left[column].map(|entry| entry / scale);
            right[column] = right[column].map(|entry| entry / scale);
            for row in (0..4).filter(|row| *row != column) {
                let factor = left[row][column];
                for entry in 0..4 {
                    left[row][entry] -= factor * left[column][entry];
                    right[row][entry] -= factor * right[column][entry];
                }
            }
        }
        Self(right)
    }

    fn apply(self, v: [f64; 4]) -> [f64; 4] {
        self.0.map(|row| (0..4).map(|i| row[i] * v[i]).sum())
    }

    /// Takes a point to where the matrix puts it.
    pub fn point(self, p: Vector) -> Vector {
        let [x, y, z] = p.0;
        let [x, y, z, w] = self.apply([x, y, z, 1.0]);
        Vector([x / w, y / w, z / w])
    }

    /// Turns a direction, which no translation moves.
    pub fn direction(self, d: Vector) -> Vector {
        let [x, y, z] = d.0;
        let [x, y, z, _] = self.apply([x, y, z, 0.0]);
        Vector([x, y, z])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_inverse_undoes_a_matrix_whose_first_pivot_is_zero() {
        let matrix =
            Matrix([[0.0, 2.0, 0.0, 1.0], [1.0, 0.0, 3.0, 0.0], [0.0, 1.0, 1.0, 4.0], [2.0, 0.0, 0.0, 1.0]]);
        let v = [1.0, -2.0, 0.5, 3.0];
        let back = matrix.inverse().apply(matrix.apply(v));
        assert!((0..4).all(|i| (back[i] - v[i]).abs() < 1e-14), "{back:?}");
    }
}
