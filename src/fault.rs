//! What can be wrong with the things a scene is made of.

use core::fmt;

/// Tells what is wrong with one thing of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// A length is not a number or larger than [`Scalar::LIMIT`](crate::Scalar::LIMIT), or a light
    /// is not from 0 to 1024.
    OutOfRange,
    /// A mirror's weight is not from 0 to 1.
    MirrorWeight,
    /// A surface's roughness is not from 1/64 to 1.
    Roughness,
    /// An index of refraction is not from 1 to 256.
    RefractiveIndex,
    /// The cosine of a cone's angle is not from 0 to below 1.
    Cone,
    /// A radius is zero or negative.
    RadiusNotPositive,
    /// Corners coincide or lie on a line.
    Degenerate,
    /// The low corner of a box lies above the high one.
    CornersSwapped,
    /// A normal or direction has no length, or an `up` not unit length.
    NoDirection,
    /// The object names a material that is not in the list.
    NoSuchMaterial(u16),
    /// There are more objects than an index can name, 65535.
    TooMany,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange => f.write_str(
                "a value is not a number, too large for the number type, or light below 0 or above 1024",
            ),
            Self::MirrorWeight => f.write_str("its mirror weight is not between 0 and 1"),
            Self::Roughness => f.write_str("its roughness is not between 1/64 and 1"),
            Self::RefractiveIndex => f.write_str("its index of refraction is not between 1 and 256"),
            Self::Cone => {
                f.write_str("its cone's edge is not more than 0 and at most 90 degrees from its axis")
            }
            Self::RadiusNotPositive => f.write_str("its radius is not above zero"),
            Self::Degenerate => f.write_str("its corners coincide or lie on a line"),
            Self::CornersSwapped => f.write_str("its low corner lies above its high corner"),
            Self::NoDirection => f.write_str("its direction has no length or not the length it must have"),
            Self::NoSuchMaterial(index) => write!(f, "it names material {index}, which is not in the list"),
            Self::TooMany => f.write_str("there are more than 65535 of them"),
        }
    }
}
