// What the program says of the text: whether it is right and where it is not, what its numbers are, and
// what is known of it without a picture.
import * as cameras from './camera.js';
import { byId, element } from './elements.js';
import { awaitFacts, showFacts } from './facts_panel.js';
import * as server from './server.js';

const shown_mistakes = 6;
const overtaken = 250;  // milliseconds that a check may take before a newer text is checked instead
const refusal = /^ifs "([^"]*)".* could not be shown to contract/;  // of host/compile
const quiet = 250;  // milliseconds without a change before the facts are asked for

export class Checking {
  constructor(studio) {
    this.studio = studio;
    this.runs = null;       // while the program is asked
    this.factsOld = true;
    this.growing = [];      // names of systems that, as the program last said, do not contract
  }

  /// One check at a time; the newest text is the last one that is checked.
  check() {
    this.wanted = true;
    this.halted = false;
    this.runs ??= this.run();
    return this.runs;
  }

  async run() {
    const { studio } = this;
    while (this.wanted) {
      this.wanted = false;
      const text = studio.text;
      try {
        const checked = await this.answerOf({ name: studio.name, text, frame: studio.frame, ...studio.live.size });
        if (checked) this.accept(text, checked);
      } catch (error) {
        if (text === studio.text) this.showMistakes(error);
      }
    }
    this.runs = null;
  }

  /// Null if it takes long and there is a newer text by then: the next question makes the program give
  /// this one up.
  async answerOf(question) {
    const asked = server.check(question);
    asked.catch(() => {});
    for (let quick = true; ; quick = false) {
      const pause = new Promise(done => { setTimeout(done, quick ? overtaken : 20, undefined); });
      const answer = await Promise.race([asked, pause]);
      if (answer !== undefined) return answer;
      if (this.wanted || this.halted) return null;
    }
  }

  /// The text is not checked, until it is another.
  stop() {
    this.halted = this.runs !== null;
    if (this.halted) this.showMistakes(null, 'Reading this text was stopped. It is read when it changes.');
  }

  /// A text without mistakes is what is shown from now on.
  accept(text, checked) {
    const { studio } = this;
    const first = !studio.base;
    Object.assign(studio, { checked, goodText: text, base: cameras.cameraOf(checked.view) });
    if (first || !studio.camera.moved) studio.camera = studio.base;
    this.showMistakes(null, checked.warnings);
    byId('frame-label').hidden = checked.frames <= 1;
    byId('frame').max = checked.frames - 1;
    studio.live.change();
    studio.handles.draw();
    this.factsOld = true;
    awaitFacts(byId('panel-facts'));
    clearTimeout(this.soon);
    this.soon = setTimeout(() => this.inspect(), quiet);
  }

  /// What is known, where somebody looks at it.
  async inspect() {
    const { studio } = this;
    if (studio.tab !== 'facts' || !this.factsOld) return;
    this.factsOld = false;
    const serial = this.asked = (this.asked ?? 0) + 1;
    try {
      const facts = await server.inspect({ name: studio.name, text: studio.goodText, frame: studio.frame });
      if (serial !== this.asked || studio.goodText === '') return;  // there is a newer question, or another scene
      if (facts) showFacts(byId('panel-facts'), facts);
      if (this.factsOld) awaitFacts(byId('panel-facts'));
      else if (!facts) awaitFacts(byId('panel-facts'), 'Computing was stopped. It begins again with the next change.');
    } catch (error) {
      byId('panel-facts').replaceChildren(element('p', { class: 'note' }, error.message));
    }
  }

  showMistakes(error, warnings = '') {
    const place = byId('mistakes');
    const mistakes = error?.mistakes ?? [];
    const here = mistakes.filter(m => m.file === this.studio.name);
    // A text with another mistake says nothing of that, nor does one that is still being read.
    const growing = mistakes.map(m => refusal.exec(m.message)?.[1]).filter(name => name !== undefined);
    if (growing.length > 0 || (!error && !this.halted)) this.growing = growing;
    this.studio.editor.mark(here);
    this.studio.maps.mark(here);
    this.studio.maps.refresh();
    this.studio.handles.draw();
    place.hidden = !error && !warnings;
    byId('nothing').hidden = !error || this.studio.goodText !== '';
    place.classList.toggle('warning', !error);
    place.replaceChildren(...(mistakes.length > 0
      ? mistakes.slice(0, shown_mistakes).map(m => element('button', { class: 'mistake', onclick: () => { this.studio.choose('text'); this.studio.editor.goTo(m.line, m.column); } },
        element('b', {}, `line ${m.line}`), ` ${m.message}`))
      : [element('p', {}, error ? error.message : warnings)]));
  }
}
