// Questions on one connection that stays open, whose answers come in pieces (host/studio/web_socket.hpp):
// a browser takes four milliseconds for a request, and one for a message.

export class Line {
  /// `path`: of what is asked. `gone()` is the error of who asks when nobody answers.
  constructor(path, gone) {
    this.path = path;
    this.gone = gone;
    this.opened = null;        // the promise of a WebSocket
    this.asked = 0;            // questions on this one
    this.waiting = new Map();  // by the number of the question
  }

  /// `take(bytes)` hears each piece, and says whether that was all. Resolves to { status, bytes } of what
  /// the answer ends with, or to null once all has been taken.
  async ask(text, take) {
    const socket = await (this.opened ??= this.open());
    return new Promise((done, failed) => {
      this.waiting.set(++this.asked, { done, failed, take });
      socket.send(text);
    });
  }

  open() {
    return new Promise((done, failed) => {
      const socket = new WebSocket(`ws://${location.host}${this.path}`);
      socket.binaryType = 'arraybuffer';
      socket.onopen = () => done(socket);
      socket.onmessage = ({ data }) => this.hear(data);
      socket.onclose = () => {
        failed(this.gone());  // if it was never open
        for (const asking of this.waiting.values()) asking.failed(this.gone());
        Object.assign(this, { opened: null, asked: 0, waiting: new Map() });
      };
    });
  }

  hear(data) {
    const [number, status] = new Uint32Array(data, 0, 2), bytes = new Uint8Array(data, 8);
    const asking = this.waiting.get(number);  // none if all was taken before the end
    if (!asking) return;
    try {
      if (status === 0 && !asking.take(bytes)) return;
      asking.done(status === 0 ? null : { status, bytes });
    } catch (error) {
      asking.failed(error);
    }
    this.waiting.delete(number);
  }
}
