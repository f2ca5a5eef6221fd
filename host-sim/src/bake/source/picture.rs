//! Images in source: levels of 8 bits, one a texel where all are grey, and the few lines that read them.

use super::layout::Layout;
use crate::bake::Bill;
use scanray::Bitmap;

/// Names how texels are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// One level.
    Gray,
    /// Red, green and blue.
    Color,
}

/// Lists the texels of an image, row by row from the top.
fn texels(bitmap: &Bitmap) -> impl Iterator<Item = [u8; 3]> + '_ {
    let [columns, rows] = bitmap.size();
    (0..rows).flat_map(move |row| (0..columns).map(move |column| bitmap.texel([column, row])))
}

impl Kind {
    /// Answers the smallest that loses nothing.
    pub fn of(bitmap: &Bitmap) -> Self {
        let is_gray = texels(bitmap).all(|[red, green, blue]| red == green && green == blue);
        if is_gray { Self::Gray } else { Self::Color }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Gray => "Levels<1>",
            Self::Color => "Levels<3>",
        }
    }

    fn bytes(self, texel: [u8; 3]) -> Vec<u8> {
        match self {
            Self::Gray => vec![texel[1]],
            Self::Color => texel.to_vec(),
        }
    }
}

/// Writes an image.
pub(super) fn write(place: usize, bitmap: &Bitmap, kind: Kind, layout: &mut Layout, bill: &mut Bill) {
    let [columns, rows] = bitmap.size();
    let bytes: Vec<u8> = texels(bitmap).flat_map(|texel| kind.bytes(texel)).collect();
    bill.images += bytes.len();
    let item = format!(
        "static IMAGE_{place}: {} = Levels {{ size: [{columns}, {rows}], bytes: &TEXELS_{place} }}",
        kind.name()
    );
    layout.item("", &item);
    layout.rows(&format!("TEXELS_{place}"), "u8", bytes.iter().map(u8::to_string));
}

/// Writes what reads the images.
pub(super) fn write_reader(layout: &mut Layout) {
    layout.text.push_str(READER);
}

const READER: &str = "
/// Is an image of one level a texel for grey, or of three for red, green and blue, row by row from the top.
struct Levels<const COUNT: usize> {
    size: [u32; 2],
    bytes: &'static [u8],
}

impl<const COUNT: usize> Texels for Levels<COUNT> {
    fn size(&self) -> [u32; 2] {
        self.size
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let first = (row * self.size[0] + column) as usize * COUNT;
        match self.bytes.get(first..first + COUNT) {
            Some([red, green, blue]) => [*red, *green, *blue],
            Some([gray]) => [*gray; 3],
            _ => [0; 3],
        }
    }
}
";
