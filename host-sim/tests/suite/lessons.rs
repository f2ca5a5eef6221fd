//! The course: every chapter in every language, its commands, its pictures, what it says of the core.

use crate::desk::{Desk, assert_refused, read, stderr, stdout};
use host_sim::lessons::{CHAPTERS, Chapter, Fence, Language, Part, parts};
use std::path::Path;

/// Answers the blocks of a kind in a chapter's English text, in lines.
fn lines(chapter: &Chapter, kind: Fence) -> Vec<&'static str> {
    blocks(chapter, Language::En, kind).into_iter().flat_map(str::lines).collect()
}

fn blocks(chapter: &Chapter, language: Language, kind: Fence) -> Vec<&'static str> {
    let block = |part| match part {
        Part::Fenced(fence, text) if fence == kind => Some(text),
        _ => None,
    };
    parts(chapter.text(language)).into_iter().filter_map(block).collect()
}

/// Answers the words in backticks.
fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Answers the file that a command draws.
fn picture(command: &str) -> &str {
    command.split(' ').next_back().unwrap()
}

/// Runs a command as a chapter writes it.
fn run(desk: &Desk, command: &str) -> String {
    let output = desk.run(command.strip_prefix("scanray ").unwrap());
    assert!(output.status.success(), "{command}: {output:?}");
    stdout(&output)
}

/// Changes a scene file as a block of `-` and `+` lines says.
fn change(path: &Path, block: &str) {
    let side =
        |mark| block.lines().filter_map(move |line| line.strip_prefix(mark)).collect::<Vec<_>>().join("\n");
    let [old, new] = ['-', '+'].map(side);
    let text = std::fs::read_to_string(path).unwrap();
    assert_eq!(text.matches(&old).count(), 1, "{}: {old}", path.display());
    std::fs::write(path, text.replace(&old, &new)).unwrap();
}

#[test]
fn every_language_has_the_same_commands_formulas_changes_and_places_in_the_core() {
    for chapter in CHAPTERS {
        for kind in [Fence::Run, Fence::Try, Fence::Change, Fence::Same, Fence::Prints, Fence::Formula] {
            let [english, others @ ..] = Language::ALL.map(|language| blocks(chapter, language, kind));
            assert!(others.iter().all(|other| *other == english), "{}: {kind:?}", chapter.name);
        }
        assert_eq!(blocks(chapter, Language::En, Fence::Formula).len(), 1, "{}", chapter.name);
        let places = |language: Language| {
            let words = quoted(chapter.text(language));
            words.into_iter().filter(|word| word.starts_with("src/")).collect::<Vec<_>>()
        };
        let [english, others @ ..] = Language::ALL.map(places);
        assert!(!english.is_empty(), "{}", chapter.name);
        assert!(others.iter().all(|other| *other == english), "{}", chapter.name);
    }
}

#[test]
fn every_chapter_explains_in_two_hundred_words_or_so_and_names_an_author_and_a_year() {
    for chapter in CHAPTERS {
        for language in Language::ALL {
            let text = chapter.text(language);
            let explained = text.split("\n## ").next().unwrap();
            let words = explained.split_whitespace().count();
            assert!((120..=300).contains(&words), "{} {}: {words} words", chapter.name, language.code());
            let symbols = text.split("```formula").nth(1).unwrap().split("\n## ").next().unwrap();
            let is_year = |word: &str| matches!(word.parse(), Ok(1600..=2030));
            let years = symbols.split(|c: char| !c.is_ascii_digit()).filter(|word| is_year(word));
            assert!(years.count() > 0, "{} {} names no year", chapter.name, language.code());
            assert!(symbols.lines().filter(|line| line.starts_with("- ")).count() >= 2, "{}", chapter.name);
        }
    }
}

#[test]
fn the_contents_list_every_chapter_in_order_and_in_the_language_asked_for() {
    let desk = Desk::new("lesson-list");
    for language in Language::ALL {
        let text = stdout(&desk.run(&format!("lesson --lang {}", language.code())));
        for (number, chapter) in (1..).zip(CHAPTERS) {
            let title = chapter.title(language);
            assert!(title.starts_with(&format!("{number:02} ")), "{title}");
            assert!(chapter.name.starts_with(&format!("{number:02}-")), "{}", chapter.name);
            assert_eq!(text.lines().nth(number - 1), Some(&*format!("  {title}")));
        }
        assert_eq!(text.lines().filter(|line| line.starts_with("  ")).count(), CHAPTERS.len());
    }
    let [english, portuguese, italian] = Language::ALL.map(|language| CHAPTERS[0].title(language));
    assert!(english != portuguese && portuguese != italian && italian != english);
}

#[test]
fn an_unknown_chapter_is_refused_with_the_list_of_those_there_are() {
    let desk = Desk::new("lesson-unknown");
    let last = CHAPTERS[CHAPTERS.len() - 1].title(Language::En);
    for number in ["0", "17", "-1", "camera", "99999999999999999999"] {
        let arguments = format!("lesson --lang en -- {number}");
        assert_refused(&desk, &arguments, &[&format!("no chapter '{number}'"), "01 The pinhole", last]);
    }
    assert_refused(&desk, "lesson 99 --lang it", &[CHAPTERS[0].title(Language::It)]);
    assert_refused(&desk, "lesson 01 --lang fr", &["en", "pt", "it"]);
    assert_eq!(desk.files(), [""; 0]);
}

#[test]
fn every_chapter_runs_prints_what_it_quotes_and_leaves_its_picture() {
    let desk = Desk::new("lesson-all");
    let output = desk.run("lesson all --lang en -o course");
    assert!(output.status.success(), "{output:?}");
    let text = stdout(&output);
    let chapters: Vec<&str> = text.split("\n===").collect();
    assert_eq!(chapters.len(), CHAPTERS.len() + 1);
    for (chapter, told) in CHAPTERS.iter().zip(&chapters[1..]) {
        for command in lines(chapter, Fence::Run) {
            assert!(read(&desk.0.join("course").join(picture(command))).0.len() > 10_000, "{command}");
        }
        for words in lines(chapter, Fence::Prints) {
            // Once by the command, once as it is quoted.
            assert_eq!(told.matches(words).count(), 2, "{}: {words}", chapter.name);
        }
    }
    assert!(!text.contains('\u{1b}'), "escapes in what is no terminal");
    assert_eq!(desk.files(), ["course"]);
}

#[test]
fn what_a_chapter_lets_one_change_draws_another_picture_and_what_it_calls_the_same_draws_the_same() {
    let desk = Desk::new("lesson-change");
    for (number, chapter) in (1..).zip(CHAPTERS) {
        run(&desk, &format!("scanray lesson {number}"));
        let command = lines(chapter, Fence::Run)[0];
        let path = desk.0.join(picture(command));
        let drawn = read(&path);
        for command in lines(chapter, Fence::Try) {
            run(&desk, command);
            assert!(read(&desk.0.join(picture(command))).0 != drawn.0, "{command}");
        }
        let changes = blocks(chapter, Language::En, Fence::Change);
        let sames = blocks(chapter, Language::En, Fence::Same);
        assert!(changes.len() + sames.len() + lines(chapter, Fence::Try).len() > 0, "{}", chapter.name);
        let scene = desk.0.join(format!("{}.ron", chapter.name));
        for (block, is_same) in
            changes.iter().map(|one| (one, false)).chain(sames.iter().map(|one| (one, true)))
        {
            change(&scene, block);
            run(&desk, command);
            assert_eq!(read(&path).0 == drawn.0, is_same, "{}", chapter.name);
        }
    }
}

#[test]
fn a_scene_that_was_changed_is_kept_and_drawn() {
    let desk = Desk::new("lesson-kept");
    run(&desk, "scanray lesson 3 -o course --lang it");
    let course = desk.0.join("course");
    let drawn = read(&course.join("03-matte.png"));
    change(&course.join("03-matte.ron"), "-    ambient: 0.25,\n+    ambient: 0.5,\n");
    let changed = std::fs::read(course.join("03-matte.ron")).unwrap();
    let told = run(&desk, "scanray lesson 03 -o course --lang it");
    assert!(told.contains("course/03-matte.ron resta come lo hai modificato"), "{told}");
    assert_eq!(std::fs::read(course.join("03-matte.ron")).unwrap(), changed);
    assert!(read(&course.join("03-matte.png")) != drawn);
}

#[test]
fn a_command_that_fails_ends_the_chapter_with_its_own_words() {
    let desk = Desk::new("lesson-fails");
    std::fs::write(desk.0.join("02-ball.ron"), "Scene(").unwrap();
    let output = desk.run("lesson 2 --lang en");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(stderr(&output).contains("02-ball.ron:1"), "{}", stderr(&output));
    assert!(stderr(&output).contains("the chapter ends here"), "{}", stderr(&output));
    std::fs::write(desk.0.join("taken"), "").unwrap();
    let output = desk.run("lesson 1 --lang en -o taken");
    assert!(stderr(&output).contains("cannot write taken"), "{}", stderr(&output));
}

#[test]
fn the_language_is_that_of_the_locale() {
    let desk = Desk::new("lesson-locale");
    let title = |locales: [(&str, &str); 2]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_scanray"));
        let output = command.arg("lesson").current_dir(&desk.0).envs(locales).output().unwrap();
        stdout(&output).lines().next().unwrap().trim().to_owned()
    };
    let first = |language| CHAPTERS[0].title(language).to_owned();
    assert_eq!(title([("LC_ALL", "pt_BR.UTF-8"), ("LANG", "it_IT.UTF-8")]), first(Language::Pt));
    assert_eq!(title([("LC_ALL", ""), ("LANG", "it_IT.UTF-8")]), first(Language::It));
    assert_eq!(title([("LC_ALL", "de_DE.UTF-8"), ("LANG", "it_IT.UTF-8")]), first(Language::En));
}

#[test]
fn every_file_of_the_core_that_a_chapter_names_holds_the_item_named_with_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let kinds = ["struct", "fn", "enum", "trait"];
    for chapter in CHAPTERS {
        for language in Language::ALL {
            for pair in quoted(chapter.text(language)).windows(2).filter(|pair| pair[0].starts_with("src/")) {
                let source = std::fs::read_to_string(root.join(pair[0])).unwrap_or_default();
                let is_there = kinds.iter().any(|kind| {
                    let words: Vec<&str> = source.split([' ', '<', '(', '\n']).collect();
                    words.windows(2).any(|two| two == [*kind, pair[1]])
                });
                assert!(is_there, "{}: no {} in {}", chapter.name, pair[1], pair[0]);
            }
        }
    }
}
