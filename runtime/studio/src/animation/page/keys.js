// Buttons and keys: each does one of these.

const press = (id) => byId(id).click();

const toggles = {
  loop: (on) => { clock.loops = on; },
  trails: (on) => { shows.trails = on; },
  reactions: (on) => { shows.reactions = on; },
  names: (on) => { shows.names = on; },
  follow: (on) => setFollow(on, clock.t),
};

for (const [id, change] of Object.entries(toggles)) {
  byId(id).addEventListener("click", () => {
    const on = byId(id).getAttribute("aria-pressed") !== "true";
    byId(id).setAttribute("aria-pressed", on);
    change(on);
    render();
  });
}

const buttons = {
  play: () => setPlaying(!clock.playing),
  back: () => step(-1),
  forth: () => step(1),
  "to-previous": () => stepEvent(-1),
  "to-next": () => stepEvent(1),
  slower: () => changeSpeed(-1),
  faster: () => changeSpeed(1),
  fit: () => {
    fit();
    rendered();
  },
  help: () => byId("keys").showModal(),
};

for (const [id, action] of Object.entries(buttons)) byId(id).addEventListener("click", action);

function jump(t) {
  setPlaying(false);
  seek(t);
}

const KEYS = {
  " ": () => press("play"),
  ArrowLeft: (event) => press(event.shiftKey ? "to-previous" : "back"),
  ArrowRight: (event) => press(event.shiftKey ? "to-next" : "forth"),
  Home: () => jump(tStart),
  End: () => jump(tEnd),
  "+": () => press("faster"),
  "=": () => press("faster"),
  "-": () => press("slower"),
  0: () => press("fit"),
  l: () => press("loop"),
  t: () => press("trails"),
  r: () => press("reactions"),
  n: () => press("names"),
  f: () => press("follow"),
  "?": () => press("help"),
};

document.addEventListener("keydown", (event) => {
  const action = KEYS[event.key];
  if (!action || event.ctrlKey || event.metaKey || event.altKey || byId("keys").open) return;
  // A button that was reached by the keyboard is pressed by space itself.
  if (event.key === " " && event.target.matches("button:focus-visible")) return;
  event.preventDefault();
  action(event);
}, { signal });
