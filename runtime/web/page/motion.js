// The page of a motion, in a frame; the next is shown once it is drawn, at the time and as the last one stood.

const frames = { shown: null, coming: null, at: null };

/// Shows the page of a motion. It is data to this page: what runs in it runs in a frame of no origin.
function showMotion(html) {
  frames.coming?.remove();
  const frame = document.createElement("iframe");
  frame.sandbox = "allow-scripts";
  frame.title = "Motion";
  frame.srcdoc = html;
  frames.coming = frame;
  byId("motion").append(frame);
}

addEventListener("message", ({ source, data }) => {
  const { shown, coming } = frames;
  if (coming && source === coming.contentWindow && data.ready) {
    if (frames.at) source.postMessage(frames.at, "*");
    shown?.remove();
    byId("motion").querySelector(":scope > svg")?.remove();
    coming.classList.add("shown");
    [frames.shown, frames.coming] = [coming, null];
    document.body.dataset.motions = Number(document.body.dataset.motions ?? 0) + 1;
  } else if (shown && source === shown.contentWindow && data.at) {
    frames.at = data.at;
  }
});
