// What leaves the page: the scene's file, the command, the picture.
import { commandOf } from './command.js';
import { byId, toast } from './elements.js';
import { download, nameOf } from './rendering.js';
import * as server from './server.js';

const patience = 200;  // milliseconds before one is told to wait, and between two looks at how far it is
let pictures = 0;        // that were asked for as PNG

async function saveAs(studio, name, seen) {
  try {
    const answer = await server.save(name, studio.text, seen);
    if (!answer.saved) return false;
    studio.saved = studio.text;
    studio.place.unsaved.forget(studio.place.keptAs());
    Object.assign(studio, { name, shipped: false, digest: answer.digest });
    studio.place.saved(name);
    studio.drawName();
    toast(`Saved ${name}.`);
  } catch (error) {
    toast(error.message, 'bad');
  }
  return true;
}

/// Asks for a name where there is none yet, and before another file than the one seen is replaced.
export async function save(studio, ask = studio.shipped) {
  if (!ask && await saveAs(studio, studio.name, studio.digest)) return;
  const dialog = byId('save-dialog'), field = byId('save-name'), note = byId('save-note');
  field.value = studio.name;
  note.textContent = ask ? '' : `${studio.name} has changed on the disk since it was opened. Save under this name to replace it, or choose another.`;
  let replace = ask ? '' : studio.name;
  byId('save-cancel').onclick = () => dialog.close('cancel');
  for (;;) {
    dialog.returnValue = 'cancel';
    dialog.showModal();
    await new Promise(done => dialog.addEventListener('close', done, { once: true }));
    if (dialog.returnValue !== 'save') return;
    const name = field.value.trim();
    let seen = '';
    try {
      if (replace === name) seen = (await server.open(name)).digest;
    } catch { seen = ''; }
    if (await saveAs(studio, name, seen)) return;
    replace = name;
    note.textContent = `${name} is there already. Save again to replace it.`;
  }
}

/// To the clipboard, if the file that it reads is what is shown.
export async function copyCommand(studio) {
  if (studio.shipped || studio.text !== studio.saved || studio.text !== studio.goodText) {
    toast('Save the scene first, without mistakes: the command reads its file.', 'bad');
    return;
  }
  const command = commandOf(studio.finished());
  try {
    await navigator.clipboard.writeText(command);
    toast(`Copied: ${command}`);
  } catch {
    toast(command);
  }
  byId('command').dataset.command = command;
}

/// The file that the command would write.
export async function savePng(studio) {
  if (studio.goodText === '') return toast('There is no picture yet: mend the scene first.', 'bad');
  const serial = ++pictures, name = nameOf(studio), asked = studio.finished();
  const old = studio.text === studio.goodText ? '' : ' It is the last one without mistakes.';
  let waiting = true;
  // The program renders it once more: only so the file is that of `pxm render`, byte for byte.
  const tell = share => toast(`Rendering ${name} …${share > 0 ? ` ${Math.floor(100 * share)} %` : ''}`, 'wait');
  const watch = setInterval(async () => {
    const progress = await server.progress('png').catch(() => null);
    if (serial === pictures && waiting) tell(progress?.share ?? 0);
  }, patience);
  try {
    const picture = await server.png(asked);
    waiting = false;
    if (!picture && serial !== pictures) return undefined;  // it was asked for again
    if (picture) download(picture, name);
    toast(picture ? `${name} is among your downloads: ${asked.columns}×${asked.rows} pixels.${old}` : `${name} is not saved: it was given up.`, picture ? '' : 'bad');
  } catch (error) {
    waiting = false;
    toast(error.message, 'bad');
  } finally {
    clearInterval(watch);
  }
  return undefined;
}
