// The list of events.

const rows = motion.events.map((event) => {
  const item = html("li", {}, byId("events"));
  const button = html("button", { "data-t": event.t }, item);
  html("span", { class: "when", text: timeText(event.t) }, button);
  html("span", { class: `what ${event.kind}`, text: event.kind }, button);
  const impulses = event.impulses.map(({ label, value: P }) => `impulse at ${label}: ${digits(P, 4)} N s`);
  html("span", { class: "whom", text: event.supports.join(", ") }, button);
  const note = [...impulses, event.note ?? ""].filter(Boolean).join("; ");
  if (note) html("span", { class: "note", text: note }, button);
  button.addEventListener("click", () => {
    setPlaying(false);
    seek(event.t);
  });
  return button;
});
const eventTimes = motion.events.map((event) => event.t);

let current = null;

/// Marks the last event up to the time shown, and keeps it in sight within the list.
onTime.push((t) => {
  const row = eventTimes[0] <= t ? rows[lastAt(eventTimes, t)] : null;
  if (row === current) return;
  current?.removeAttribute("aria-current");
  row?.setAttribute("aria-current", "true");
  current = row;
  if (!row) return;
  const list = byId("events");
  const [top, bottom] = [row.parentNode.offsetTop - list.offsetTop, row.parentNode.offsetTop + row.offsetHeight - list.offsetTop];
  if (top < list.scrollTop) list.scrollTop = top;
  if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
});

onTime.push((t) => {
  const output = byId("clock");
  output.textContent = `t = ${timeText(t)}`;
  output.dataset.t = t;
  const supports = phaseAt(t)?.supports ?? [];
  byId("phase").textContent = supports.length ? `on ${supports.join(", ")}` : motion.geometry.contacts.length ? "free" : "";
});
