// Pictures as PNG files of 8-bit RGB.

import { crc32 as zlibCrc32, deflateSync } from 'node:zlib';

/** A PNG file of `width` x `height` pixels, `rgb` being three bytes a pixel. */
export function png(width, height, rgb) {
  const lines = Buffer.alloc(height * (1 + 3 * width));
  for (let y = 0; y < height; y++) {
    // Each line begins with its filter, and 0 is none.
    rgb.copy(lines, y * (1 + 3 * width) + 1, y * 3 * width, (y + 1) * 3 * width);
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header[8] = 8; // bits a channel
  header[9] = 2; // red, green, blue
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(lines)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

function chunk(name, data) {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
  const out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

// zlib's own `crc32` came with node 20.15.
const crc32 = zlibCrc32 ?? ((bytes) => {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
});

/** Red, green, blue bytes of big-endian RGB565 pixels, each channel widened by repeating its top bits. */
export function rgb565ToRgb(raw) {
  const rgb = Buffer.alloc((raw.length / 2) * 3);
  for (let i = 0; i < raw.length / 2; i++) {
    const pixel = raw.readUInt16BE(2 * i);
    const [r, g, b] = [pixel >> 11, (pixel >> 5) & 63, pixel & 31];
    rgb.set([(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2)], 3 * i);
  }
  return rgb;
}

/** Red, green, blue bytes of grey levels from 0 to 15. */
export function gray4ToRgb(raw) {
  return Buffer.from([...raw].flatMap((level) => [level * 17, level * 17, level * 17]));
}
