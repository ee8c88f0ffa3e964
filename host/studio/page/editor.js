// The text of the scene: a plain text field over a painted copy of itself, with line numbers and marks
// where the program found mistakes.
import { byId, element } from './elements.js';
import { blockWords, numberWords, tokensOf } from './scene_tokens.js';

const most_painted = 200_000;  // characters: beyond, the text is shown without colours

function paintedAs(token, next) {
  if (token.kind === 'comment' || token.kind === 'number' || token.kind === 'string') return token.kind;
  if (token.kind !== 'word') return '';
  if (blockWords.has(token.text) && next !== ':') return 'block';
  if (token.text === 'newmap') return 'newmap';
  if (numberWords.has(token.text)) return 'number';
  return next === ':' ? 'directive' : '';
}

export class Editor {
  /// `changed(text)` is called when somebody types.
  constructor(changed) {
    this.field = byId('text');
    this.paint = byId('paint');
    this.gutter = byId('gutter');
    this.marked = new Map();  // line -> message
    this.field.addEventListener('input', () => { this.draw(); changed(this.field.value); });
    this.field.addEventListener('scroll', () => this.follow());
    this.field.addEventListener('keydown', event => this.key(event));
  }

  set(text) {
    if (this.field.value === text) return;
    const { selectionStart, selectionEnd, scrollTop } = this.field;
    this.field.value = text;
    this.field.setSelectionRange(selectionStart, selectionEnd);
    this.field.scrollTop = scrollTop;
    this.draw();
  }

  mark(mistakes) {
    this.marked = new Map(mistakes.map(m => [m.line, m.message]));
    this.drawGutter();
  }

  goTo(line, column = 1) {
    const lines = this.field.value.split('\n');
    const at = lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + column - 1;
    this.field.focus();
    this.field.setSelectionRange(at, at);
    const height = this.field.scrollHeight / Math.max(1, lines.length);
    this.field.scrollTop = Math.max(0, (line - 4) * height);
  }

  /// Two spaces for a tabulator; Escape lets the focus go on.
  key(event) {
    if (event.key === 'Escape') this.leaving = true;
    else if (event.key === 'Tab' && !this.leaving && !event.shiftKey && !event.ctrlKey) {
      event.preventDefault();
      this.field.setRangeText('    ', this.field.selectionStart, this.field.selectionEnd, 'end');
      this.field.dispatchEvent(new Event('input'));
    } else this.leaving = false;
  }

  draw() {
    const text = this.field.value;
    if (text.length > most_painted) this.paint.textContent = text;
    else {
      const tokens = tokensOf(text);
      const solid = tokens.map(t => t.kind !== 'blank' && t.kind !== 'comment');
      this.paint.replaceChildren(...tokens.map((token, i) => {
        let j = i + 1;
        while (j < tokens.length && !solid[j]) ++j;
        const kind = paintedAs(token, tokens[j]?.text);
        return kind ? element('span', { class: `t-${kind}` }, token.text) : token.text;
      }), '\n');
    }
    this.drawGutter();
    this.follow();
  }

  drawGutter() {
    const count = this.field.value.split('\n').length;
    const lines = [];
    for (let line = 1; line <= count; ++line) {
      const message = this.marked.get(line);
      lines.push(message ? element('span', { class: 'bad', title: message }, `${line}\n`) : `${line}\n`);
    }
    this.gutter.replaceChildren(...lines);
  }

  follow() {
    this.paint.style.transform = `translate(${-this.field.scrollLeft}px, ${-this.field.scrollTop}px)`;
    this.gutter.style.transform = `translateY(${-this.field.scrollTop}px)`;
  }
}
