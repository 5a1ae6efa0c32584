// A motion whose parameters and start can be changed: the engine begins when a slider is moved first.

described = JSON.parse(byId("described").textContent);
showSliders(described);
byId("sliders").addEventListener("input", () => {
  begin();
  ask({ ask: "derive", text: described.text }).then((told) => wrong(told?.why));
}, { once: true, capture: true });
