use super::dither::{Mask, SIDE};

/// Is blue noise for [`Dither::Mask`](super::Dither::Mask): thresholds in which neither a pattern nor a
/// cluster shows, for 512 bytes of flash.
///
/// The pixels of each grey lie as evenly as voids and clusters make them (R. Ulichney, "The
/// void-and-cluster method for dither array generation", 1993), so that what rounding adds is fine detail,
/// where the eye is weakest: waves longer than four pixels have 1/25 to 1/8 of the energy that white noise
/// has there, in greys from 1/8 to 13/16, and less than half of it from 1/16 to 15/16.
pub static BLUE_NOISE: Mask = thresholds();

/// Lists the order in which the pixels light up.
const RANKS: [[u8; SIDE]; SIDE] = [
    [178, 237, 139, 7, 229, 51, 124, 226, 79, 16, 254, 30, 235, 3, 207, 67],
    [110, 204, 39, 193, 82, 150, 11, 197, 111, 156, 130, 70, 153, 88, 227, 159],
    [25, 93, 59, 171, 108, 245, 179, 61, 241, 43, 191, 210, 106, 32, 123, 54],
    [142, 213, 255, 129, 20, 42, 134, 100, 21, 168, 87, 10, 230, 173, 195, 239],
    [187, 2, 152, 76, 221, 199, 78, 232, 147, 215, 119, 48, 137, 66, 18, 81],
    [49, 118, 34, 183, 55, 157, 6, 182, 33, 71, 238, 185, 96, 248, 162, 103],
    [242, 167, 216, 109, 244, 94, 122, 208, 102, 133, 0, 154, 201, 37, 126, 209],
    [140, 69, 89, 9, 143, 28, 224, 47, 160, 250, 58, 84, 24, 223, 62, 12],
    [189, 29, 236, 202, 169, 64, 177, 80, 17, 188, 218, 170, 107, 144, 175, 98],
    [220, 127, 151, 52, 114, 252, 135, 233, 120, 97, 35, 128, 234, 74, 253, 41],
    [165, 65, 23, 192, 85, 13, 38, 194, 56, 149, 206, 14, 50, 198, 4, 115],
    [83, 243, 105, 228, 158, 212, 101, 166, 22, 222, 72, 180, 155, 95, 138, 214],
    [53, 176, 1, 131, 44, 73, 231, 125, 86, 249, 132, 112, 240, 60, 190, 27],
    [225, 148, 90, 205, 184, 145, 8, 200, 46, 161, 5, 40, 217, 19, 164, 121],
    [196, 36, 251, 63, 26, 113, 246, 68, 181, 104, 203, 91, 146, 75, 247, 99],
    [15, 77, 116, 163, 211, 92, 172, 31, 141, 219, 57, 174, 117, 186, 45, 136],
];

const fn thresholds() -> Mask {
    let mut mask = [[0; SIDE]; SIDE];
    let mut i = 0;
    while i < SIDE * SIDE {
        // The middle of the step, as in the other squares.
        mask[i / SIDE][i % SIDE] = (2 * RANKS[i / SIDE][i % SIDE] as u16 + 1) << 7;
        i += 1;
    }
    mask
}
