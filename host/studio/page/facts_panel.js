// What is known of the scene without a ray (docs/inspect.md), as it changes.
import { element, grouped, number } from './elements.js';

const row = (name, value, kind = '', title = '') =>
  [element('dt', { title }, name), element('dd', { class: kind }, value)];

function systemOf(name, ifs) {
  const d = ifs.dimension;
  const contractivity = ifs.contractivity;
  const state = contractivity >= 1 ? 'bad' : contractivity > 0.95 ? 'near' : 'good';
  const open = { holds: 'good', fails: 'near', unknown: '' }[ifs.open_set_condition];
  return element('section', {}, element('h2', {}, name),
    element('div', { class: 'gauge', role: 'meter', 'aria-label': 'contractivity', 'aria-valuemin': 0, 'aria-valuemax': 1, 'aria-valuenow': number(contractivity) },
      bar(contractivity, state)),
    element('dl', { class: 'facts' },
      ...row('contractivity', `${number(contractivity)}${contractivity < 1 ? ', below 1: it contracts' : ''}`, state, `The largest stretch of a map, shown by ${ifs.contraction_proof}`),
      ...(d.similarity === null ? [] : row('similarity dimension', number(d.similarity, 5))),
      ...row('affinity dimension', `${number(d.affinity, 5)}${d.affinity_exact ? '' : ' or less'}`, '', d.affinity_why),
      ...(d.box_counting === null ? [] : row('box counting', `${number(d.box_counting)} ± ${number(d.box_counting_error, 2)}`)),
      ...row('open set condition', ifs.open_set_condition.replace('unknown', 'not known'), open, ifs.open_set_why),
      ...row('connected', ifs.totally_disconnected === null ? 'not known' : ifs.totally_disconnected ? 'no: dust' : 'has connected pieces', '', ifs.totally_disconnected_why),
      ...row('graph', ifs.complete ? 'any map in any' : ifs.strongly_connected ? 'every map leads to every other' : `${ifs.components.length} components`),
      ...row('bounding ball', `radius ${number(ifs.bounding_sphere.radius)}`)),
    element('p', { class: 'note' }, `${d.meaning.charAt(0).toUpperCase()}${d.meaning.slice(1)}.`),
    element('div', { class: 'scroll' }, element('table', {}, element('thead', {}, element('tr', {}, ...['map', 'kind', 'stretch', 'volume'].map(t => element('th', {}, t)))),
      element('tbody', {}, ...ifs.maps.slice(0, 100).map(m => element('tr', {}, element('td', {}, m.name), element('td', {}, m.kind),
        element('td', m.lipschitz < 1 ? {} : contractivity < 1 ? { class: 'near', title: 'This map alone does not shrink, but one map after another does, as they may follow' } : { class: 'bad' }, number(m.lipschitz)), element('td', {}, number(Math.abs(m.determinant)))))))));
}

function bar(share, state) {
  const fill = element('i', { class: state });
  fill.style.width = `${Math.min(100, share * 100)}%`;
  return fill;
}

/// While there are none, or only those of a text before.
export function awaitFacts(place, text = 'Computing what is known of this scene …') {
  place.querySelector('.awaited')?.remove();
  place.prepend(element('p', { class: 'note awaited', role: 'status' }, text));
}

export function showFacts(place, facts) {
  const memory = facts.memory;
  place.replaceChildren(
    ...Object.entries(facts.ifs).map(([name, ifs]) => systemOf(name, ifs)),
    element('section', {}, element('h2', {}, 'Objects'), element('dl', { class: 'facts' },
      ...facts.objects.flatMap(o => row(o.name || o.ifs || 'object', `volume: ${o.volume}`)))),
    element('section', {}, element('h2', {}, `A node of the ${memory.model}`), element('dl', { class: 'facts' },
      ...['fast_memory', 'front_buffer', 'back_buffer', 'zbuffer', 'texture'].flatMap(name => {
        const use = memory[name];
        return row(name.replace('_', ' '), `${grouped(use.used_bytes)} of ${grouped(use.limit_bytes)} bytes`, use.used_bytes > use.limit_bytes ? 'bad' : '');
      }))));
}
