/// Is the factor by which a picture of differences shows them.
const GAIN: u8 = 16;
/// Is what marks the pixels beside silhouettes.
const TINT: u8 = 48;

/// Makes a picture of the differences of two: sixteenfold, with a blue tint beside silhouettes.
pub fn difference(shown: &[[u8; 3]], reference: &[[u8; 3]], mask: &[bool]) -> Vec<[u8; 3]> {
    let pixel = |((a, b), masked): ((&[u8; 3], &[u8; 3]), &bool)| {
        let [red, green, blue] = std::array::from_fn(|i| a[i].abs_diff(b[i]).saturating_mul(GAIN));
        [red, green, if *masked { blue.max(TINT) } else { blue }]
    };
    shown.iter().zip(reference).zip(mask).map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_amplified_and_silhouettes_tinted() {
        let picture = difference(&[[10, 20, 30], [0; 3]], &[[11, 20, 3], [0; 3]], &[false, true]);
        assert_eq!(picture, [[16, 0, 255], [0, 0, TINT]]);
    }
}
