// Time: playing, stepping, and who is told.

const FACTORS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const FRAMES = 30;

/// What is shown beside the bodies.
const shows = { trails: false, reactions: true, names: true };

/// Model time to a second at speed 1: a run of 3 to 20 is played in real time, any other in about eight seconds.
function base() {
  const lasts = tEnd - tStart;
  return lasts <= 0 || (lasts >= 3 && lasts <= 20) ? 1 : round125(lasts / 8);
}

const clock = {
  t: tStart,
  playing: false,
  loops: false,
  factor: FACTORS.indexOf(1),
  base: base(),
  last: 0,
  rate: () => clock.base * FACTORS[clock.factor],
  frame: () => clock.rate() / FRAMES,
};

/// Everything that follows the time: called with it.
const onTime = [];

function render() {
  for (const draw of onTime) draw(clock.t);
}

/// Shows a time.
function seek(t) {
  clock.t = Math.min(Math.max(t, tStart), tEnd);
  render();
}

function setPlaying(playing) {
  if (playing && clock.t >= tEnd) clock.t = tStart;
  clock.playing = playing && tEnd > tStart;
  clock.last = performance.now();
  byId("play").setAttribute("aria-label", clock.playing ? "Pause" : "Play");
  document.body.classList.toggle("playing", clock.playing);
  if (clock.playing) requestAnimationFrame(advance);
}

/// The next frame; after a pause of the browser, no more than a tenth of a second later.
function advance(now) {
  if (!clock.playing) return;
  const passed = Math.min(Math.max(now - clock.last, 0), 100) / 1000;
  clock.last = now;
  const t = clock.t + passed * clock.rate();
  seek(t >= tEnd && clock.loops ? tStart : t);
  if (clock.t < tEnd) return requestAnimationFrame(advance);
  if (clock.playing) setPlaying(false);
}

/// A frame forth or back.
function step(by) {
  setPlaying(false);
  seek(clock.t + by * clock.frame());
}

/// The next event after the time shown, or the one before it.
function stepEvent(by) {
  setPlaying(false);
  const all = motion.events.map((event) => event.t);
  const t = by > 0 ? all.find((at) => at > clock.t) : all.findLast((at) => at < clock.t);
  seek(t ?? (by > 0 ? tEnd : tStart));
}

function changeSpeed(by) {
  clock.factor = Math.min(Math.max(clock.factor + by, 0), FACTORS.length - 1);
  showSpeed();
}

function showSpeed() {
  const rate = Number(clock.rate().toPrecision(1));
  byId("speed").textContent = `${rate} ×`;
  byId("speed").title = rate === 1 ? "real time" : `${rate} of the model's time in a second`;
}
