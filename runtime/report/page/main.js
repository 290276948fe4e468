// The state of the page, in one place: the flight, the cursor, the span that is seen.

class State {
  constructor() {
    this.all = false;
    this.chosen = -1;
    this.playing = false;
    this.found = [];
    this.timeline = new Timeline(this);
    this.panel = new Panel(this);
    this.drawings = [];
    listenToTabs(document.querySelector("#details .tabs"), () => this.tell());
    this.showDetails = (id) => byId(id).click();
    listenToTabs(document.querySelector("#drawings .tabs"), () => this.refollow());
    listenToTransport(this);
    listenToKeys(this);
    listenToSearch(this);
    byId("theme").addEventListener("click", () => switchTheme(this));
    const select = byId("flight");
    select.hidden = report.flights.length < 2;
    byId("name").classList.toggle("chosen", report.flights.length > 1);
    report.flights.forEach((flight, i) => {
      const option = make("option", "", (flight.verdict ? flight.verdict + ": " : "") + flight.name);
      option.value = i;
      select.append(option);
    });
  }

  open(index) {
    this.setPlaying(false);
    const flight = (this.flight = flightOf(index));
    this.events = eventsOf(flight);
    this.moments = [...new Set(this.events.map((event) => event.time))];
    this.rows = rowsOf(flight, this.events);
    this.chosen = -1;
    byId("flight").value = index;
    byId("flight").title = flight.name;
    byId("name").textContent = flight.name;
    byId("verdict").textContent = flight.verdict;
    byId("verdict").className = "chip " + flight.verdict;
    byId("facts").textContent = [
      flight.model.program ? "program " + flight.model.program : "", "plant " + flight.model.plant,
      flight.cycle > 0 ? "cycle " + clockText(flight.cycle) : "dense time, steps of one moment a nanosecond apart", flight.seed !== undefined ? "seed " + flight.seed : "",
    ].filter(Boolean).join(" \u00b7 ");
    byId("facts").title = byId("facts").textContent;
    byId("ruler").setAttribute("aria-valuemax", flight.end);
    const {program, plant, missing} = flight.model.drawings;
    byId("tab-program").hidden = !flight.model.program;
    this.drawings = [
      new ProgramDrawing(byId("pane-program"), program, missing),
      new PlantDrawing(byId("pane-plant"), plant, missing, flight.model),
    ];
    if (!flight.model.program) byId("tab-plant").click();
    byId("speed").value = speeds.find((speed) => flight.end / speed <= 60) ?? speeds[speeds.length - 1];
    this.view = {from: 0, to: 1};
    this.cursor = 0;
    this.search("");
    this.panel.build();
    this.timeline.build();
    this.fit();
    // What a reviewer asks first: what failed; else what went wrong; else how it began.
    const first = this.events.find((e) => e.kind === "failed") ?? this.events.find((e) => e.severe) ?? {time: 0};
    this.setCursor(first.time, true);
    const at = this.events.find((e) => e.time === first.time && e.component >= 0);
    if (at) this.choose(at.component);
  }

  /** The nearest cycle, or, in dense time, the time itself. */
  snap(time) {
    const {cycle, end} = this.flight;
    const near = cycle > 0 ? Math.round(time / cycle) * cycle : time;
    return Math.max(0, Math.min(end, Number(near.toFixed(9))));
  }

  setCursor(time, show = false) {
    this.cursor = Math.max(0, Math.min(this.flight.end, time));
    if (show && (this.cursor < this.view.from || this.cursor > this.view.to)) {
      const half = (this.view.to - this.view.from) / 2;
      this.setView(this.cursor - half, this.cursor + half);
    }
    this.tell();
  }

  tell() {
    if (!this.flight) return;
    const {flight, cursor} = this;
    byId("now").textContent = clockText(cursor);
    byId("cycle").textContent = (cursor >= 60 ? secondsText(cursor) : "") + (flight.cycle > 0 ? (cursor >= 60 ? " \u00b7 " : "") + "cycle " + Math.floor(cursor / flight.cycle + 1e-6) : "");
    const ruler = byId("ruler");
    ruler.setAttribute("aria-valuenow", cursor);
    ruler.setAttribute("aria-valuetext", clockText(cursor));
    this.timeline.tell();
    this.timeline.draw();
    this.panel.tell();
    this.mark();
  }

  mark() {
    const {flight, cursor} = this;
    const follow = byId("follow").checked;
    for (const drawing of this.drawings) drawing.mark(flight, cursor, follow, this.chosen);
  }

  refollow() {
    if (!this.flight) return;
    for (const drawing of this.drawings) drawing.marked = undefined;
    this.tell();
  }

  choose(component) {
    if (component === this.chosen) return;
    this.chosen = component;
    this.panel.tellCursor();
    this.mark();
  }

  setAll(all) {
    this.all = all;
    byId("all").checked = all;
    this.timeline.build();
    this.tell();
  }

  setView(from, to) {
    const end = Math.max(this.flight.end, 1e-6);
    const margin = end * 0.02;
    const span = Math.max(Math.min(to - from, end + 2 * margin), Math.min(2e-3, end));
    const start = Math.max(-margin, Math.min(end + margin - span, (from + to - span) / 2));
    this.view = {from: start, to: start + span};
    this.timeline.draw();
  }

  fit() {
    this.setView(-this.flight.end * 0.02, this.flight.end * 1.02);
  }

  /** The shortest span in which seven of ten events are, with the cursor in it. */
  fitBusy() {
    const times = this.events.map((event) => event.time);
    const wanted = Math.ceil(times.length * 0.7);
    if (wanted < 2) return this.fit();
    let best = 0;
    for (let i = 0; i + wanted <= times.length; ++i) {
      if (times[i + wanted - 1] - times[i] < times[best + wanted - 1] - times[best]) best = i;
    }
    const from = times[best], to = times[best + wanted - 1];
    const margin = Math.max((to - from) * 0.06, this.flight.cycle);
    this.setView(from - margin, to + margin);
    if (this.cursor < this.view.from || this.cursor > this.view.to) this.setCursor(from);
  }

  /** Nearer with a factor below 1, around a time or the cursor. */
  zoom(factor, around = this.cursor) {
    const {from, to} = this.view;
    const middle = around >= from && around <= to ? around : (from + to) / 2;
    this.setView(middle - (middle - from) * factor, middle + (to - middle) * factor);
  }

  pan(time) {
    this.setView(this.view.from + time, this.view.to + time);
  }

  step(direction) {
    const {cycle} = this.flight;
    if (cycle > 0) this.setCursor(this.snap(this.cursor + direction * cycle), true);
    else this.jump(direction);
    this.say();
  }

  jump(direction) {
    const near = 1e-9 + this.cursor * 4e-16;
    const later = this.moments.filter((time) => (direction > 0 ? time > this.cursor + near : time < this.cursor - near));
    if (later.length) this.setCursor(direction > 0 ? later[0] : later[later.length - 1], true);
    this.say();
  }

  goTo(event) {
    this.setCursor(event.time, true);
    if (event.component >= 0) this.choose(event.component);
    this.say();
  }

  /** Tells the cursor to who does not see it. */
  say() {
    const now = this.events.filter((event) => Math.abs(event.time - this.cursor) < 1e-9);
    byId("said").textContent = clockText(this.cursor) + (now.length ? ": " + now.map((event) => event.kind + " " + event.text).join("; ") : "");
  }

  setPlaying(playing) {
    if (this.playing === playing) return;
    this.playing = playing;
    byId("play-icon").firstElementChild.setAttribute("d", playing ? "M3.5 3h3v10h-3zM9.5 3h3v10h-3z" : "M4 2.5v11L13 8z");
    byId("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    if (!playing) return;
    if (this.cursor >= this.flight.end) this.setCursor(0, true);
    let last = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      this.setCursor(this.cursor + ((now - last) / 1000) * Number(byId("speed").value), true);
      last = now;
      if (this.cursor >= this.flight.end) this.setPlaying(false);
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /** Finds events, and rows by their names. */
  search(text) {
    const wanted = text.trim().toLowerCase();
    this.found = wanted ? this.events.filter((event) => (event.kind + " " + event.text).toLowerCase().includes(wanted)) : [];
    this.foundAt = -1;
    byId("search").value = text;
    byId("found").textContent = wanted ? String(this.found.length) : "";
    for (const row of this.timeline.shown) row.element?.classList.toggle("found", wanted !== "" && row.label.toLowerCase().includes(wanted));
    this.panel.build(wanted ? this.found : undefined);
    if (wanted) this.showDetails("tab-events");
    this.panel.tell();
  }

  nextFound(direction) {
    if (!this.found.length) return;
    this.foundAt = (Math.max(this.foundAt, direction > 0 ? -1 : 0) + direction + this.found.length) % this.found.length;
    byId("found").textContent = this.foundAt + 1 + " / " + this.found.length;
    this.goTo(this.found[this.foundAt]);
  }
}

startTheme();
const state = new State();
state.open(0);
globalThis.flightReport = state;  // for the console, and for tests
document.documentElement.dataset.ready = "yes";
