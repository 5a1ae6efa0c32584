// The bar of time: phases as bands, events as ticks, a handle to drag.

const scrubber = byId("scrubber");
const track = svg("svg", { "aria-hidden": true, preserveAspectRatio: "none", viewBox: "0 0 1000 24" }, scrubber);
const handle = html("div", { class: "handle" }, scrubber);

const part = (t) => (tEnd > tStart ? (t - tStart) / (tEnd - tStart) : 0);
const partX = (t) => px(1000 * part(t));

motion.phases.forEach((phase, i) => {
  const [x0, x1] = [partX(phase.times[0]), partX(phase.times.at(-1))];
  svg("rect", { class: i % 2 ? "band odd" : "band", x: x0, y: 7, width: px(x1 - x0), height: 10 }, track);
});
for (const { t, kind } of motion.events) {
  svg("path", { class: `tick ${kind}`, d: `M${partX(t)} 2V22` }, track);
}

onTime.push((t) => {
  handle.style.left = `${100 * part(t)}%`;
  set(scrubber, { "aria-valuemin": tStart, "aria-valuemax": tEnd, "aria-valuenow": t, "aria-valuetext": `t = ${timeText(t)}` });
});

/// Lets a drag on a node choose the time that stands under it.
function scrubs(node, timeAt) {
  const follow = (event) => {
    setPlaying(false);
    seek(timeAt(event));
  };
  node.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.target.closest("button")) return;
    node.setPointerCapture(event.pointerId);
    follow(event);
  });
  node.addEventListener("pointermove", (event) => {
    if (node.hasPointerCapture(event.pointerId)) follow(event);
  });
}

scrubs(scrubber, ({ clientX }) => {
  const { left: x, width } = track.getBoundingClientRect();
  return tStart + ((clientX - x) / width) * (tEnd - tStart);
});
