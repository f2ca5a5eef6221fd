//! What the playground promises, in a browser.

use host_sim::scenes;
use host_sim::serve::{Server, Site, build};
use host_sim::shot::{Number, Shot};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

/// Answers the address of a playground that is served as long as the tests run.
fn address() -> &'static str {
    static ADDRESS: OnceLock<String> = OnceLock::new();
    ADDRESS.get_or_init(|| {
        let core = build::wasm().unwrap_or_else(|fault| panic!("{fault}"));
        let site = Site::gather(&core).unwrap_or_else(|fault| panic!("{fault}"));
        let server = Server::new(0).unwrap_or_else(|fault| panic!("{fault}"));
        let address = server.address();
        std::thread::spawn(move || server.run(&site));
        address
    })
}

/// Lets a script sit before the playground and answers what it prints.
fn sit(script: &str) -> String {
    let output = Command::new("node")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("../playground/browser").join(script))
        .arg(address())
        .output()
        .expect("node runs");
    let [said, complaint] =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(output.status.success(), "{script}:\n{said}{complaint}");
    said
}

/// Answers the FNV-1a checksum of a picture's bytes.
fn checksum(pixels: &[[u8; 3]]) -> u32 {
    let add = |sum: u32, byte: &u8| (sum ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
    pixels.as_flattened().iter().fold(0x811c_9dc5, add)
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn every_scene_of_the_gallery_in_the_page_is_the_hosts_to_the_bit() {
    let said = sit("gallery.mjs");
    let words = said.lines().map(|line| line.split(' ').collect::<Vec<_>>());
    let page: BTreeMap<_, _> = words.map(|words| ((words[0], words[1]), words[2].to_owned())).collect();
    for scene in scenes::all() {
        for number in [Number::F32, Number::Fixed] {
            let shot = Shot { number, size: [48, 36], ..Shot::new(scene) };
            let host = checksum(&shot.take(|_| ()).unwrap().picture.pixels).to_string();
            let name = (scene.name(), number.name());
            assert_eq!(page.get(&name), Some(&host), "{name:?}");
        }
    }
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn whoever_walks_around_and_comes_back_sees_the_same_bits() {
    sit("walk.mjs");
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_wrong_scene_is_told_with_its_line_and_the_picture_stays() {
    sit("faults.mjs");
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_narrow_screen_shows_all_and_every_control_has_a_name() {
    sit("narrow.mjs");
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_small_panel_is_drawn_thirty_times_a_second() {
    let said = sit("speed.mjs");
    println!("number, pictures a second, ms of the fastest:\n{said}");
    let fastest = said.lines().filter_map(|line| line.split(' ').nth(2)?.parse::<f64>().ok());
    // That of the fastest: how many others the computer lets through at the same time is not the page's matter.
    assert!(fastest.clone().count() == 2 && fastest.clone().all(|time| time < 1000.0 / 30.0), "{said}");
}
