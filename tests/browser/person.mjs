// Who uses a page as a person does: it reads, thinks, points, presses and types one key after another, and
// each of these takes as long as the keystroke-level model says [CMN80]. That time is waited for, or, in
// tests, only counted.
const seconds = { word: 0.3, think: 1.35, point: 1.1, press: 0.2, home: 0.4, key: 0.28 };  // a word: 200 a minute

export class Person {
  constructor(page, { waits = false } = {}) {
    Object.assign(this, { page, waits, counted: 0, begin: Date.now() });
  }

  async take(time) {
    this.counted += time;
    if (this.waits) await this.page.waitForTimeout(1000 * time);
  }

  /// Seconds from the beginning: those of the page and the program, which are measured, and its own.
  get spent() { return (Date.now() - this.begin) / 1000 + (this.waits ? 0 : this.counted); }

  /// What is to be seen there.
  async read(selector) {
    const text = await this.page.locator(selector).innerText();
    await this.take(seconds.word * text.split(/\s+/).length);
    return text;
  }

  async click(selector) {
    await this.take(seconds.think + seconds.point + seconds.press);
    await this.page.click(selector);
  }

  /// Over what stands in the field, which the click has selected.
  async type(selector, text) {
    await this.click(selector);
    await this.take(seconds.home);
    await this.keys(text);
    await this.take(seconds.home);
  }
  async keys(text) {
    for (const key of text) {
      await this.take(seconds.key);
      await this.page.keyboard.press(key);
    }
  }
  /// From the field that has the focus to the next one, and over what stands there.
  async next(text) {
    await this.take(seconds.key);
    await this.page.keyboard.press('Tab');
    await this.keys(text);
  }
}
