use crate::compare::Figures;
use crate::memory::Bill;
use crate::shot::{Approach, Number, Quality, Sampling, Shot, Taken};
use scanray::{Fixed, RasterWorkspace, Scalar, Transfer};
use std::fmt::Display;
use std::io::{self, Write};
use std::time::Duration;

/// Prints a line of a report: what it is about, then what there is to say.
pub(super) fn line(out: &mut impl Write, about: &str, say: impl Display) -> io::Result<()> {
    writeln!(out, "  {about:<11}{say}")
}

/// Prints what a picture is and what it took.
pub(super) fn taken(out: &mut impl Write, shot: &Shot, taken: &Taken) -> io::Result<()> {
    writeln!(out, "{}: {}", shot.scene.name(), shot.scene.double.about)?;
    line(out, "picture", picture(shot))?;
    if let Some(tested) = taken.fragments {
        let time = milliseconds(taken.time);
        line(out, "z-buffer", format!("{} depths tested, no rays, {time}", thousands(tested)))?;
    }
    match &taken.rays {
        Some(rays) => {
            let kinds = [
                (rays.primary, "primary"),
                (rays.shadow, "shadow"),
                (rays.reflection, "reflection"),
                (rays.refraction, "refraction"),
            ];
            let told = kinds.iter().filter(|(count, _)| *count > 0);
            let told: Vec<_> = told.map(|(count, kind)| format!("{} {kind}", thousands(*count))).collect();
            line(out, "rays", told.join(", "))?;
            line(out, "time", pace(rays.total(), taken.time))?;
        }
        None if taken.fragments.is_some() => {}
        None => line(out, "time", milliseconds(taken.time))?,
    }
    if shot.number == Number::Fixed {
        let (largest, limit) = (shot.scene.fixed.scene.largest(), Fixed::LIMIT);
        let (largest, limit) = (largest.to_f64(), limit.to_f64());
        line(out, "units", format!("largest coordinate {largest:.1}, of {limit:.0} that fixed point takes"))?;
    }
    line(out, "RAM", memory(shot))
}

/// Prints how far a picture is from the reference.
pub(super) fn difference(out: &mut impl Write, figures: &Figures) -> io::Result<()> {
    let Figures { psnr_db, psnr_all_db, worst, .. } = figures;
    let worst = (worst * 255.0).round();
    line(
        out,
        "difference",
        format!(
            "{psnr_db:.1} dB PSNR from the f64 reference ({psnr_all_db:.1} dB with silhouettes), \
             worst pixel off by {worst}/255"
        ),
    )
}

fn picture(shot: &Shot) -> String {
    let [columns, rows] = shot.size;
    let transfer = match shot.transfer {
        Transfer::Srgb => "srgb",
        Transfer::Linear => "linear",
    };
    let (number, panel, depth) = (shot.number.name(), shot.panel.name(), shot.depth);
    let rays = samples(shot.quality);
    format!(
        "{columns}x{rows} pixels, number {number}, panel {panel}, depth {depth}, transfer {transfer}{rays}"
    )
}

fn samples(quality: Quality) -> String {
    let Quality::Sampled(Sampling { side, jittered, at_edges }) = quality else { return String::new() };
    let scattered = if jittered { " scattered" } else { "" };
    let place = if at_edges { "a pixel on an edge" } else { "a pixel" };
    format!(", {side}x{side}{scattered} rays {place}")
}

fn memory(shot: &Shot) -> String {
    let [columns, _] = shot.size;
    if shot.approach == Approach::Raster && shot.number != Number::Oracle {
        let place = size_of::<RasterWorkspace<f32, 1>>();
        let total = columns as usize * place;
        return format!("{total} bytes = {columns} columns x {place} for depths, on a device");
    }
    let bill = match shot.number {
        Number::F32 => Bill::new::<f32>(columns, shot.panel, shot.depth),
        Number::Fixed => Bill::new::<Fixed>(columns, shot.panel, shot.depth),
        Number::Exact | Number::Oracle => return "f64 is for measuring, no device needs room for it".into(),
    };
    format!("{bill}, on a device")
}

pub(super) fn milliseconds(time: Duration) -> String {
    format!("{:.1} ms", time.as_secs_f64() * 1e3)
}

fn pace(rays: u64, time: Duration) -> String {
    // A clock may be too coarse for a tiny picture.
    let seconds = time.as_secs_f64().max(1e-9);
    format!("{}, {:.2} million rays/s on this computer", milliseconds(time), rays as f64 / seconds / 1e6)
}

/// Writes a number with its digits in threes.
pub(super) fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_come_in_threes() {
        assert_eq!(
            ["0", "999", "1,000", "57,600", "1,234,567"],
            [0, 999, 1_000, 57_600, 1_234_567].map(thousands)[..]
        );
    }
}
