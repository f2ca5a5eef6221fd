//! Finds what can panic: whoever names the panic handler, whoever names those, and so on up to the entry.

use crate::bench::{Failure, Image, Symbols, plain};
use object::{File, Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionKind, Symbol, SymbolKind};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Ends the names of the functions that every panic leads to, and the paths of those on the way.
const HANDLER: &str = "rust_begin_unwind";
const MACHINERY: &str = "core::panicking::";

/// Is a place where a panic may begin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Panic {
    /// The functions it lies in, the innermost first: those that are inlined there, then the one with an address of
    /// its own.
    pub within: Vec<String>,
    /// The functions that lead there, from the caller up to the entry.
    pub callers: Vec<String>,
}

impl fmt::Display for Panic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let chain: Vec<_> = self.within.iter().chain(&self.callers).map(|name| plain(name)).collect();
        f.write_str(&chain.join(" < "))
    }
}

/// Answers the places of an image where a panic may begin.
///
/// What is never called is not in an image: the linker leaves it out.
pub(super) fn panics(image: &Image) -> Result<Vec<Panic>, Failure> {
    let bytes = image.read()?;
    let failure = |error: String| Failure::File(image.path.to_path_buf(), error);
    let file = File::parse(&*bytes).map_err(|error| failure(error.to_string()))?;
    let calls = Calls::read(&file);
    if calls.functions.is_empty() || calls.mentions.is_empty() {
        return Err(failure("it has no symbols or no relocations, so that nothing is proven".to_owned()));
    }
    let symbols = Symbols::read(&image.path, &bytes)?;
    let mut panics: Vec<Panic> = calls.panics(|site| symbols.frames(site)).collect();
    panics.dedup();
    Ok(panics)
}

/// Knows which functions there are and which names which.
#[derive(Default)]
struct Calls {
    /// Functions by their first address.
    functions: BTreeMap<u32, String>,
    /// The places that name a function, each with that function's first address.
    mentions: Vec<(u32, u32)>,
}

impl Calls {
    fn read(file: &File<'_>) -> Self {
        // The lowest bit of a function's address only says that it is Thumb code.
        let address = |symbol: &Symbol<'_, '_>| symbol.address() as u32 & !1;
        let functions = file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text);
        let functions = functions.filter_map(|symbol| {
            Some((address(&symbol), format!("{:#}", rustc_demangle::demangle(symbol.name().ok()?))))
        });
        let functions: BTreeMap<u32, String> = functions.collect();
        let holds = |kind| matches!(kind, SectionKind::Text | SectionKind::Data | SectionKind::ReadOnlyData);
        let relocations = file.sections().filter(|section| holds(section.kind()));
        let relocations = relocations.flat_map(|section| section.relocations());
        let mentions = relocations.filter_map(|(place, relocation)| {
            let RelocationTarget::Symbol(symbol) = relocation.target() else { return None };
            let named = address(&file.symbol_by_index(symbol).ok()?);
            functions.contains_key(&named).then_some((place as u32, named))
        });
        Self { mentions: mentions.collect(), functions }
    }

    /// Answers the first address and the name of the function that an address lies in.
    fn function_at(&self, address: u32) -> Option<(u32, &str)> {
        self.functions.range(..=address).next_back().map(|(first, name)| (*first, name.as_str()))
    }

    /// Answers where panics begin; `frames` names the functions that an address lies in, the outermost first.
    fn panics(&self, frames: impl Fn(u32) -> Vec<String>) -> impl Iterator<Item = Panic> {
        let is_machinery = |name: &str| name.ends_with(HANDLER) || plain(name).starts_with(MACHINERY);
        let machinery = self.functions.iter().filter(move |(_, name)| is_machinery(name));
        let machinery: BTreeSet<u32> = machinery.map(|(first, _)| *first).collect();
        let begins = self.mentions.iter().filter_map(move |(place, named)| {
            let (first, _) = self.function_at(*place)?;
            (machinery.contains(named) && !machinery.contains(&first)).then_some((*place, first))
        });
        begins.map(move |(place, first)| {
            let within: Vec<String> = frames(place).into_iter().rev().collect();
            Panic { within, callers: self.callers(first) }
        })
    }

    /// Answers the shortest chain of functions that leads to one, from its caller up to the entry.
    fn callers(&self, function: u32) -> Vec<String> {
        let mut known = BTreeSet::from([function]);
        let mut chains = vec![(function, vec![])];
        let mut longest = vec![];
        while !chains.is_empty() {
            let mut next = vec![];
            for (callee, chain) in &chains {
                let callers = self.mentions.iter().filter(|(_, named)| named == callee);
                for (first, name) in callers.filter_map(|(place, _)| self.function_at(*place)) {
                    if known.insert(first) {
                        let mut chain: Vec<String> = chain.clone();
                        chain.push(name.to_owned());
                        next.push((first, chain));
                    }
                }
            }
            if let Some((_, chain)) = next.first() {
                longest.clone_from(chain);
            }
            chains = next;
        }
        longest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The entry at 0 calls 100, which calls 200 and the handler at 300; 200 calls the machinery at 400, and that the
    /// handler.
    fn calls() -> Calls {
        let names =
            ["main", "draw", "scanray::trace", "__rustc::rust_begin_unwind", "core::panicking::panic_fmt"];
        let functions = (0..).step_by(100).zip(names.map(str::to_owned)).collect();
        Calls { functions, mentions: vec![(10, 100), (110, 200), (120, 300), (230, 400), (410, 300)] }
    }

    #[test]
    fn a_panic_is_told_with_those_who_lead_to_it() {
        let found: Vec<_> =
            calls().panics(|site| vec![format!("at {site}")]).map(|p| p.to_string()).collect();
        assert_eq!(found, ["at 120 < main", "at 230 < draw < main"]);
    }

    #[test]
    fn without_a_handler_nothing_panics() {
        let mut calls = calls();
        calls.functions.retain(|_, name| !name.starts_with("core") && !name.starts_with("__rustc"));
        calls.mentions.retain(|(_, named)| calls.functions.contains_key(named));
        assert_eq!(calls.panics(|_| vec![]).count(), 0);
    }

    #[test]
    fn functions_that_call_each_other_have_callers_all_the_same() {
        let mut calls = calls();
        calls.mentions.push((210, 100));
        assert_eq!(calls.callers(200), ["draw", "main"]);
    }
}
