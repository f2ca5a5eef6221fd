use super::Room;
use crate::bench::Row;
use crate::memory::Bill;
use crate::panel::Panel;
use crate::shot::{Number, Shot};
use maud::{DOCTYPE, Markup, html};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, PercentEncode, utf8_percent_encode};
use scanray::Fixed;

/// Is what the entrance says of a scene.
#[derive(Debug)]
pub struct Card {
    name: &'static str,
    about: &'static str,
    size: [u32; 2],
    /// The ratio in dB of the core's numbers to the reference.
    psnr: Vec<(Number, f64)>,
}

impl Card {
    /// Answers the scene's name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Takes from a room what its card says.
    pub fn of(room: &Room) -> Self {
        let psnr = |number| {
            let figures = room.work(number, room.shot.panel)?.figures.as_ref()?;
            Some((number, figures.psnr_db))
        };
        let view = room.shot.scene.double;
        let psnr = [Number::F32, Number::Fixed].into_iter().filter_map(psnr).collect();
        Self { name: view.name, about: view.about, size: room.shot.size, psnr }
    }
}

/// Writes a name as part of an address, in which `#`, `?` and `%` mean something of their own (RFC 3986).
fn address(name: &str) -> PercentEncode<'_> {
    const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.');
    utf8_percent_encode(name, PLAIN)
}

/// Writes the page that leads to the rooms.
pub fn entrance(cards: &[Card]) -> String {
    let content = html! {
        p {
            "Scenes of a ray tracer for the displays of microcontrollers. Each is drawn in every number that the tracer knows, "
            "shown as every panel shows it, and compared with a reference: a second tracer in 64 bits, by other formulas."
        }
        ul.cards {
            @for Card { name, about, size: [columns, rows], psnr } in cards {
                li {
                    a href={ (address(name)) "/index.html" } {
                        img src={ (address(name)) "/f32-rgb565.png" } width=(columns) height=(rows) alt=(about) loading="lazy";
                        h2 { (name) }
                    }
                    p { (about) }
                    p.figures {
                        @for (number, psnr) in psnr { span { (number.name()) " " (decibels(*psnr)) } " " }
                    }
                }
            }
        }
    };
    page("scanray: the gallery", "", &content)
}

/// Writes the page of a scene; `rows` is what it costs on chips.
pub fn room(room: &Room, rows: &[&Row]) -> String {
    let shot = &room.shot;
    let content = html! {
        nav { a href="../index.html" { "All scenes" } }
        p { (shot.scene.double.about) }
        (pictures(room))
        (differences(room))
        (cost(room, rows))
        (ram(shot))
        @if shot.scene.file.is_none() {
            h2 { "Draw it yourself" }
            pre { code {
                "cargo sim render " (shot.scene.name()) " --number fixed --panel rgb565\n"
                "cargo sim explain " (shot.scene.name()) " " (shot.size[0] / 2) " " (shot.size[1] / 2) "\n"
                "cargo sim export " (shot.scene.name()) " -o mine.ron"
            } }
        }
    };
    page(shot.scene.name(), "../", &content)
}

/// Shows each number in a row, each panel in a column.
fn pictures(room: &Room) -> Markup {
    let [columns, rows] = room.shot.size;
    html! {
        h2 { "Every number, every panel" }
        div.wide { table {
            thead { tr {
                th scope="col" { "Number" }
                @for panel in Panel::ALL { th scope="col" { (panel.name()) } }
            } }
            tbody { @for number in Number::ALL { tr {
                th scope="row" { (number.name()) }
                @for work in Panel::ALL.iter().filter_map(|panel| room.work(number, *panel)) {
                    td {
                        a href=(work.file()) {
                            img src=(work.file()) width=(columns) height=(rows) loading="lazy"
                                alt={ (room.shot.scene.name()) " in " (number.name()) " on " (work.panel.name()) };
                        }
                        @match &work.figures {
                            Some(figures) => span.figures { (decibels(figures.psnr_db)) },
                            None => span.figures { "the reference" },
                        }
                    }
                }
            } } }
        } }
        p.note { "Peak signal-to-noise ratios to the reference on the same panel, away from silhouettes; 99 dB are equal pictures." }
    }
}

/// Shows where the core's numbers differ from the reference.
fn differences(room: &Room) -> Markup {
    let [columns, rows] = room.shot.size;
    let shown =
        room.works.iter().filter_map(|work| Some((work, work.figures.as_ref()?, work.difference.as_ref()?)));
    html! {
        h2 { "Where they differ" }
        div.row {
            @for (work, figures, _) in shown {
                figure {
                    img src=(work.difference_file()) width=(columns) height=(rows) loading="lazy"
                        alt={ "difference of " (work.number.name()) " from the reference" };
                    figcaption {
                        (work.number.name()) ": " (decibels(figures.psnr_db)) ", with silhouettes "
                        (decibels(figures.psnr_all_db)) "; " (format!("{:.2}", 100.0 * figures.over_8))
                        " % of the pixels off by more than 8/255, the worst by " (format!("{:.0}", 255.0 * figures.worst))
                    }
                }
            }
        }
        p.note { "Differences from the reference on " (room.shot.panel.name()) ", sixteenfold; blue marks silhouettes." }
    }
}

/// Tells what the picture takes: rays and operations of a pixel, instructions of chips.
fn cost(room: &Room, rows: &[&Row]) -> Markup {
    let pixels = room.map.pixels.len().max(1) as f64;
    let mean =
        |of: fn(&crate::cost::Bill) -> u64| room.map.pixels.iter().map(of).sum::<u64>() as f64 / pixels;
    let means = [
        ("rays from the eye", mean(|bill| bill.rays.primary)),
        ("rays to lights", mean(|bill| bill.rays.shadow)),
        ("mirrored rays", mean(|bill| bill.rays.reflection)),
        ("rays through glass", mean(|bill| bill.rays.refraction)),
        ("shapes asked", mean(|bill| bill.shapes)),
        ("operations", mean(|bill| bill.operations.total())),
    ];
    html! {
        h2 { "What it costs" }
        img.whole src="rays.png" alt="map of the rays that each pixel takes" loading="lazy";
        div.row {
            table {
                caption { "A pixel, on average" }
                @for (what, mean) in means { tr { th scope="row" { (what) } td { (format!("{mean:.2}")) } } }
            }
            @if !rows.is_empty() { (chips(rows)) }
        }
    }
}

fn chips(rows: &[&Row]) -> Markup {
    html! {
        table {
            caption { "On chips, at 320x240" }
            thead { tr {
                @for head in ["Chip", "Number", "Mode", "Instructions a pixel", "Flash, bytes", "Stack, bytes"] {
                    th scope="col" { (head) }
                }
            } }
            tbody { @for row in rows { tr {
                td { (row.chip) } td { (row.number) } td { (row.mode) }
                td { (format!("{:.1}", row.instr_per_px)) } td { (row.text_bytes) } td { (row.stack_bytes) }
            } } }
        }
    }
}

/// Tells the RAM of a device for each panel.
fn ram(shot: &Shot) -> Markup {
    let [columns, _] = shot.size;
    html! {
        h2 { "RAM on a device" }
        table {
            thead { tr { th scope="col" { "Panel" } th scope="col" { "f32" } th scope="col" { "fixed" } } }
            tbody { @for panel in Panel::ALL { tr {
                th scope="row" { (panel.name()) }
                td { (Bill::new::<f32>(columns, panel, shot.depth)) }
                td { (Bill::new::<Fixed>(columns, panel, shot.depth)) }
            } } }
        }
    }
}

fn decibels(psnr: f64) -> String {
    format!("{psnr:.1} dB")
}

/// Puts content on a page; `up` leads to the folder of the entrance.
fn page(title: &str, up: &str, content: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                link rel="stylesheet" href={ (up) "style.css" };
            }
            body { main { h1 { (title) } (content) } }
        }
    };
    page.into_string()
}
