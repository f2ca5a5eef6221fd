use super::image::project;
use super::{Case, Failure, Row};
use std::path::PathBuf;

/// Is the least ratio in dB that a row may have.
pub const WORST_PSNR: f64 = 40.0;

/// Is the share by which a figure may change unnoticed.
const TOLERANCE: f64 = 0.02;

/// Holds the rows that were measured when somebody looked at them last.
#[derive(Clone, Debug, Default)]
pub struct Snapshot(pub Vec<Row>);

impl Snapshot {
    /// Reads the snapshot that is kept with the sources.
    ///
    /// # Errors
    /// A file that is missing or holds something else.
    pub fn read() -> Result<Self, Failure> {
        let text =
            std::fs::read_to_string(path()).map_err(|error| Failure::File(path(), error.to_string()))?;
        let rows = serde_json::from_str(&text).map_err(|error| Failure::File(path(), error.to_string()))?;
        Ok(Self(rows))
    }

    /// Takes rows in the place of those of the same pictures, and keeps the others.
    pub fn update(&mut self, rows: &[Row]) {
        for row in rows {
            match self.0.iter_mut().find(|kept| kept.is_of(row)) {
                Some(kept) => kept.clone_from(row),
                None => self.0.push(row.clone()),
            }
        }
    }

    /// Writes the snapshot and answers where.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self) -> Result<PathBuf, Failure> {
        let failure = |error: String| Failure::File(path(), error);
        let text = serde_json::to_string_pretty(&self.0).map_err(|error| failure(error.to_string()))?;
        std::fs::write(path(), text + "\n").map_err(|error| failure(error.to_string()))?;
        Ok(path())
    }

    /// Answers a complaint for each figure that is not what it was, and for each picture that is too wrong.
    pub fn complaints(&self, rows: &[Row]) -> Vec<String> {
        rows.iter().flat_map(|row| self.complaints_of(row)).collect()
    }

    /// Answers a complaint for each row of a picture that is not among those to measure, and the other way round.
    pub fn strangers(&self, cases: &[Case]) -> Vec<String> {
        let gone = self.0.iter().filter(|row| !cases.iter().any(|case| case.is_of(row)));
        let new = cases.iter().filter(|case| !self.0.iter().any(|row| case.is_of(row)));
        let gone = gone.map(|row| format!("{}: kept, but nobody measures it", name(row)));
        let new = new.map(|Case { scene, chip, mode }| {
            format!("{} on {}, {mode}: not measured before; keep it by `{UPDATE}`", scene.name(), chip.name)
        });
        gone.chain(new).collect()
    }

    fn complaints_of(&self, row: &Row) -> Vec<String> {
        let mut complaints = vec![];
        // The reference has shadows and mirrors, which the z-buffer lacks.
        if row.mode != "raster" && row.psnr_db < WORST_PSNR {
            complaints.push(format!("{}: {} dB is below {WORST_PSNR} dB", name(row), row.psnr_db));
        }
        let Some(kept) = self.0.iter().find(|kept| kept.is_of(row)) else {
            complaints.push(format!("{}: not measured before; keep it by `{UPDATE}`", name(row)));
            return complaints;
        };
        for ((what, before), (_, now)) in figures(kept).into_iter().zip(figures(row)) {
            complaints.extend(change(before, now).map(|change| format!("{}: {what} {change}", name(row))));
        }
        complaints
    }
}

const UPDATE: &str = "cargo sim bench --update";

fn path() -> PathBuf {
    project().join("host-sim/bench.json")
}

fn name(row: &Row) -> String {
    format!("{} on {} in {}, {}", row.scene, row.chip, row.number, row.mode)
}

fn figures(row: &Row) -> [(&'static str, f64); 5] {
    [
        ("instructions a pixel", row.instr_per_px),
        ("cycles a pixel", row.cycles_per_px.unwrap_or(0.0)),
        ("bytes of flash", row.text_bytes as f64),
        ("bytes of static RAM", row.ram_bytes as f64),
        ("bytes of stack", row.stack_bytes as f64),
    ]
}

/// Describes a change that is too large to pass unnoticed.
fn change(before: f64, now: f64) -> Option<String> {
    let off = now - before;
    if off.abs() <= TOLERANCE * before {
        return None;
    }
    let percent = 100.0 * off / before;
    let advice = if off > 0.0 { "make it good again, or keep it by" } else { "well done; keep it by" };
    Some(format!("went from {before} to {now} ({percent:+.1} %): {advice} `{UPDATE}`"))
}

#[cfg(test)]
mod tests {
    use super::super::Choice;
    use super::*;

    fn row(instr_per_px: f64, psnr_db: f64) -> Row {
        Row {
            scene: "s".into(),
            chip: "c".into(),
            number: "n".into(),
            mode: "m".into(),
            instr_per_px,
            cycles_per_px: None,
            text_bytes: 1000,
            ram_bytes: 0,
            stack_bytes: 100,
            psnr_db,
            psnr_all_db: 0.0,
            stride: 1,
        }
    }

    #[test]
    fn two_percent_pass_and_more_is_named_with_both_figures() {
        let kept = Snapshot(vec![row(100.0, 70.0)]);
        assert!(kept.complaints(&[row(102.0, 70.0)]).is_empty());
        assert!(kept.complaints(&[row(98.0, 70.0)]).is_empty());
        let rise = kept.complaints(&[row(103.0, 70.0)]).concat();
        assert!(rise.contains("s on c in n, m") && rise.contains("from 100 to 103 (+3.0 %)"), "{rise}");
        let fall = kept.complaints(&[row(97.0, 70.0)]).concat();
        assert!(fall.contains("(-3.0 %)") && fall.contains("--update"), "{fall}");
    }

    #[test]
    fn static_ram_where_there_was_none_is_a_complaint() {
        let grown = Row { ram_bytes: 4, ..row(100.0, 70.0) };
        assert_eq!(Snapshot(vec![row(100.0, 70.0)]).complaints(&[grown]).len(), 1);
    }

    #[test]
    fn a_picture_below_forty_decibels_is_a_complaint_even_if_it_was_so_before() {
        let poor = row(100.0, 39.9);
        let complaints = Snapshot(vec![poor.clone()]).complaints(&[poor]);
        assert!(complaints.concat().contains("below 40 dB"), "{complaints:?}");
    }

    #[test]
    fn rows_that_come_or_go_are_complaints() {
        let cases = Choice { scene: Some("stars"), ..Choice::default() }.cases();
        let rows: Vec<Row> = cases
            .iter()
            .map(|Case { scene, chip, mode }| Row {
                scene: scene.name().into(),
                chip: chip.name.into(),
                number: chip.number.name().into(),
                mode: (*mode).into(),
                ..row(100.0, 70.0)
            })
            .collect();
        assert_eq!(Snapshot(rows.clone()).strangers(&cases), [""; 0]);
        let gone = Snapshot(rows.clone()).strangers(&cases[1..]).concat();
        assert!(gone.contains("stars on m4f in f32, exact: kept"), "{gone}");
        let new = Snapshot(rows[1..].to_vec()).strangers(&cases).concat();
        assert!(new.contains("stars on m4f, exact: not measured"), "{new}");
        assert_eq!(Snapshot(vec![]).complaints(&rows[..1]).len(), 1);
    }

    #[test]
    fn an_update_replaces_the_rows_of_the_same_picture_only() {
        let other = Row { chip: "d".into(), ..row(1.0, 70.0) };
        let mut kept = Snapshot(vec![row(100.0, 70.0), other.clone()]);
        kept.update(&[row(50.0, 70.0)]);
        assert_eq!(kept.0, [row(50.0, 70.0), other]);
    }
}
