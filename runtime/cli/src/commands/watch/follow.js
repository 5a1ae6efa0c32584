(async () => {
  for (;;) {
    await new Promise((done) => setTimeout(done, 200));
    try {
      const number = await (await fetch("/number", { cache: "no-store" })).text();
      if (number !== "NUMBER") return location.reload();
    } catch {
      // The program has ended, or begins anew.
    }
  }
})();
