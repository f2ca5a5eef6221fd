//! The images of scene files: what a PNG file keeps, and what is told of one that cannot be taken.

use embedded_graphics::image::{GetPixel, ImageRaw};
use embedded_graphics::pixelcolor::raw::BigEndian;
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888};
use embedded_graphics::prelude::*;
use host_sim::scene_file::png_file::{self, MAX_TEXELS, Unreadable};
use host_sim::scene_file::{Complaint, Reason, SceneFile};
use image::{ColorType, DynamicImage, ExtendedColorType, ImageFormat};
use scanray::{Bitmap, Material, Texels};
use std::path::Path;
use tempfile::TempDir;

const BEFORE: &str = "Scene(
    camera: (eye: (0, 0, 5), center: (0, 0, 0), projection: Perspective(fovy: 40)),
    materials: {
";

/// Reads a scene in a folder whose materials show images: each has a line from the fourth on.
fn read(folder: &Path, images: &[&str]) -> Result<Vec<Material<f64>>, Box<Complaint>> {
    let material = |(index, image): (usize, &&str)| {
        format!("        \"{index}\": (texture: Image(file: \"{image}\")),\n")
    };
    let materials: String = images.iter().enumerate().map(material).collect();
    let text = format!("{BEFORE}{materials}    }},\n)\n");
    let file = SceneFile::parse(&folder.join("scene.ron"), text.into_bytes())?;
    Ok(file.description().materials.iter().map(|(_, material)| material.in_number()).collect())
}

/// Reads a scene that shows one image.
fn bitmap(folder: &Path, image: &str) -> Bitmap {
    let materials = read(folder, &[image]).unwrap_or_else(|complaint| panic!("{complaint}"));
    materials[0].texture.image().expect("it is an image").bitmap
}

/// Demands that every pixel of raw data comes back from a file, as texels and in its own colour.
fn assert_kept<C>(bytes: Vec<u8>, columns: u32)
where
    C: PixelColor + From<C::Raw> + From<Rgb888> + Into<Rgb888> + std::fmt::Debug + Sync + 'static,
    for<'a> ImageRaw<'a, C, BigEndian>: GetPixel<Color = C> + OriginDimensions + Sync,
{
    let raw: &'static ImageRaw<'static, C, BigEndian> =
        Box::leak(Box::new(ImageRaw::new(Vec::leak(bytes), columns)));
    let folder = tempfile::tempdir().unwrap();
    png_file::write(&folder.path().join("colors.png"), &Bitmap::new(raw)).unwrap();
    let back = bitmap(folder.path(), "colors.png");
    let [columns, rows] = Texels::size(raw);
    assert_eq!(back.size(), [columns, rows]);
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let [r, g, b] = back.texel([column, row]);
        assert_eq!([r, g, b], raw.texel(column, row), "{column}, {row}");
        let color = raw.pixel(Point::new(column as i32, row as i32));
        assert_eq!(Some(C::from(Rgb888::new(r, g, b))), color, "{column}, {row}");
    }
}

#[test]
fn every_color_of_a_panels_format_comes_back_from_a_file() {
    let two_bytes = || (0..=u16::MAX).flat_map(u16::to_be_bytes).collect::<Vec<u8>>();
    let every_byte = || (0..=u8::MAX).collect::<Vec<u8>>();
    assert_kept::<Rgb565>(two_bytes(), 256);
    assert_kept::<Rgb555>((0..0x8000_u16).flat_map(u16::to_be_bytes).collect(), 256);
    assert_kept::<Rgb666>((0..0x4_0000_u32).flat_map(|c| c.to_be_bytes().into_iter().skip(1)).collect(), 512);
    assert_kept::<Rgb888>((0..=u8::MAX).flat_map(|c| [c, 255 - c, c / 2]).collect(), 16);
    assert_kept::<Gray8>(every_byte(), 16);
    assert_kept::<Gray4>(every_byte(), 32);
    assert_kept::<Gray2>(every_byte(), 64);
    assert_kept::<BinaryColor>(every_byte(), 64);
}

#[test]
fn grey_images_are_grey_files_and_others_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let kind = |name: &str, bitmap: Bitmap| {
        let path = folder.path().join(name);
        png_file::write(&path, &bitmap).unwrap();
        image::open(path).unwrap().color()
    };
    static GREY: ImageRaw<Rgb888> = ImageRaw::new(&[7, 7, 7, 200, 200, 200], 2);
    static COLORED: ImageRaw<Rgb888> = ImageRaw::new(&[7, 7, 7, 200, 200, 201], 2);
    assert_eq!(kind("grey.png", Bitmap::new(&GREY)), ColorType::L8);
    assert_eq!(kind("colored.png", Bitmap::new(&COLORED)), ColorType::Rgb8);
}

/// Is three texels of a palette of red, blue and grey: the second, the first, the third.
const PALETTE: &[u8] =
    b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x03\x00\x00\x00\x01\x02\x03\x00\x00\x00f\
    \x8e\xfc'\x00\x00\x00\x09PLTE\xff\x00\x00\x00\x80\xff\x09\x09\x09\x02\x00k\x8a\x00\x00\x00\x0aID\
    ATx\x9cc\xf0\x00\x00\x00J\x00I\xa1\xe9\xc7\x97\x00\x00\x00\x00IEND\xaeB`\x82";

/// Is three texels of one bit: black, white, black.
const BITS: &[u8] =
    b"\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x03\x00\x00\x00\x01\x01\x00\x00\x00\x003\
    \x9b)\x19\x00\x00\x00\x0aIDATx\x9ccp\x00\x00\x00B\x00A)7\xf4\xef\x00\x00\x00\x00IEND\xaeB`\x82";

#[test]
fn levels_of_few_bits_and_colors_of_a_palette_are_spread_over_8_bits() {
    let folder = tempfile::tempdir().unwrap();
    let texels = |bytes: &[u8]| {
        std::fs::write(folder.path().join("few.png"), bytes).unwrap();
        let few = bitmap(folder.path(), "few.png");
        assert_eq!(few.size(), [3, 1]);
        [0, 1, 2].map(|column| few.texel([column, 0]))
    };
    assert_eq!(texels(PALETTE), [[0, 128, 255], [255, 0, 0], [9; 3]]);
    assert_eq!(texels(BITS), [[0; 3], [255; 3], [0; 3]]);
}

#[test]
fn a_file_named_twice_is_one_image_and_another_of_the_same_texels_is_not() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.png", "b.png"] {
        DynamicImage::new_rgb8(2, 3).save(folder.path().join(name)).unwrap();
    }
    let absolute = folder.path().join("a.png");
    let materials = read(folder.path(), &["a.png", "b.png", "a.png", absolute.to_str().unwrap()]).unwrap();
    let [a, b, again, whole] =
        [0, 1, 2, 3].map(|index: usize| materials[index].texture.image().unwrap().bitmap);
    assert!(a == again && a != b);
    assert_eq!((a.size(), whole.size()), ([2, 3], [2, 3]));
}

/// Demands what is told of an image, and that its name is what is underlined.
fn assert_told(folder: &TempDir, image: &str, why: &Unreadable, says: &str) {
    let complaint = read(folder.path(), &[image]).unwrap_err();
    let path = folder.path().join(image);
    assert_eq!(complaint.mistake.reason, Reason::Image { path: path.clone(), why: why.clone() });
    let told = complaint.to_string();
    let lines: Vec<&str> = told.lines().collect();
    assert!(lines[0].starts_with(&format!("cannot read the image {}: {says}", path.display())), "{told}");
    assert!(lines[1].contains("scene.ron:4:37"), "{told}");
    let carets = lines[4].find('^').unwrap_or_else(|| panic!("nothing is underlined: {told}"));
    assert!(lines[3][carets..].starts_with(&format!("{image}\"")), "{told}");
    assert_eq!(lines[4].matches('^').count(), image.chars().count(), "{told}");
}

#[test]
fn what_is_wrong_with_an_image_is_told_where_it_is_named() {
    let folder = tempfile::tempdir().unwrap();
    assert_told(&folder, "no/where.png", &Unreadable::Missing, "there is no such file");
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    assert_told(&folder, "folder", &Unreadable::NotAFile, "it is no file");
    let kinds = [
        (DynamicImage::new_rgba8(2, 2), ColorType::Rgba8),
        (DynamicImage::new_luma_a8(2, 2), ColorType::La8),
        (DynamicImage::new_rgb16(2, 2), ColorType::Rgb16),
        (DynamicImage::new_luma16(2, 2), ColorType::L16),
    ];
    for (image, kind) in kinds {
        image.save(folder.path().join("kind.png")).unwrap();
        assert_told(&folder, "kind.png", &Unreadable::Pixels(kind), &format!("its pixels are {kind:?}"));
    }
}

#[test]
fn what_is_no_whole_png_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("odd.png");
    DynamicImage::new_rgb8(40, 40).save(&path).unwrap();
    let whole = std::fs::read(&path).unwrap();
    let changed = |at: usize| [&whole[..at], &[!whole[at]], &whole[at + 1..]].concat();
    // A text, nothing, pieces, and files whose signature, header and pixels have another byte.
    let broken = [
        b"a text".to_vec(),
        vec![],
        whole[..20].to_vec(),
        whole[..whole.len() / 2].to_vec(),
        changed(0),
        changed(20),
        changed(whole.len() / 2),
    ];
    for bytes in broken {
        std::fs::write(&path, &bytes).unwrap();
        let reason = read(folder.path(), &["odd.png"]).unwrap_err().mistake.reason;
        assert!(matches!(reason, Reason::Image { why: Unreadable::Broken(_), .. }), "{reason} in {bytes:?}");
    }
}

#[test]
fn an_image_that_is_too_large_is_refused_by_its_header() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.png");
    for [columns, rows] in [[2049, 1], [1, 2049]] {
        image::save_buffer_with_format(
            &path,
            &[0; 2049],
            columns,
            rows,
            ExtendedColorType::L8,
            ImageFormat::Png,
        )
        .unwrap();
        assert_told(&folder, "large.png", &Unreadable::TooLarge, "it is more than 2048 texels wide or high");
        // Signature, header and the beginning of the pixels, and no more.
        let whole = std::fs::read(&path).unwrap();
        std::fs::write(&path, &whole[..50]).unwrap();
        assert_told(&folder, "large.png", &Unreadable::TooLarge, "it is more than 2048 texels wide or high");
    }
}

#[test]
fn the_images_of_a_scene_have_a_bound_together() {
    let folder = tempfile::tempdir().unwrap();
    let side = Bitmap::LARGEST;
    DynamicImage::new_luma8(side, side).save(folder.path().join("full.png")).unwrap();
    DynamicImage::new_luma8(1, 1).save(folder.path().join("one.png")).unwrap();
    let count = (MAX_TEXELS / (side * side)) as usize;
    // The same file by another name each time, which is another image.
    let names: Vec<String> = (0..count).map(|times| "./".repeat(times) + "full.png").collect();
    let mut names: Vec<&str> = names.iter().map(String::as_str).collect();
    names.push("full.png");
    assert_eq!(read(folder.path(), &names).map(|materials| materials.len()).ok(), Some(count + 1));
    names.push("one.png");
    let complaint = read(folder.path(), &names).unwrap_err();
    assert!(
        matches!(complaint.mistake.reason, Reason::Image { why: Unreadable::TooMany, .. }),
        "{complaint}"
    );
    assert!(complaint.to_string().contains(&format!("scene.ron:{}:", 4 + count + 1)), "{complaint}");
}
