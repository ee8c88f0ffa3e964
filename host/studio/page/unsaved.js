// Texts that are not saved: nothing that one leaves is lost. Each is kept with its history as long as the
// page is open, and as a text as long as the tab is.

const prefix = 'pxm:';

export class Unsaved {
  constructor() {
    this.kept = new Map();  // key -> History
  }

  keep(key, history) {
    this.kept.set(key, history);
    try {
      sessionStorage.setItem(key, history.text);
    } catch { /* there is no room: the page still has it */ }
  }
  forget(key) {
    this.kept.delete(key);
    sessionStorage.removeItem(key);
  }

  has(key) { return this.textOf(key) !== null; }
  textOf(key) { return this.kept.get(key)?.text ?? sessionStorage.getItem(key); }
  /// Null after a reload of the tab.
  historyOf(key) { return this.kept.get(key) ?? null; }

  static key(name, shipped) { return `${prefix}${name}:${shipped}`; }
  /// [{ name, shipped, text }], by name.
  list() {
    const keys = new Set([...this.kept.keys(), ...Object.keys(sessionStorage).filter(key => key.startsWith(prefix))]);
    return [...keys].sort().map(key => {
      const [, name, shipped] = /^pxm:(.*):(true|false)$/.exec(key);
      return { name, shipped: shipped === 'true', text: this.textOf(key) };
    });
  }
}
