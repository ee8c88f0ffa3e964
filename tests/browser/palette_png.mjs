// A screenshot with a palette of 256 colours: a third of its bytes, and nobody sees the difference.
// Chromium's are of eight bits a channel, red, green and blue or these and alpha, and not interlaced.
import { deflateSync, inflateSync } from 'node:zlib';

const most = 256, signature = 8;
const key = (r, g, b) => (r << 16) | (g << 8) | b;

function chunksOf(png) {
  const chunks = [];
  for (let at = signature; at < png.length;) {
    const length = png.readUInt32BE(at);
    chunks.push({ type: png.toString('latin1', at + 4, at + 8), data: png.subarray(at + 8, at + 8 + length) });
    at += length + 12;
  }
  return chunks;
}

const paeth = (a, b, c) => {
  const [x, y, z] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
  return x <= y && x <= z ? a : y <= z ? b : c;
};

/// { columns, rows, colors: a number each }
function decoded(png) {
  const chunks = chunksOf(png), head = chunks[0].data;
  const columns = head.readUInt32BE(0), rows = head.readUInt32BE(4), size = { 2: 3, 6: 4 }[head[9]];
  if (head[8] !== 8 || !size || head[12] !== 0) throw new Error('this is no screenshot of Chromium');
  const raw = inflateSync(Buffer.concat(chunks.filter(c => c.type === 'IDAT').map(c => c.data)));
  const width = columns * size, colors = new Uint32Array(columns * rows);
  let above = new Uint8Array(width);
  for (let y = 0, at = 0; y < rows; ++y, at += width) {
    const filter = raw[at++], row = raw.subarray(at, at + width);
    for (let i = 0; i < width; ++i) {
      const left = i < size ? 0 : row[i - size], corner = i < size ? 0 : above[i - size];
      row[i] += [0, left, above[i], (left + above[i]) >> 1, paeth(left, above[i], corner)][filter];
    }
    for (let x = 0; x < columns; ++x) colors[y * columns + x] = key(row[size * x], row[size * x + 1], row[size * x + 2]);
    above = row;
  }
  return { columns, rows, colors };
}

const channels = color => [color >> 16, (color >> 8) & 255, color & 255];

/// Median cut: the box that spreads most, by how many pixels it has, is cut where half of these are.
function paletteOf(counts) {
  const boxOf = entries => {
    const spread = [0, 1, 2].map(c => { const v = entries.map(e => e.rgb[c]); return v.reduce((a, b) => Math.max(a, b)) - v.reduce((a, b) => Math.min(a, b)); });
    const widest = Math.max(...spread);
    return { entries, axis: spread.indexOf(widest), weight: widest * Math.sqrt(entries.reduce((sum, e) => sum + e.count, 0)) };
  };
  const boxes = [boxOf([...counts].map(([color, count]) => ({ rgb: channels(color), color, count })))];
  while (boxes.length < most) {
    const at = boxes.reduce((best, box, i) => (box.weight > boxes[best].weight ? i : best), 0);
    const { entries, axis, weight } = boxes[at];
    if (weight === 0) break;
    entries.sort((a, b) => a.rgb[axis] - b.rgb[axis]);
    let half = entries.reduce((sum, e) => sum + e.count, 0) / 2, cut = 0;
    while (cut < entries.length - 1 && half > 0) half -= entries[cut++].count;
    boxes.splice(at, 1, boxOf(entries.slice(0, cut)), boxOf(entries.slice(cut)));
  }
  return boxes.map(({ entries }) => {
    const all = entries.reduce((sum, e) => sum + e.count, 0);
    return { color: [0, 1, 2].map(c => Math.round(entries.reduce((sum, e) => sum + e.count * e.rgb[c], 0) / all)), entries };
  });
}

/// Of PNG's chunks; node has it since version 20.
function crc32(bytes) {
  let rest = ~0;
  for (const byte of bytes) {
    rest ^= byte;
    for (let bit = 0; bit < 8; ++bit) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  }
  return ~rest >>> 0;
}

function chunk(type, data) {
  const bytes = Buffer.alloc(12 + data.length);
  bytes.writeUInt32BE(data.length, 0);
  bytes.write(type, 4, 'latin1');
  data.copy(bytes, 8);
  bytes.writeUInt32BE(crc32(bytes.subarray(4, 8 + data.length)), 8 + data.length);
  return bytes;
}

export function withPalette(png) {
  const { columns, rows, colors } = decoded(png);
  const counts = new Map();
  for (const color of colors) counts.set(color, (counts.get(color) ?? 0) + 1);
  const palette = paletteOf(counts), indexOf = new Map();
  palette.forEach(({ entries }, i) => { for (const { color } of entries) indexOf.set(color, i); });
  const lines = Buffer.alloc(rows * (columns + 1));  // each begins with 0: no filter
  for (let y = 0; y < rows; ++y)
    for (let x = 0; x < columns; ++x) lines[y * (columns + 1) + 1 + x] = indexOf.get(colors[y * columns + x]);
  const head = Buffer.from(chunksOf(png)[0].data);
  head[9] = 3;
  return Buffer.concat([png.subarray(0, signature), chunk('IHDR', head), chunk('PLTE', Buffer.from(palette.flatMap(p => p.color))),
    chunk('IDAT', deflateSync(lines, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}
