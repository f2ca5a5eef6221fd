//! What runs on the chip: each scene in each way, with its checksum and its stack.

#[cfg_attr(target_arch = "arm", path = "cortex.rs")]
#[cfg_attr(target_arch = "riscv32", path = "riscv.rs")]
mod chip;
#[path = "../../boards/decimal.rs"]
mod decimal;
#[path = "../frames.rs"]
mod frames;
mod host;
mod planted;
mod stack;
#[path = "../turning.rs"]
mod turning;

use core::{hint::black_box, panic::PanicInfo};
use scanray::gallery::{Gallery, View};

use self::{decimal::Decimal, frames::WAYS};

/// Proves whatever number the image is built for.
fn prove() -> ! {
    planted::call();
    match option_env!("SCANRAY_NUMBER") {
        Some("f32") => prove_number::<f32>(),
        _ => prove_number::<scanray::Fixed>(),
    }
    host::end(true)
}

/// Draws the gallery, or turn after turn if the image is built for those.
fn prove_number<S: Gallery>() {
    match option_env!("SCANRAY_TURNS").and_then(|turns| turns.parse().ok()) {
        Some(turns) => prove_turns::<S>(turns),
        None => prove_gallery::<S>(),
    }
}

/// Says `turn CHECKSUM` after each.
fn prove_turns<S: Gallery>(turns: u32) {
    let Some(view) = S::find(turning::SCENE) else { return };
    let mut space = turning::Space::new();
    for number in 0..turns {
        let Some(checksum) = turning::turn(view, &mut space, number) else { return };
        say(&["turn ", text(&Decimal::new(checksum))]);
    }
}

fn prove_gallery<S: Gallery>() {
    // Nothing is known of the scenes when this is compiled.
    for view in black_box(S::views()) {
        for (way, name) in WAYS.iter().enumerate() {
            prove_picture(view, black_box(way), name);
        }
    }
}

/// Says `SCENE WAY CHECKSUM STACK`, the stack without what the caller holds; nothing of a picture that the core
/// refuses to draw.
#[inline(never)]
fn prove_picture<S: Gallery>(view: &View<S>, way: usize, name: &str) {
    stack::paint();
    let Ok(checksum) = frames::checksum(view, way) else { return };
    let used = stack::used().wrapping_sub(frames::held_bytes::<S>(way) as u32);
    say(&[view.name, " ", name, " ", text(&Decimal::new(checksum)), " ", text(&Decimal::new(used))]);
}

/// Answers the digits as text.
fn text(decimal: &Decimal) -> &str {
    str::from_utf8(decimal.as_bytes()).unwrap_or_default()
}

/// Says a line.
fn say(parts: &[&str]) {
    parts.iter().chain(&["\n"]).for_each(|part| host::write(part));
}

/// Is the place that every panic leads to: no image of a core that cannot panic has it.
#[panic_handler]
#[inline(never)]
fn panicked(info: &PanicInfo) -> ! {
    say(&["failed: the firmware panicked in ", info.location().map_or("no file", |place| place.file())]);
    host::end(false)
}
