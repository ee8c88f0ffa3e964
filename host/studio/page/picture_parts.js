// A picture while it comes: blocks of pixels as the program has rendered them, and at the end what is
// known of it (host/studio/picture_parts.hpp says how they are sent).

const start = 8, block = 16;  // bytes before the blocks, and before the bits of each
const room = 192 * 1024;      // bytes for what has come and is not understood yet

export class PictureParts {
  /// `spare`: ImageData that nobody needs any more; new memory takes the page's time.
  constructor(spare = null) {
    this.spare = spare;
    this.pixels = null;  // ImageData
    this.cycles = null;  // of the machine, Uint32Array
    this.fresh = [];     // blocks that nobody has shown: [left, top, columns, rows]
    this.filled = 0;     // bytes that are not understood yet
    this.complete = false;
    this.makeRoom(room);
  }

  makeRoom(size) {
    const bytes = new Uint8Array(Math.ceil(size / 4) * 4);
    if (this.filled > 0) bytes.set(this.bytes.subarray(0, this.filled));
    // Everything begins at a multiple of four bytes: what is left over is put to the beginning.
    Object.assign(this, { bytes, view: new DataView(bytes.buffer), words: new Uint32Array(bytes.buffer) });
  }

  /// Takes what has come.
  add(piece) {
    const end = this.filled + piece.length;
    if (end > this.bytes.length) this.makeRoom(2 * end);
    this.bytes.set(piece, this.filled);
    this.filled = end;
    let at = this.pixels || end < start ? 0 : this.begin();
    for (let size; this.pixels && (size = this.sizeOfBlock(at)) > 0; at += size) this.take(at);
    this.bytes.copyWithin(0, at, end);
    this.filled = end - at;
    this.complete = Boolean(this.pixels) && this.filled >= block && this.short(4) === 0 && this.filled >= block + this.words[3];
  }

  begin() {
    const columns = this.short(0), rows = this.short(2);
    const { spare } = this;
    this.pixels = spare?.width === columns && spare.height === rows ? spare : new ImageData(columns, rows);
    this.colors = new Uint32Array(this.pixels.data.buffer);
    if (this.short(4)) this.cycles = new Uint32Array(columns * rows);
    return start;
  }

  short(at) { return this.view.getUint16(at, true); }

  /// In bytes; 0 if it is not all there, or if there is none but the end.
  sizeOfBlock(at) {
    if (this.filled - at < block) return 0;
    const columns = this.short(at + 4), rows = this.short(at + 6);
    const others = this.words[at / 4 + 3];
    const size = block + 4 * (rows * Math.ceil(columns / 32) + others + (this.cycles ? columns * rows : 0));
    return columns > 0 && this.filled - at >= size ? size : 0;
  }

  take(at) {
    const left = this.short(at), top = this.short(at + 2), columns = this.short(at + 4), rows = this.short(at + 6);
    const { words, colors, cycles } = this, { width } = this.pixels;
    const color = words[at / 4 + 2];
    if (this.ground === undefined) colors.fill(this.ground = color);  // most of most pictures
    if (color !== this.ground)
      for (let row = top; row < top + rows; ++row) colors.fill(color, row * width + left, row * width + left + columns);
    let mask = (at + block) / 4, from = mask + rows * Math.ceil(columns / 32);
    for (let row = top; row < top + rows; ++row) {
      const begin = row * width + left;
      for (let i = begin; i < begin + columns; i += 32) {
        let bits = words[mask++] | 0;
        if (bits === -1) {
          for (let k = i; k < i + 32; ++k) colors[k] = words[from++];
        } else {
          for (; bits; bits &= bits - 1) colors[i + 31 - Math.clz32(bits & -bits)] = words[from++];
        }
      }
    }
    for (let row = top; cycles && row < top + rows; ++row)
      for (let i = row * width + left, end = i + columns; i < end; ++i, ++from) cycles[i] = words[from];
    this.fresh.push([left, top, columns, rows]);
  }

  /// What is said at the end.
  last() { return JSON.parse(new TextDecoder().decode(this.bytes.subarray(block, block + this.words[3]))); }
}
