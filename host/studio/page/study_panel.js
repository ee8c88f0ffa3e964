// A small study of the scene (docs/studies.md), run from the page: what it measured as tables, and its
// report as a file.
import { element, number } from './elements.js';
import { download } from './rendering.js';
import * as server from './server.js';

const look = 250;       // milliseconds between two looks at how far it is
const most_rows = 60;   // of a table
const size = { columns: 96, rows: 72 };

const kinds = {
  balance: ['Balance', 'Who waits for whom, for every way of sharing out the pixels, model and number of nodes'],
  error: ['Error', 'How far each setting is from the best picture, and what it costs'],
};

/// Of a table as studies write it: rows of texts; quotes may hold commas.
export const rowsOf = csv => csv.trim().split('\n').map(line =>
  [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(,|$)/g)].map(m => m[1].replace(/^"|"$/g, '').replaceAll('""', '"')).slice(0, line.endsWith(',') ? undefined : -1));

const shown = text => (text !== '' && Number.isFinite(Number(text)) ? number(Number(text), 5) : text);

export class StudyPanel {
  /// `scene()`: the question, or null.
  constructor(scene) {
    this.scene = scene;
    this.place = element('section', { id: 'studies', 'aria-label': 'Studies' });
    this.found = null;
    this.running = '';
    this.draw();
  }

  draw() {
    const button = kind => element('button', { class: 'small', title: kinds[kind][1], disabled: this.running !== '', id: `study-${kind}`, onclick: () => this.run(kind) }, kinds[kind][0]);
    this.place.replaceChildren(element('h2', {}, 'A small study'),
      element('p', { class: 'note' }, `Measures this scene at ${size.columns} × ${size.rows}, a minute or so.`),
      element('div', { class: 'row' }, button('balance'), button('error'),
        ...(this.running ? [element('progress', { max: 1, 'aria-label': 'How far the study is' }), element('button', { class: 'small', id: 'study-stop', onclick: () => server.stop('study') }, 'Stop')] : [])),
      ...(this.said ? [element('p', { class: `note ${this.bad ? 'refused' : ''}`, role: 'status' }, this.said)] : []),
      ...(this.found ? this.tables() : []));
  }

  tables() {
    const { report, tables, kind } = this.found;
    return [element('button', { class: 'small', id: 'study-report', onclick: () => download(new Blob([report], { type: 'text/html' }), `${kind}.html`) }, 'Save the whole report'),
      ...tables.map(table => {
        const [head, ...rows] = rowsOf(table.text);
        return element('details', { open: table === tables[0] }, element('summary', {}, `${table.name.replace(/\.csv$/, '')}, ${rows.length} ${rows.length === 1 ? 'row' : 'rows'}`),
          element('div', { class: 'scroll' }, element('table', {}, element('thead', {}, element('tr', {}, ...head.map(h => element('th', {}, h.replaceAll('_', ' '))))),
            element('tbody', {}, ...rows.slice(0, most_rows).map(row => element('tr', {}, ...row.map(cell => element('td', {}, shown(cell)))))))),
          rows.length > most_rows ? element('p', { class: 'note' }, `${rows.length - most_rows} more rows stand in the report.`) : null);
      })];
  }

  async run(kind) {
    const scene = this.scene();
    if (!scene) return;
    Object.assign(this, { running: kind, found: null, said: '', bad: false });
    this.draw();
    const watch = setInterval(async () => {
      const progress = await server.progress('study').catch(() => null);
      const bar = this.place.querySelector('progress');
      if (bar && progress?.share) bar.value = progress.share;
    }, look);
    try {
      const found = await server.study({ name: scene.name, text: scene.text, frame: scene.frame, kind, ...size });
      this.found = found && { ...found, kind };
      this.said = found ? '' : 'Given up.';
    } catch (error) {
      Object.assign(this, { said: error.message, bad: true });
    }
    clearInterval(watch);
    this.running = '';
    this.draw();
  }
}
