// What the user does: the transport, keys, the search, light and dark.

const speeds = [1, 2, 5, 10, 30, 60, 300, 600, 1800, 3600];

function listenToTransport(state) {
  const on = (id, what) => byId(id).addEventListener("click", what);
  on("previous", () => state.jump(-1));
  on("next", () => state.jump(1));
  on("back", () => state.step(-1));
  on("forth", () => state.step(1));
  on("play", () => state.setPlaying(!state.playing));
  on("in", () => state.zoom(0.5));
  on("out", () => state.zoom(2));
  on("fit", () => state.fit());
  on("busy", () => state.fitBusy());
  on("help", () => byId("keys").showModal());
  on("whole", () => state.drawings.forEach((drawing) => drawing.fit()));
  byId("all").addEventListener("change", (event) => state.setAll(event.target.checked));
  byId("follow").addEventListener("change", () => state.refollow());
  byId("speed").append(...speeds.map((speed) => {
    const option = make("option", "", speed + "\u00d7");
    option.value = speed;
    return option;
  }));
  byId("flight").addEventListener("change", (event) => state.open(Number(event.target.value)));
  byId("ruler").addEventListener("keydown", (event) => {
    const move = {PageUp: 1, PageDown: -1}[event.key];
    if (!move) return;
    state.jump(move);
    event.preventDefault();
  });
}

function listenToKeys(state) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || byId("keys").open) return;
    if (event.target.closest("input[type=search], select")) {
      if (event.key === "Escape") event.target.blur();
      return;
    }
    if (event.key === " " && event.target.closest("button, input")) return;
    const far = (state.view.to - state.view.from) / 4;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const what = {
      ArrowLeft: () => (event.shiftKey ? state.jump(-1) : state.step(-1)),
      ArrowRight: () => (event.shiftKey ? state.jump(1) : state.step(1)),
      Home: () => state.setCursor(0, true),
      End: () => state.setCursor(state.flight.end, true),
      p: () => state.jump(-1),
      n: () => state.jump(1),
      " ": () => state.setPlaying(!state.playing),
      "+": () => state.zoom(0.5),
      "=": () => state.zoom(0.5),
      "-": () => state.zoom(2),
      f: () => state.fit(),
      b: () => state.fitBusy(),
      a: () => state.pan(-far),
      d: () => state.pan(far),
      t: () => switchTheme(state),
      "?": () => byId("keys").showModal(),
      "/": () => byId("search").focus(),
    }[key];
    if (!what) return;
    what();
    event.preventDefault();
  });
}

function listenToSearch(state) {
  const input = byId("search");
  input.addEventListener("input", () => state.search(input.value));
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") state.nextFound(event.shiftKey ? -1 : 1);
  });
}

/** Light or dark: as chosen before, else as the system has it. */
function startTheme() {
  let chosen = null;
  try {
    chosen = localStorage.getItem("rmpl-report-theme");
  } catch {}  // a page from a file may not be allowed to
  const dark = chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  document.documentElement.dataset.theme = dark ? "dark" : "light";
}

function switchTheme(state) {
  const theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem("rmpl-report-theme", theme);
  } catch {}
  state.timeline.draw();
}
