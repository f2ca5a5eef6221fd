use super::vector::Vector;

/// Answers how often an outline runs around a point of its plane: the angles under which its edges
/// are seen from there, summed up.
fn winding(vertices: &[Vector], normal: Vector, point: Vector) -> i64 {
    let next = vertices.iter().cycle().skip(1);
    let angles = vertices.iter().zip(next).map(|(a, b)| {
        let (a, b) = (*a - point, *b - point);
        a.outer(b).inner(normal.unit()).atan2(a.inner(b))
    });
    (angles.sum::<f64>() / std::f64::consts::TAU).round() as i64
}

/// Tells whether a polygon holds a point of its plane, by the odd-even or by the winding rule.
pub(super) fn surrounds(vertices: &[Vector], normal: Vector, odd_even: bool, point: Vector) -> bool {
    let turns = winding(vertices, normal, point);
    // Turns are odd where a half-line crosses the outline an odd number of times.
    if odd_even { turns % 2 != 0 } else { turns != 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_pentagram_is_run_around_twice_and_its_points_once() {
        let corner = |i: i32| {
            let angle = std::f64::consts::TAU * 2.0 * f64::from(i) / 5.0;
            Vector([angle.cos(), angle.sin(), 0.0])
        };
        let star: Vec<Vector> = (0..5).map(corner).collect();
        let normal = Vector([0.0, 0.0, 3.0]);
        let turns = |x, y| winding(&star, normal, Vector([x, y, 0.0]));
        assert_eq!([turns(0.1, 0.1), turns(0.8, 0.0), turns(-0.6, 0.0)], [2, 1, 0]);
    }
}
