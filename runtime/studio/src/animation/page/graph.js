// A graph of quantities over time, with a cursor at the time shown.

const HEIGHT = 150;
const PAD = { left: 58, right: 10, top: 8, bottom: 22 };

/// The range of values to show: a pole does not count; pushes and energies are measured from zero.
function valueRange(quantities, fromZero) {
  const all = ordered(quantities.flatMap(allValues));
  if (!all.length) return [0, 1];
  const [inner, outer] = [[0.02, 0.98], [0, 1]].map((parts) => parts.map((p) => quantile(all, p)));
  const poles = outer[1] - outer[0] > 30 * (inner[1] - inner[0]) && inner[1] > inner[0];
  let [low, high] = poles ? inner : outer;
  if (fromZero) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  const room = 0.06 * (high - low) || 0.1 * Math.abs(high) || 1;
  // A change that is only rounding is none.
  const flat = high - low < 1e-9 * Math.max(Math.abs(high), Math.abs(low));
  const margin = flat ? 0.1 * Math.max(Math.abs(high), Math.abs(low)) : room;
  return [low - margin, high + margin];
}

/// The curve of a quantity on the paper of a graph.
function curvePath(quantity, toX, toY) {
  let end = "";
  return intervals.map((interval) => {
    const { t0, t1, phase, i } = interval;
    const times = [0, 1, 2, 3].map((k) => toX(t0 + (k / 3) * (t1 - t0)));
    const values = control(nodes(phase, quantity, i)).map(toY);
    if (!values.every((y) => Number.isFinite(y) && Math.abs(y) < 1e6)) return "";
    const ends = [0, 1, 2, 3].map((k) => `${px(times[k])} ${px(values[k])}`);
    // One path where it goes on: dashes would begin anew at each move.
    const move = ends[0] === end ? "" : `M${ends[0]}`;
    end = ends[3];
    return `${move}C${ends.slice(1).join(" ")}`;
  }).join("");
}

/// Shaded phases, and a line at each event.
function drawBackground(paper, toX) {
  const [top, bottom] = [PAD.top, HEIGHT - PAD.bottom];
  motion.phases.forEach((phase, i) => {
    const [x0, x1] = [toX(phase.times[0]), toX(phase.times.at(-1))];
    if (i % 2) svg("rect", { class: "band", x: px(x0), y: top, width: px(x1 - x0), height: bottom - top }, paper);
  });
  for (const { t, kind } of motion.events) {
    if (kind !== "start" && kind !== "end") svg("path", { class: `tick ${kind}`, d: `M${px(toX(t))} ${top}V${bottom}` }, paper);
  }
}

function drawAxes(paper, toX, toY, [low, high], width) {
  const [right, bottom] = [width - PAD.right, HEIGHT - PAD.bottom];
  for (const { x, text } of ticks(low, high, 4)) {
    svg("path", { class: "grid", d: `M${PAD.left} ${px(toY(x))}H${right}` }, paper);
    svg("text", { x: PAD.left - 6, y: px(toY(x) + 4), "text-anchor": "end", text }, paper);
  }
  const all = tEnd > tStart ? ticks(tStart, tEnd, Math.max(2, Math.min(7, width / 80))) : [];
  for (const { x, text } of all) {
    if (toX(x) > right - 30) continue;
    svg("path", { class: "grid", d: `M${px(toX(x))} ${bottom}v4` }, paper);
    svg("text", { x: px(toX(x)), y: HEIGHT - 6, "text-anchor": "middle", text }, paper);
  }
  svg("text", { x: right, y: HEIGHT - 6, "text-anchor": "end", text: "t, s" }, paper);
  svg("rect", { class: "frame", x: PAD.left, y: PAD.top, width: right - PAD.left, height: bottom - PAD.top }, paper);
}

/// A graph in a figure: its curves are entries with a quantity, a class and a dash.
function makeGraph(figure, entries, fromZero) {
  const paper = svg("svg", { class: motion.events.length > 20 ? "paper crowded" : "paper", role: "img", "aria-label": entries.map(({ name }) => name).join(", ") }, figure);
  const graph = { width: 0, toX: () => 0, toY: () => 0, cursor: null, dots: [] };
  const timeAt = ({ clientX }) => {
    const { left: x, width } = paper.getBoundingClientRect();
    const inner = graph.width - PAD.left - PAD.right;
    return tStart + ((((clientX - x) * graph.width) / width - PAD.left) / inner) * (tEnd - tStart);
  };
  scrubs(paper, timeAt);
  graph.resize = () => {
    graph.width = paper.getBoundingClientRect().width || graph.width;
    if (!graph.width) return;
    drawGraph(graph, paper, entries, fromZero);
    graph.follow(clock.t);
  };
  graph.follow = (t) => {
    if (!graph.cursor) return;
    const x = px(graph.toX(t));
    graph.cursor.setAttribute("d", `M${x} ${PAD.top}V${HEIGHT - PAD.bottom}`);
    entries.forEach((entry, i) => {
      const y = graph.toY(value(entry.quantity, t));
      const inside = y >= PAD.top - 1 && y <= HEIGHT - PAD.bottom + 1;
      show(graph.dots[i], inside && !entry.hidden);
      if (inside) set(graph.dots[i], { cx: x, cy: px(y) });
    });
  };
  return graph;
}

function drawGraph(graph, paper, entries, fromZero) {
  const seen = entries.filter((entry) => !entry.hidden).map((entry) => entry.quantity);
  const [low, high] = valueRange(seen, fromZero);
  const inner = [graph.width - PAD.left - PAD.right, HEIGHT - PAD.top - PAD.bottom];
  graph.toX = (t) => PAD.left + inner[0] * part(t);
  graph.toY = (y) => PAD.top + inner[1] * ((high - y) / (high - low));
  paper.setAttribute("viewBox", `0 0 ${graph.width} ${HEIGHT}`);
  paper.replaceChildren();
  drawBackground(paper, graph.toX);
  drawAxes(paper, graph.toX, graph.toY, [low, high], graph.width);
  const window = svg("svg", { x: PAD.left, y: PAD.top, width: inner[0], height: inner[1], viewBox: `${PAD.left} ${PAD.top} ${inner[0]} ${inner[1]}` }, paper);
  for (const { quantity, ink, dash, hidden } of entries) {
    const d = hidden ? "" : curvePath(quantity, graph.toX, graph.toY);
    svg("path", { class: `curve ink-${ink}`, "stroke-dasharray": dash, d }, window);
  }
  graph.cursor = svg("path", { class: "cursor" }, paper);
  graph.dots = entries.map(({ ink }) => svg("circle", { class: `dot ink-${ink}`, r: 3.5 }, paper));
}
