// Wheel, drag and pinch on the picture.

/// The pointers that are down, with their places.
const pointers = new Map();

function placeOf(event) {
  const { left: x, top: y } = stage.getBoundingClientRect();
  return [event.clientX - x, event.clientY - y];
}

stage.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), placeOf(event));
  rendered();
}, { passive: false });

stage.addEventListener("pointerdown", (event) => {
  pointers.set(event.pointerId, placeOf(event));
  stage.setPointerCapture(event.pointerId);
});

stage.addEventListener("pointermove", (event) => {
  if (!pointers.has(event.pointerId)) return;
  const before = [...pointers.values()];
  pointers.set(event.pointerId, placeOf(event));
  const after = [...pointers.values()];
  const [from, to] = [before, after].map(centre);
  pan(subtract(to, from));
  if (after.length === 2) zoom(apart(after) / (apart(before) || 1), to);
  rendered();
});

for (const end of ["pointerup", "pointercancel"]) {
  stage.addEventListener(end, (event) => pointers.delete(event.pointerId));
}

const centre = (all) => times(1 / all.length, all.reduce(add));
const apart = ([a, b]) => length(subtract(a, b));

/// Shows the time once more, after the view has changed; a system that is followed is held at its new place.
function rendered() {
  view.held = toScreen(middle(clock.t));
  render();
}
