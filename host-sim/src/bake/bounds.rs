use scanray::Intersect;

/// Is a box along the axes, from its lowest to its highest corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lowest coordinates.
    pub low: [f64; 3],
    /// Highest coordinates.
    pub high: [f64; 3],
}

impl Bounds {
    /// Is the box around nothing.
    pub const NOTHING: Self = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// Makes the smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        points.into_iter().fold(Self::NOTHING, |bounds, point| bounds.and(Self { low: point, high: point }))
    }

    /// Makes the box around a shape; `None` for one without an end.
    pub fn of_shape(shape: &impl Intersect<f64>) -> Option<Self> {
        let bounds = shape.hull().bounds()?;
        Some(Self {
            low: (bounds.center - bounds.half).to_array(),
            high: (bounds.center + bounds.half).to_array(),
        })
    }

    /// Makes the smallest box around two.
    pub fn and(self, other: Self) -> Self {
        let [low, high] = [[self.low, other.low], [self.high, other.high]];
        Self {
            low: std::array::from_fn(|axis| low[0][axis].min(low[1][axis])),
            high: std::array::from_fn(|axis| high[0][axis].max(high[1][axis])),
        }
    }

    /// Makes the smallest box around many.
    pub fn of(boxes: impl IntoIterator<Item = Self>) -> Self {
        boxes.into_iter().fold(Self::NOTHING, Self::and)
    }

    /// Answers half the area of its surface: rays meet a box as often as it has surface.
    pub fn half_area(&self) -> f64 {
        let [x, y, z]: [f64; 3] = self.sides().map(|side| side.max(0.0));
        x * y + y * z + z * x
    }

    /// Answers the lengths of its sides; below 0 for the box around nothing.
    pub fn sides(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.high[axis] - self.low[axis])
    }

    /// Answers its middle along an axis.
    pub fn middle(&self, axis: usize) -> f64 {
        0.5 * (self.low[axis] + self.high[axis])
    }

    /// Answers the largest magnitude of a coordinate; 0 for the box around nothing.
    pub fn largest(&self) -> f64 {
        let corners = self.low.iter().chain(&self.high).filter(|value| value.is_finite());
        corners.fold(0.0, |most, value| value.abs().max(most))
    }
}
