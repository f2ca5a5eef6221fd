use super::Spectrum;

/// Is the perfect diffuser: all of each wavelength comes back.
pub const WHITE: Spectrum = Spectrum::new(380, 5, &[1.0]);

/// Is freshly evaporated aluminium, looked at along its normal (G. Hass, in the American Institute of
/// Physics Handbook, 1965): a mirror of 0.91 that is hardly bluer than white.
pub const ALUMINIUM: Spectrum =
    Spectrum::new(400, 50, &[0.924, 0.922, 0.918, 0.915, 0.911, 0.905, 0.897, 0.886, 0.867]);

/// Is pressed magnesium oxide, the white of ceramics: 0.98 with a very flat maximum at 540 nm and
/// within 0.02 of it from 400 to 700 nm (W. E. K. Middleton and C. L. Sanders, J. Opt. Soc. Am. 41, 419,
/// 1951).
pub const MAGNESIUM_OXIDE: Spectrum = Spectrum::new(380, 5, &[0.98]);
