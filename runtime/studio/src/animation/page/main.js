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
});

new ResizeObserver(() => {
  resize();
  rendered();
}).observe(stage);
new ResizeObserver(() => panels.forEach((panel) => panel.shown && panel.graph.resize())).observe(byId("panels"));

showSpeed();
resize();
panels.forEach((panel) => panel.graph.resize());
seek(asked() ?? tStart);
const calm = matchMedia("(prefers-reduced-motion: reduce)").matches || asked() !== null;
if (!calm) setPlaying(true);

// In a frame of another page: that is told the time, and may set it.
if (parent !== window) {
  onTime.push((t) => parent.postMessage({ at: { t, playing: clock.playing } }, "*"));
  addEventListener("message", ({ source, data }) => {
    if (source !== parent || !Number.isFinite(data?.t)) return;
    seek(data.t);
    setPlaying(data.playing === true);
  });
  parent.postMessage({ ready: true }, "*");
}
