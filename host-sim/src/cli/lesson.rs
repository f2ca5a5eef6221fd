use super::{Error, report};
use crate::lessons::{CHAPTERS, Chapter, Fence, Language, Part, contents, laid_out, needed, parts};
use clap::Args;
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    scanray lesson\n  \
    scanray lesson 03 -o course\n  \
    scanray lesson all --lang it -o corso\n\n\
    A chapter draws its picture from a scene file that it leaves beside it: change the file and draw again.")]
pub(super) struct LessonArgs {
    /// Number of a chapter, such as 03, or `all` [default: all are listed]
    #[arg(value_name = "CHAPTER")]
    pub chapter: Option<String>,
    /// Language of the course [default: that of LC_ALL, LC_MESSAGES or LANG if the course has it, else en]
    #[arg(long)]
    pub lang: Option<Language>,
    /// Directory for scene files and pictures [default: the current directory]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// Lists the chapters, or tells one and runs its commands.
pub(super) fn run(args: &LessonArgs, out: &mut impl Write) -> Result<(), Error> {
    let language = args.lang.unwrap_or_else(Language::of_user);
    let folder = args.output.as_deref().unwrap_or(Path::new(""));
    match args.chapter.as_deref() {
        None => Ok(writeln!(out, "{}\n{}", contents(language), language.says_how())?),
        Some("all") => CHAPTERS.iter().try_for_each(|chapter| tell(chapter, language, folder, out)),
        Some(number) => match Chapter::find(number) {
            Some(chapter) => tell(chapter, language, folder, out),
            None => Err(Error::UnknownChapter(number.to_owned(), language)),
        },
    }
}

/// Prints a chapter, and runs its commands where they stand.
fn tell(chapter: &Chapter, language: Language, folder: &Path, out: &mut impl Write) -> Result<(), Error> {
    for part in parts(chapter.text(language)) {
        match part {
            Part::Fenced(kind @ (Fence::Run | Fence::Try), commands) => {
                for command in commands.lines() {
                    let words = placed(command, folder);
                    writeln!(out, "    {}\n", shown(&words))?;
                    if kind == Fence::Run {
                        put_files(command, language, folder, out)?;
                        execute(words, out)?;
                    }
                }
            }
            part => out.write_all(laid_out(&part).as_bytes())?,
        }
    }
    Ok(())
}

/// Answers the words of a command, its files in a folder.
fn placed(command: &str, folder: &Path) -> Vec<OsString> {
    let is_file =
        |word: &str| Path::new(word).extension().is_some_and(|ending| ending == "ron" || ending == "png");
    let place = |word: &str| if is_file(word) { folder.join(word).into() } else { word.into() };
    command.split(' ').map(place).collect()
}

/// Writes a command as a shell takes it.
fn shown(words: &[OsString]) -> String {
    let quoted = |word: &OsString| {
        let word = word.to_string_lossy();
        if word.contains(' ') { format!("'{word}'") } else { word.into_owned() }
    };
    words.iter().map(quoted).collect::<Vec<_>>().join(" ")
}

/// Puts the scenes of a command into the folder, where they may have been changed.
fn put_files(command: &str, language: Language, folder: &Path, out: &mut impl Write) -> Result<(), Error> {
    if !folder.as_os_str().is_empty() {
        fs::create_dir_all(folder).map_err(|error| Error::Write(folder.to_owned(), error))?;
    }
    for file in needed(command) {
        let path = folder.join(file.name);
        if file.put_into(folder).map_err(|error| Error::Write(path.clone(), error))? {
            report::line(out, path.display().to_string().as_str(), format!(" {}", language.says_kept()))?;
        }
    }
    Ok(())
}

/// Runs a command as if it had been typed; what goes wrong it has told by itself.
fn execute(words: Vec<OsString>, out: &mut impl Write) -> Result<(), Error> {
    out.flush()?;
    let command = shown(&words);
    if super::run(words) != ExitCode::SUCCESS {
        return Err(Error::Chapter(command));
    }
    Ok(writeln!(out)?)
}
