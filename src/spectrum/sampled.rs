/// Is a quantity that depends on the wavelength, known in equal steps of it.
///
/// Between two samples it is the straight line, beyond the outermost it is theirs, as CIE 15:2004 (7.2.3)
/// has it of what was not measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spectrum {
    first: u16,
    step: u16,
    samples: &'static [f64],
}

impl Spectrum {
    /// Makes a spectrum of its samples and the wavelengths of the first and between two, in nanometres.
    ///
    /// Without samples it is 0; a step of 0 counts as 1.
    pub const fn new(first: u16, step: u16, samples: &'static [f64]) -> Self {
        Self { first, step, samples }
    }

    /// Answers the value at a wavelength in nanometres.
    pub const fn at(&self, nanometres: u16) -> f64 {
        let step = if self.step == 0 { 1 } else { self.step };
        let past = nanometres.saturating_sub(self.first);
        let (place, share) = ((past / step) as usize, (past % step) as f64 / step as f64);
        match self.samples.split_at_checked(place) {
            Some((_, [here, next, ..])) => *here + (*next - *here) * share,
            Some((_, [last])) | Some(([.., last], [])) => *last,
            Some(([], [])) => 0.0,
            None => match self.samples {
                [.., last] => *last,
                [] => 0.0,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_samples_lies_the_straight_line_and_beyond_them_the_last() {
        const SLOPE: Spectrum = Spectrum::new(400, 10, &[1.0, 2.0, 4.0]);
        let values = [0, 400, 405, 410, 415, 420, 425, 430, u16::MAX].map(|nm| SLOPE.at(nm));
        assert_eq!(values, [1.0, 1.0, 1.5, 2.0, 3.0, 4.0, 4.0, 4.0, 4.0]);
    }

    #[test]
    fn no_samples_and_no_step_are_no_reason_to_stop() {
        assert_eq!(Spectrum::new(400, 5, &[]).at(450), 0.0);
        assert_eq!(Spectrum::new(400, 0, &[1.0, 3.0]).at(401), 3.0);
    }
}
