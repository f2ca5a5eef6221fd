//! The little that is needed of vectors of `f64`.

/// Answers the scalar product.
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

/// Answers the difference.
pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// Answers the vector product (right-handed).
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Scales a vector to unit length; `None` for one without length.
pub fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let largest = v.iter().fold(0.0, |most: f64, value| value.abs().max(most));
    // Squares of what is very small or very large would be lost.
    let v = v.map(|value| value / largest);
    let length = dot(v, v).sqrt();
    (largest > 0.0 && length.is_finite()).then(|| v.map(|value| value / length))
}

/// Answers the normal of a triangle, twice as long as its area.
pub fn area([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    cross(sub(b, a), sub(c, a))
}
