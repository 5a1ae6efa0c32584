// Draws a time, and begins.

onTime.unshift((t) => {
  if (view.follows) followTo(t);
  for (const body of bodies) body(t);
  show(layers.forces, shows.reactions);
  show(layers.words, shows.names);
  drawForces(t);
  drawTrails(t);
});

/// The time that the address asks for: `#t=0.5`.
function asked() {
  const t = /^#t=(.+)$/.exec(location.hash);
  return t && Number.isFinite(Number(t[1])) ? Number(t[1]) : null;
}

addEventListener("hashchange", () => {
  if (asked() !== null) jump(asked());
}, { signal });

const resized = [
  new ResizeObserver(() => {
    resize();
    rendered();
  }),
  new ResizeObserver(() => panels.forEach((panel) => panel.shown && panel.graph.resize())),
];
resized[0].observe(stage);
resized[1].observe(byId("panels"));
signal.addEventListener("abort", () => {
  setPlaying(false);
  resized.forEach((observer) => observer.disconnect());
});

/// What can be pressed and stays so, by a name that it has in the next motion too.
const pressable = () => Object.fromEntries(
  [...document.querySelectorAll("[aria-pressed]")].map((node) => [node.id || node.dataset.quantity || node.textContent, node]),
);

/// How this motion is shown.
function state() {
  const pressed = Object.entries(pressable()).map(([name, node]) => [name, node.getAttribute("aria-pressed")]);
  return { t: clock.t, playing: clock.playing, factor: clock.factor, pressed, view: view.fitted ? null : { ...view } };
}

/// Shows this motion as another was shown.
function restore({ t, playing, factor, pressed, view: seen }) {
  const nodes = pressable();
  for (const [name, was] of pressed) {
    if (nodes[name] && nodes[name].getAttribute("aria-pressed") !== was) nodes[name].click();
  }
  clock.factor = factor;
  showSpeed();
  seek(t);
  if (seen) {
    Object.assign(view, { k: seen.k, origin: seen.origin, fitted: false });
    viewChanged();
    rendered();
  }
  setPlaying(playing);
}

showSpeed();
resize();
panels.forEach((panel) => panel.graph.resize());
seek(asked() ?? tStart);
const calm = matchMedia("(prefers-reduced-motion: reduce)").matches || asked() !== null;
if (earlier) restore(earlier);
else if (!calm) setPlaying(true);
return { state };
