//! Names of crates.

/// Lists the words that Rust or cargo keeps for itself: keywords, crates of the language, folders that cargo builds in.
const KEPT: &[&str] = &[
    "abstract",
    "alloc",
    "as",
    "async",
    "await",
    "become",
    "box",
    "break",
    "build",
    "const",
    "continue",
    "core",
    "crate",
    "deps",
    "do",
    "dyn",
    "else",
    "enum",
    "examples",
    "extern",
    "false",
    "final",
    "fn",
    "for",
    "gen",
    "if",
    "impl",
    "in",
    "incremental",
    "let",
    "loop",
    "macro",
    "match",
    "mod",
    "move",
    "mut",
    "override",
    "priv",
    "proc_macro",
    "pub",
    "ref",
    "return",
    "self",
    "Self",
    "static",
    "std",
    "struct",
    "super",
    "test",
    "trait",
    "true",
    "try",
    "type",
    "typeof",
    "unsafe",
    "unsized",
    "use",
    "virtual",
    "where",
    "while",
    "yield",
];

/// Is the longest name that a registry takes.
const LONGEST: usize = 64;

/// Answers whether a crate of firmware may be called so.
pub fn is_crate_name(name: &str) -> bool {
    let begins = name.starts_with(|first: char| first.is_ascii_alphabetic());
    let goes_on = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
    begins && goes_on && name.len() <= LONGEST && !KEPT.contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_crates_are_letters_digits_and_dashes_that_mean_nothing_to_rust() {
        for name in ["a", "my-picture", "my_picture2", "Ball", &"x".repeat(LONGEST)] {
            assert!(is_crate_name(name), "{name}");
        }
        let wrong =
            ["", "2balls", "-x", "_x", "my picture", "ball/", "kugel\u{e4}", "a.b", "fn", "core", "deps"];
        for name in wrong.into_iter().chain([&*"x".repeat(LONGEST + 1)]) {
            assert!(!is_crate_name(name), "{name}");
        }
    }
}
