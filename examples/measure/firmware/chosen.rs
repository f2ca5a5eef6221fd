//! What was chosen when the firmware was built: scene, size and number.

use scanray::gallery::View;

#[cfg(not(target_abi = "eabihf"))]
use scanray::gallery::fixed as number;
#[cfg(target_abi = "eabihf")]
use scanray::gallery::float as number;

/// Is the number that suits the chip.
#[cfg(target_abi = "eabihf")]
pub type Number = f32;
/// Is the number that suits the chip.
#[cfg(not(target_abi = "eabihf"))]
pub type Number = scanray::Fixed;

/// Is the scene's name.
const SCENE: &str = or(option_env!("SCANRAY_SCENE"), "three-spheres");
/// Is the picture's size, such as `320x240`.
const SIZE: &str = or(option_env!("SCANRAY_SIZE"), "320x240");

/// Is the scene with its camera and settings.
pub static VIEW: View<Number> = find(&number::VIEWS, SCENE);
/// Counts the bounces that the scene's rays may take.
pub const DEPTH: usize = find(&number::VIEWS, SCENE).settings.depth as usize;
/// Counts the picture's columns.
pub const WIDTH: u32 = sides(SIZE)[0];
/// Counts the picture's rows.
pub const HEIGHT: u32 = sides(SIZE)[1];

const fn or(chosen: Option<&'static str>, usual: &'static str) -> &'static str {
    match chosen {
        Some(chosen) => chosen,
        None => usual,
    }
}

const fn find(views: &'static [View<Number>], name: &str) -> View<Number> {
    let mut i = 0;
    while !same(views[i].name.as_bytes(), name.as_bytes()) {
        i += 1;
        assert!(i < views.len(), "the gallery has no such scene");
    }
    views[i]
}

const fn same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

/// Answers the two numbers of a size.
const fn sides(size: &str) -> [u32; 2] {
    let (bytes, mut sides, mut side, mut i) = (size.as_bytes(), [0; 2], 0, 0);
    while i < bytes.len() {
        match bytes[i] {
            b'x' => side += 1,
            digit => sides[side] = 10 * sides[side] + (digit - b'0') as u32,
        }
        i += 1;
    }
    sides
}
