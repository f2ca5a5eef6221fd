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
    /// What glass lets through is not from 0 to what its mirror leaves of 1.
    Transmission,
    /// A refractive index is not from 1/8 to 8.
    RefractiveIndex,
    /// A surface's roughness is not from 1/64 to 1.
    Roughness,
    /// The refractive index of facets is not from 1 to 256.
    FacetIndex,
    /// The cosine of a cone's angle is not from 0 to below 1.
    Cone,
    /// A radius is zero or negative.
    RadiusNotPositive,
    /// Corners coincide or lie on a line.
    Degenerate,
    /// A polygon has fewer than three corners.
    TooFewCorners,
    /// A corner of a polygon lies off its plane by more than 1/1024 of the polygon's extent.
    NotFlat,
    /// The low corner of a box lies above the high one.
    CornersSwapped,
    /// A normal or direction has no length, or an `up` not unit length.
    NoDirection,
    /// A normal given for a corner does not point to the outward side of its triangle.
    NormalInward,
    /// An image has no texels, or more than 2048 to a side.
    ImageSize,
    /// A grid has a side of fewer than 2 or more than 1024 voxels, or not as many values as voxels, or blocks.
    Voxels,
    /// Voxels are closer together than 1/1024, or farther apart than any length may be.
    Spacing,
    /// A table of classes is empty, or its values do not rise.
    Classes,
    /// A volume takes no samples of a cell.
    Samples,
    /// Its material is glass, and the shape has no inside.
    NotClosed,
    /// A triangle of a mesh names a corner that is not in the list, or lists of corners differ in length.
    Mesh,
    /// The links of a hierarchy do not make a tree over all things.
    Hierarchy,
    /// It needs code that this program was built without: the cargo feature of this name.
    LeftOut(&'static str),
    /// The object names a material that is not in the list.
    NoSuchMaterial(u16),
    /// There are more objects than an index can name, 65535.
    TooMany,
    /// The z-buffer does not know the shape; the tracer does.
    NotRasterized,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange => f.write_str(
                "a value is not a number, too large for the number type, or light below 0 or above 1024",
            ),
            Self::MirrorWeight => f.write_str("its mirror weight is not between 0 and 1"),
            Self::Transmission => {
                f.write_str("its transmission is not between 0 and what its mirror leaves of 1")
            }
            Self::RefractiveIndex => f.write_str("its refractive index is not between 1/8 and 8"),
            Self::Roughness => f.write_str("its roughness is not between 1/64 and 1"),
            Self::FacetIndex => f.write_str("the refractive index of its facets is not between 1 and 256"),
            Self::Cone => {
                f.write_str("its cone's edge is not more than 0 and at most 90 degrees from its axis")
            }
            Self::RadiusNotPositive => f.write_str("its radius is not above zero"),
            Self::Degenerate => f.write_str("its corners coincide or lie on a line"),
            Self::TooFewCorners => f.write_str("it has fewer than three corners"),
            Self::NotFlat => f.write_str("its corners do not lie in the plane across its normal"),
            Self::CornersSwapped => f.write_str("its low corner lies above its high corner"),
            Self::NoDirection => f.write_str("its direction has no length or not the length it must have"),
            Self::NormalInward => f.write_str("the normal of a corner does not point to its outward side"),
            Self::ImageSize => f.write_str("its image is empty or more than 2048 texels wide or high"),
            Self::Voxels => f.write_str(
                "its grid has a side of fewer than 2 or more than 1024 voxels, or not as many values as that takes",
            ),
            Self::Spacing => f.write_str("its voxels are closer together than 1/1024"),
            Self::Classes => f.write_str("its classes are none or not in the order of their values"),
            Self::Samples => f.write_str("it takes no samples of a cell"),
            Self::NotClosed => f.write_str("it is of glass and has no inside: it is flat or open"),
            Self::Mesh => {
                f.write_str("a triangle names a corner that is not there, or lists differ in length")
            }
            Self::Hierarchy => f.write_str("the links of its hierarchy lead astray"),
            Self::LeftOut(feature) => {
                write!(f, "it needs the feature `{feature}`, which this program was built without")
            }
            Self::NoSuchMaterial(index) => write!(f, "it names material {index}, which is not in the list"),
            Self::TooMany => f.write_str("there are more than 65535 of them"),
            Self::NotRasterized => f.write_str("the z-buffer has no way to draw it"),
        }
    }
}
