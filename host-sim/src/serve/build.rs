//! The core, compiled for browsers.

use super::Fault;
use crate::bench::project;
use serde::Deserialize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Is the target of browsers.
const TARGET: &str = "wasm32-unknown-unknown";

/// Is what cargo says of something it has built, as far as it matters here.
#[derive(Deserialize)]
struct Built {
    #[serde(default)]
    filenames: Vec<PathBuf>,
}

/// Builds the core for browsers and answers where it lies; cargo tells the user how far it is.
///
/// # Errors
/// A toolchain without the target, or what keeps it from compiling.
pub fn wasm() -> Result<PathBuf, Fault> {
    if !has_target()? {
        return Err(Fault::NoTarget);
    }
    let output = Command::new(tool("CARGO", "cargo"))
        .args(["build", "--profile", "page", "--target", TARGET, "--package", "scanray-playground", "--lib"])
        .arg("--message-format=json-render-diagnostics")
        .current_dir(project())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| Fault::Start("cargo", error))?;
    let messages = String::from_utf8_lossy(&output.stdout);
    let built = messages.lines().filter_map(|line| serde_json::from_str::<Built>(line).ok());
    let is_wasm = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "wasm");
    let wasm = built.flat_map(|built| built.filenames).rfind(is_wasm);
    wasm.filter(|_| output.status.success()).ok_or(Fault::Build)
}

/// Tells whether the toolchain has the target's standard library.
fn has_target() -> Result<bool, Fault> {
    let output = Command::new(tool("RUSTC", "rustc"))
        .args(["--print", "target-libdir", "--target", TARGET])
        .current_dir(project())
        .output()
        .map_err(|error| Fault::Start("rustc", error))?;
    Ok(Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir())
}

/// Answers the program that a variable of cargo names, or the usual one.
fn tool(variable: &str, usual: &str) -> OsString {
    std::env::var_os(variable).unwrap_or_else(|| usual.into())
}
