use super::super::Failure;
use super::calls::Instruction;
use addr2line::Context;
use addr2line::gimli::{Dwarf, EndianSlice, LittleEndian};
use object::{File, Object, ObjectSection, ObjectSymbol, SymbolKind};
use std::collections::BTreeMap;
use std::path::Path;

/// Knows which functions the addresses of an image belong to, and its instructions.
pub struct Symbols<'a> {
    context: Context<EndianSlice<'a, LittleEndian>>,
    /// Functions by their first address.
    functions: BTreeMap<u32, &'a str>,
    /// Code by its first address.
    code: BTreeMap<u32, &'a [u8]>,
}

impl<'a> Symbols<'a> {
    /// Reads them from an image's file.
    pub fn read(path: &Path, bytes: &'a [u8]) -> Result<Self, Failure> {
        let failure = |error: String| Failure::File(path.to_owned(), error);
        let file = File::parse(bytes).map_err(|error| failure(error.to_string()))?;
        let section = |name: &str| file.section_by_name(name).and_then(|section| section.data().ok());
        let dwarf = Dwarf::load(|id| {
            Ok::<_, addr2line::gimli::Error>(EndianSlice::new(
                section(id.name()).unwrap_or_default(),
                LittleEndian,
            ))
        });
        let context = dwarf.and_then(Context::from_dwarf).map_err(|error| failure(error.to_string()))?;
        let functions = file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text);
        // The lowest bit of a function's address only says that it is Thumb code.
        let functions = functions.filter_map(|f| Some((f.address() as u32 & !1, f.name().ok()?))).collect();
        let code = file.sections().filter_map(|s| Some((s.address() as u32, s.data().ok()?)));
        let code = code.filter(|(address, data)| *address > 0 && !data.is_empty()).collect();
        Ok(Self { context, functions, code })
    }

    /// Finds the address of the function whose path ends so.
    pub fn address_of(&self, end: &str) -> Option<u32> {
        let is_it = |name: &str| format!("{:#}", rustc_demangle::demangle(name)).ends_with(end);
        self.functions.iter().find(|(_, name)| is_it(name)).map(|(address, _)| *address)
    }

    /// Answers the functions that an address lies in, the outermost first.
    pub fn frames(&self, address: u32) -> Vec<String> {
        let mut frames = vec![];
        if let Ok(mut found) = self.context.find_frames(u64::from(address)).skip_all_loads() {
            while let Ok(Some(frame)) = found.next() {
                let name = frame.function.as_ref().and_then(|name| name.demangle().ok());
                frames.extend(name.map(|name| name.into_owned()));
            }
        }
        if frames.is_empty() {
            // The compiler's own arithmetic brings no debug information.
            let function = self.functions.range(..=address).next_back();
            frames.extend(function.map(|(_, name)| format!("{:#}", rustc_demangle::demangle(name))));
        }
        frames.reverse();
        frames
    }

    /// Reads the instruction at an address.
    pub fn instruction(&self, address: u32) -> Instruction {
        let halfword = |address: u32| {
            let (start, code) = self.code.range(..=address).next_back()?;
            let bytes = code.get((address - start) as usize..)?.first_chunk::<2>()?;
            Some(u16::from_le_bytes(*bytes))
        };
        // What is not in the image is never executed.
        let halfwords = [address, address + 2].map(|address| halfword(address).unwrap_or(0));
        Instruction::read(halfwords, self.functions.contains_key(&address))
    }
}
