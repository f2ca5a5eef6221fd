use scanray::Dither;
use scanray::output::BLUE_NOISE;

/// Names a way of rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// To the nearest level.
    None,
    /// By Bayer's square.
    Ordered,
    /// By the core's mask of blue noise.
    BlueNoise,
    /// By error diffusion along the row.
    Diffused,
}

impl Method {
    /// Lists all.
    pub const ALL: [Self; 4] = [Self::None, Self::Ordered, Self::BlueNoise, Self::Diffused];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Ordered => "ordered",
            Self::BlueNoise => "blue-noise",
            Self::Diffused => "diffused",
        }
    }

    /// Answers what the core calls it.
    pub fn dither(self) -> Dither {
        match self {
            Self::None => Dither::None,
            Self::Ordered => Dither::Ordered,
            Self::BlueNoise => Dither::Mask(&BLUE_NOISE),
            Self::Diffused => Dither::Diffused,
        }
    }
}
