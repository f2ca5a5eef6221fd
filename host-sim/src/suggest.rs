//! Suggestions: the known word that a misspelt one was meant to be.

/// Is the longest word that is compared, in bytes: the time that takes grows as the product of the lengths, and
/// names of megabytes would take days.
const LONGEST: usize = 100;

/// Answers the word that is most like a misspelt one, if any is like it at all: the one it begins, or one
/// with at most a wrong letter in three.
pub fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    if word.len() > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    let known: Vec<&str> = known.into_iter().filter(|known| known.len() <= LONGEST).collect();
    let begins = |known: &&&str| word.len() >= 3 && known.to_lowercase().starts_with(&word);
    known.iter().find(begins).copied().or_else(|| {
        let typos = |known: &&str| strsim::osa_distance(&word, &known.to_lowercase());
        let nearest = known.into_iter().min_by_key(typos)?;
        (3 * typos(&nearest) <= nearest.chars().count()).then_some(nearest)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_word_finds_its_own_and_nonsense_finds_none() {
        let known = ["red", "color", "texture", "Sphere"];
        let pairs = [
            ("rde", Some("red")),
            ("colr", Some("color")),
            ("colour", Some("color")),
            ("tex", Some("texture")),
            ("sphere", Some("Sphere")),
            ("zzz", None),
            ("", None),
        ];
        for (word, meant) in pairs {
            assert_eq!(nearest(word, known), meant, "{word}");
        }
        assert_eq!(nearest("red", []), None);
        let endless = "red".repeat(1 << 22);
        assert_eq!([nearest(&endless, [&*endless]), nearest("re", [&*endless])], [None, None]);
    }
}
