//! Where a picture's instructions go on a chip: those of each row, and of each of its pixels traced alone.

use super::emulator::{self, Said};
use super::image::Image;
use super::truth::checksum;
use super::{Chip, Failure, SIZE};
use crate::bake::source::{Literal, Planted};
use crate::bake::{Accel, meshes};
use crate::cost::Account;
use crate::scenes::Entry;
use crate::shot::{Number, Refusal};
use scanray::{Exact, Fixed};

/// Is the mode of the firmware in which it accounts for its pixels.
const MODE: &str = "account";

/// Counts the instructions of each row and pixel of a scene on a chip, in a picture of [`SIZE`], one ray a pixel, in the number that suits it.
///
/// # Errors
/// What keeps the image from being built or run, or a picture that is not the host's.
pub fn account(chip: &Chip, scene: &Entry, depth: u8) -> Result<Account, Failure> {
    match chip.number {
        Number::F32 => account_in::<f32>(chip, scene, depth),
        _ => account_in::<Fixed>(chip, scene, depth),
    }
}

fn account_in<S: Literal>(chip: &Chip, scene: &Entry, depth: u8) -> Result<Account, Failure> {
    let mut view = *S::view(scene);
    view.settings = view.settings.with_depth(depth);
    let drawn = checksum(&view, view.settings.with_quality(Exact), 1).map_err(Refusal::from)?;
    let grown = meshes::grow(&view, scene.double, Accel::default());
    let source = Planted { view, grown, tree: None }.write()?;
    let image = Image::build_baked(chip, &source, &scene.double.scene, MODE)?;
    let said = emulator::count_each(chip, &image).map_err(without_rows)?;
    if said.figure(MODE, "checksum").map_err(without_rows)? != drawn {
        return Err(Failure::OtherPicture(view.name.to_owned(), chip.name));
    }
    read(&said).ok_or_else(|| Failure::Firmware("rows are missing in its account".to_owned()))
}

/// Leaves out the rows that the firmware has said before it failed: there are hundreds of numbers in each.
fn without_rows(failure: Failure) -> Failure {
    let Failure::Firmware(said) = failure else { return failure };
    let others: Vec<&str> = said.lines().filter(|line| !line.starts_with("row ")).collect();
    Failure::Firmware(others.join("\n"))
}

/// Reads a line for each row: its own instructions, then those of its pixels.
fn read(said: &Said) -> Option<Account> {
    let mut account = Account { rows: vec![], pixels: vec![] };
    for line in said.lines("row ") {
        let counts: Vec<u64> =
            line.split(' ').map(|ticks| ticks.parse().ok().map(emulator::each)).collect::<Option<_>>()?;
        let (row, pixels) = counts.split_first()?;
        account.rows.push(*row);
        account.pixels.extend(pixels);
    }
    let [width, height] = SIZE.map(|side| side as usize);
    (account.rows.len() == height && account.pixels.len() == width * height).then_some(account)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_account_with_a_pixel_too_few_is_refused() {
        let row = |pixels: usize| format!("row 800{}\n", " 16".repeat(pixels));
        let said = |last| Said::from("measured\n".to_owned() + &row(320).repeat(239) + &row(last));
        let account = read(&said(320)).unwrap();
        // 64 ns an instruction, 40 ns a tick.
        assert_eq!((account.rows[239], account.pixels[76_799]), (500, 10));
        assert_eq!([319, 321].map(|last| read(&said(last))), [None, None]);
    }
}
