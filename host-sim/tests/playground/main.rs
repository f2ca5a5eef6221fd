//! What the playground promises, in a browser.

use host_sim::explain::Explanation;
use host_sim::files::Disk;
use host_sim::model::{Options, entry};
use host_sim::serve::{Server, Site, build};
use host_sim::shot::{Approach, Number, Shot};
use host_sim::{obj, scenes};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, OnceLock, PoisonError};

/// Answers the address of a playground that is served as long as the tests run.
fn address() -> &'static str {
    static ADDRESS: OnceLock<String> = OnceLock::new();
    ADDRESS.get_or_init(|| {
        let core = build::wasm().unwrap_or_else(|fault| panic!("{fault}"));
        let site = Site::gather(&core).unwrap_or_else(|fault| panic!("{fault}"));
        let server = Server::new(0).unwrap_or_else(|fault| panic!("{fault}"));
        let address = server.address();
        std::thread::spawn(move || server.run(site));
        address
    })
}

/// Lets a script sit before the playground, with what it has to know, and answers what it prints.
///
/// One sits there at a time: five browsers at once are slower than one after the other.
fn sit(script: &str, about: &[&OsStr]) -> String {
    static SEAT: Mutex<()> = Mutex::new(());
    let _seat = SEAT.lock().unwrap_or_else(PoisonError::into_inner);
    let output = Command::new("node")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("../playground/browser").join(script))
        .arg(address())
        .args(about)
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
    let said = sit("gallery.mjs", &[]);
    let words = said.lines().map(|line| line.split(' ').collect::<Vec<_>>());
    let page: BTreeMap<_, _> = words.map(|words| ((words[0], words[1]), words[2])).collect();
    for scene in scenes::all() {
        let shot = Shot { size: [48, 36], ..Shot::new(scene) };
        let traced = Number::ALL.map(|number| (number.name(), Shot { number, ..shot }));
        let raster = ("raster", Shot { approach: Approach::Raster, ..shot });
        for (name, shot) in traced.into_iter().chain([raster]) {
            let hex = |pixels: &[[u8; 3]]| {
                pixels.as_flattened().iter().map(|level| format!("{level:02x}")).collect()
            };
            let host: String =
                shot.take(|_| ()).map_or("refused".to_owned(), |taken| hex(&taken.picture.pixels));
            assert!(page.get(&(scene.name(), name)) == Some(&host.as_str()), "{} {name}", scene.name());
        }
    }
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn files_of_ones_own_are_drawn_as_the_host_draws_them_and_a_missing_one_is_told_by_name() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let said = sit("files.mjs", &[folder.as_os_str()]);
    let drawn = |entry| {
        let shot = Shot { number: Number::Fixed, ..Shot::new(entry) };
        checksum(&shot.take(|_| ()).unwrap().picture.pixels)
    };
    let model = obj::plan(&Disk, &folder.join("teapot.obj"), Options::default()).unwrap();
    let host = [
        ("planets", drawn(scenes::read(&folder.join("planets.ron")).unwrap())),
        ("balls1", drawn(scenes::read(&folder.join("nff/balls1.nff")).unwrap())),
        ("teapot", drawn(entry(&model))),
    ];
    for (name, sum) in host {
        assert!(said.contains(&format!("{name} {sum}\n")), "{name} {sum}:\n{said}");
    }
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn the_rays_of_a_pixel_are_told_as_on_the_command_line() {
    let said = sit("explain.mjs", &[]);
    let shot = Shot { size: [240, 240], ..Shot::new(scenes::find("glass").unwrap()) };
    let host = Explanation::new(shot, &[Number::F32, Number::Fixed], [140, 140]).unwrap().to_string();
    assert!(said.starts_with(&host), "{said}\n{host}");
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn whoever_walks_around_and_comes_back_sees_the_same_bits() {
    sit("walk.mjs", &[]);
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_wrong_scene_is_told_with_its_line_and_the_picture_stays() {
    sit("faults.mjs", &[]);
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_narrow_screen_shows_all_and_every_control_has_a_name() {
    sit("narrow.mjs", &[]);
}

#[test]
#[ignore = "needs chromium, node and wasm32-unknown-unknown (run by .ci/run)"]
fn a_turning_camera_is_drawn_picture_after_picture() {
    let said = sit("speed.mjs", &[]);
    println!("number, pictures a second, ms of the fastest:\n{said}");
    // How many they are is up to what else the computer does: thirty and more where it is left alone.
    let figures = said.lines().map(|line| line.split(' ').skip(1).map(|word| word.parse::<f64>()).collect());
    let figures: Vec<Vec<_>> = figures.collect();
    let is_told =
        |figures: &Vec<_>| figures.len() == 2 && figures.iter().all(|x| matches!(x, Ok(x) if *x > 0.0));
    assert!(figures.len() == 2 && figures.iter().all(is_told), "{said}");
}
