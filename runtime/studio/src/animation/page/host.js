// The motion of the page; in a frame of another page also those that it sends, each in place of the last.

const [head, ...places] = document.querySelectorAll("header, main, dialog");
const blank = places.map((node) => node.cloneNode(true));
const shown = { player: null, ends: null, places };

/// Plays a motion, shown as the one before it.
function begin(motion) {
  const earlier = shown.player?.state();
  shown.ends?.abort();
  if (shown.ends) {
    const fresh = blank.map((node) => node.cloneNode(true));
    shown.places.forEach((node, i) => node.replaceWith(fresh[i]));
    shown.places = fresh;
  }
  shown.ends = new AbortController();
  shown.player = play(motion, shown.ends.signal, earlier);
}

const own = JSON.parse(document.getElementById("motion").textContent);
if (own) begin(own);
if (parent !== window) {
  addEventListener("message", ({ source, data }) => {
    if (source !== parent || !data.motion) return;
    head.innerHTML = data.head;
    begin(data.motion);
    parent.postMessage({ shown: true }, "*");
  });
  parent.postMessage({ ready: true }, "*");
}
