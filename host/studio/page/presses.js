// The second click of a double click is meant for what the first one was on. Where that one made something
// else come under the pointer, as the body of a map that slides up, nobody has aimed at it. What has
// `data-once` minds the first click alone.

const pressable = 'button, summary, a, [role="button"], .arrow';

/// What is pressed, by its name where it has one: it may have been made anew since.
const nameOf = pressed => pressed && (pressed.dataset.key ?? (pressed.id || pressed.dataset.node) ?? pressed);

export function mindDoubleClicks(page) {
  let first = null;
  page.addEventListener('click', event => {
    const pressed = event.target.closest?.(pressable), name = nameOf(pressed);
    if (event.detail <= 1) first = name;
    else if (pressed && (name !== first || pressed.hasAttribute('data-once'))) {
      event.preventDefault();
      event.stopPropagation();
    }
  }, { capture: true });
}
