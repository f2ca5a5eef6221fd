//! Colour from spectra (rows X1 and X2): what a surface reflects of a lamp, as the CIE's observer sees it.
//!
//! ```text
//! reflectance R x illuminant W -> X = k sum R W x_bar, Y, Z -> the matrix of sRGB -> Rgb
//! k = 100 / sum W y_bar, so that what reflects everything has Y = 100
//! ```
//!
//! All of it is `const fn`: a colour that is a constant reaches the device as three numbers, and no table
//! does. A lamp's colour is in its surfaces then, and the scene's lights are grey:
//!
//! ```
//! use scanray::spectrum::{A, CHART, D65};
//! use scanray::{Fixed, Light, Material, Rgb, Vec3};
//!
//! // The chart's red in daylight and in lamplight.
//! const RED: Rgb = Rgb::<f32>::from_xyz(CHART[14].reflectance.under(&D65));
//! const RED_AT_NIGHT: Rgb<Fixed> = Rgb::<Fixed>::from_xyz(CHART[14].reflectance.under(&A));
//! static PAINT: [Material; 1] = [Material::matte(RED)];
//! static DAYLIGHT: [Light; 1] = [Light::point(Vec3::new(3.0, 5.0, 4.0), Rgb::WHITE)];
//! # assert!(RED.r > 10.0 * RED.g && RED_AT_NIGHT.r.to_f64() > f64::from(RED.r));
//! ```
//!
//! That is exact for one kind of lamp in a scene. Where lamps of several kinds shine on the same surface,
//! let it have its colour under [`D65`] and each lamp its own, [`WHITE`] under it: red, green and blue are
//! then multiplied, which is off by up to 0.02 on [`CHART`] under [`C`], by up to 0.2 under [`A`].

mod chart;
mod illuminant;
mod observer;
mod sampled;
mod substance;
mod xyz;

pub use chart::{CHART, Patch};
pub use illuminant::{A, C, D65};
pub use observer::{X_BAR, Y_BAR, Z_BAR};
pub use sampled::Spectrum;
pub use substance::{ALUMINIUM, MAGNESIUM_OXIDE, WHITE};
pub use xyz::Xyz;
