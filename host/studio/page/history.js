// Every text that the scene has had, and back to each. Changes of one kind that follow one another
// soon, as letters that are typed or a handle that is dragged, are one.

const together = 900;  // milliseconds
const most = 500;
export const typed = 'typed';      // the kind of changes that were made in the text itself
export const dragged = 'dragged';  // the kind of changes that are one until seal()

export class History {
  constructor(text) {
    this.texts = [text];
    this.kinds = [''];  // of the change that made each
    this.at = 0;
    this.kind = '';
    this.time = 0;
  }
  get text() { return this.texts[this.at]; }
  /// The kinds of what undo and redo would go over.
  get undone() { return this.kinds[this.at]; }
  get redone() { return this.kinds[this.at + 1]; }
  get canUndo() { return this.at > 0; }
  get canRedo() { return this.at + 1 < this.texts.length; }

  put(text, kind = '') {
    if (text === this.text) return;
    const now = performance.now();
    const soon = kind === dragged || now - this.time < together;
    const joins = kind !== '' && kind === this.kind && soon && this.at > 0;
    this.texts.length = this.kinds.length = this.at + 1;
    if (joins) this.texts[this.at] = text;
    else {
      this.texts.push(text);
      this.kinds.push(kind);
    }
    if (this.texts.length > most) {
      this.texts.shift();
      this.kinds.shift();
    }
    this.at = this.texts.length - 1;
    this.kind = kind;
    this.time = now;
  }
  /// What comes next is a change of its own.
  seal() { this.kind = ''; }
  undo() { if (this.canUndo) --this.at; this.seal(); return this.text; }
  redo() { if (this.canRedo) ++this.at; this.seal(); return this.text; }
}
