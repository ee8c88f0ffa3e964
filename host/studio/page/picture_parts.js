// A picture while it comes: blocks of pixels as the program has rendered them, and at the end what is
// known of it (host/studio/picture_parts.hpp says how they are sent).

const start = 8, block = 20;  // bytes before the blocks, and before the pixels of each

export class PictureParts {
  constructor() {
    this.rest = new Uint8Array(0);  // that is not understood yet
    this.pixels = null;             // ImageData
    this.cycles = null;             // of the machine, Uint32Array
    this.fresh = [];                // blocks that nobody has shown: [left, top, columns, rows]
  }

  /// Takes what has come.
  add(piece) {
    let bytes = piece;
    if (this.rest.length > 0) {
      bytes = new Uint8Array(this.rest.length + piece.length);
      bytes.set(this.rest);
      bytes.set(piece, this.rest.length);
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    let at = this.pixels || bytes.length < start ? 0 : this.begin(view);
    for (let size; this.pixels && (size = this.sizeOfBlock(view, at)) > 0; at += size) this.take(bytes, view, at);
    this.rest = bytes.subarray(at);
  }

  begin(view) {
    const [columns, rows, machine] = numbers(view, 0, 3);
    this.pixels = new ImageData(columns, rows);
    this.colors = new Uint32Array(this.pixels.data.buffer);
    if (machine) this.cycles = new Uint32Array(columns * rows);
    return start;
  }

  /// 0 if it is not all there, or if there is none but the end.
  sizeOfBlock(view, at) {
    if (view.byteLength - at < block) return 0;
    const [columns, rows] = numbers(view, at + 4, 2), [inner, innerRows] = numbers(view, at + 12, 2);
    const size = block + 4 * (inner * innerRows + (this.cycles ? columns * rows : 0));
    return columns > 0 && view.byteLength - at >= size ? size : 0;
  }

  take(bytes, view, at) {
    const [left, top, columns, rows, x, y, inner, innerRows] = numbers(view, at, 8);
    const { width } = this.pixels, color = view.getUint32(at + 16, true);
    if (this.ground === undefined) this.colors.fill(this.ground = color);  // most of most pictures
    if (color !== this.ground)
      for (let row = top; row < top + rows; ++row) this.colors.fill(color, row * width + left, row * width + left + columns);
    let from = at + block;
    for (let row = y; row < y + innerRows; ++row, from += 4 * inner)
      this.pixels.data.set(bytes.subarray(from, from + 4 * inner), 4 * (row * width + x));
    for (let row = top; this.cycles && row < top + rows; ++row)
      for (let i = row * width + left, end = i + columns; i < end; ++i, from += 4) this.cycles[i] = view.getUint32(from, true);
    this.fresh.push([left, top, columns, rows]);
  }

  /// What is said at the end.
  last() { return JSON.parse(new TextDecoder().decode(this.rest.subarray(block))); }
}

const numbers = (view, at, count) => Array.from({ length: count }, (_, i) => view.getUint16(at + 2 * i, true));
