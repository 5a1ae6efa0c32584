// The page that plays motions, in a frame; each takes the place of the one before it.

const byId = (id) => document.getElementById(id);

const player = { frame: () => byId("player").querySelector("iframe") };
player.ready = new Promise((done) => (player.done = done));

addEventListener("message", ({ source, data }) => {
  if (source !== player.frame()?.contentWindow) return;
  if (data.ready) player.done();
  if (!data.shown) return;
  byId("player").querySelector(":scope > svg")?.remove();
  document.body.dataset.motions = Number(document.body.dataset.motions ?? 0) + 1;
});

/// Shows a motion, which is data.
async function showMotion(played) {
  await player.ready;
  player.frame().contentWindow.postMessage(played, "*");
}
