// Files from elsewhere: a scene, or what `pxm import` makes one of (docs/import.md), as a scene that is
// not saved.
import { byId, element, toast } from './elements.js';
import * as server from './server.js';

const most_bytes = 1_400_000, most_scene_bytes = 1_000_000;

const plainName = name => name.replace(/[^\w.-]/g, '_').replace(/^[.]+/, '') || 'dropped.pxm';

async function base64Of(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}

/// The names in the message that says that a file holds several systems.
export const entriesOf = message => message.split('\n').filter(line => line.startsWith('  ')).map(line => line.trim());

/// Which of several; null if none.
async function chosenOf(names) {
  const dialog = byId('entry-dialog'), list = byId('entry-list');
  list.replaceChildren(...names.map(name => element('option', { value: name }, name)));
  list.selectedIndex = 0;
  dialog.returnValue = '';
  dialog.showModal();
  await new Promise(done => dialog.addEventListener('close', done, { once: true }));
  return dialog.returnValue === 'open' ? list.value : null;
}

async function imported(file, data, entry) {
  toast(`Reading ${file.name} …`);
  try {
    return await server.importFile(file.name, data, entry);
  } catch (error) {
    const names = entry === undefined && error.kind === 'setting' ? entriesOf(error.message) : [];
    if (names.length === 0) throw error;
    const wanted = await chosenOf(names);
    return wanted === null ? null : imported(file, data, wanted);
  }
}

export async function bring(studio, file) {
  try {
    if (/\.pxm$/i.test(file.name)) {
      if (file.size > most_scene_bytes) throw new Error(`${file.name} is larger than the studio takes: 1 MB.`);
      return studio.place.begin(plainName(file.name), await file.text());
    }
    if (file.size > most_bytes) throw new Error(`${file.name} is larger than the studio takes: 1.4 MB. pxm import has no such limit.`);
    const made = await imported(file, await base64Of(file));
    if (!made) return undefined;
    studio.place.begin(plainName(made.name), made.text);
    toast(made.messages.trim() || `A scene was made of ${file.name}. Nothing is saved yet.`);
  } catch (error) {
    toast(error.message, 'bad');
  }
  return undefined;
}

export function takeDropped(studio, event) {
  const file = event.dataTransfer.files[0];
  if (!file) return undefined;
  event.preventDefault();
  return bring(studio, file);
}
