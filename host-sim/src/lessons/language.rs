/// Names the languages of the course.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// English.
    En,
    /// Portuguese, as written in Brazil.
    Pt,
    /// Italian.
    It,
}

impl Language {
    /// Lists all, in the order of their numbers.
    pub const ALL: [Self; 3] = [Self::En, Self::Pt, Self::It];

    /// Answers the code of ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Pt => "pt",
            Self::It => "it",
        }
    }

    /// Answers the language of a locale, such as `pt_BR.UTF-8`; English where the course has none for it.
    pub fn of_locale(locale: &str) -> Self {
        let code = locale.split(['_', '.', '@', '-']).next();
        Self::ALL.into_iter().find(|language| Some(language.code()) == code).unwrap_or(Self::En)
    }

    /// Answers the language of the user: that of the first of `LC_ALL`, `LC_MESSAGES` and `LANG` that is set (POSIX).
    pub fn of_user() -> Self {
        let set = |name| std::env::var(name).ok().filter(|locale| !locale.is_empty());
        Self::of_locale(&["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().find_map(set).unwrap_or_default())
    }

    /// Says that a file was found changed, and left so.
    pub fn says_kept(self) -> &'static str {
        match self {
            Self::En => "is kept as you changed it",
            Self::Pt => "fica como você o alterou",
            Self::It => "resta come lo hai modificato",
        }
    }

    /// Says how to run a chapter.
    pub fn says_how(self) -> &'static str {
        match self {
            Self::En => "`scanray lesson 01` runs the first chapter, `scanray lesson all` the whole course.",
            Self::Pt => {
                "`scanray lesson 01` executa o primeiro capítulo; `scanray lesson all`, o curso todo."
            }
            Self::It => "`scanray lesson 01` esegue il primo capitolo, `scanray lesson all` tutto il corso.",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locale_says_its_language_and_an_unknown_one_says_english() {
        let locales = ["pt_BR.UTF-8", "pt", "it_IT@euro", "it-CH", "en_GB.UTF-8", "C.UTF-8", "italic", ""];
        let codes = ["pt", "pt", "it", "it", "en", "en", "en", "en"];
        assert_eq!(locales.map(|locale| Language::of_locale(locale).code()), codes);
    }
}
