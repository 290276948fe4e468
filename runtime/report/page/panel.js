// The panes: what holds at the cursor, what happens when, what was asked.

class Panel {
  constructor(state) {
    this.state = state;
    this.list = [];
  }

  /** The list of events, once for each flight; `wanted` are those that a search has found. */
  build(wanted) {
    const pane = byId("pane-events");
    const events = wanted ?? this.state.events;
    this.list = events.map((event) => {
      const button = make("button", "event " + event.kind + (event.severe ? " severe" : ""), make("time", "", clockText(event.time)), make("span", "kind", event.kind), make("span", "text", event.text));
      button.addEventListener("click", () => this.state.goTo(event));
      return {event, button};
    });
    pane.replaceChildren(...(events.length ? this.list.map((entry) => entry.button) : [make("p", "quiet", wanted ? "Nothing that happens is called so." : "Nothing happens.")]));
    this.buildAsked();
    this.current = undefined;
  }

  /** What was asked, what failed before what is undecided before what was met. */
  buildAsked() {
    const {flight} = this.state;
    const pane = byId("pane-asked");
    const rank = {failed: 0, undecided: 1, met: 2};
    const inOrder = [...flight.asked].sort((a, b) => rank[a.verdict] - rank[b.verdict]);
    const name = make("b", "", report.flights.length > 1 ? flight.name : "");
    pane.replaceChildren(name, make("p", "quiet", flight.summary), ...inOrder.map((asked) => {
      const at = asked.time === undefined ? null : make("button", "", clockText(asked.time));
      at?.addEventListener("click", () => this.state.goTo({time: asked.time}));
      const text = make("div", "", make("span", "", asked.text + " "), at);
      if (asked.reason) text.append(make("div", asked.verdict === "failed" ? "bad" : "warn", asked.reason));
      if (asked.evidence) text.append(make("div", "why", asked.evidence));
      return make("div", "asked", make("span", "chip " + asked.verdict, asked.verdict), text);
    }));
    byId("tab-asked").hidden = flight.asked.length === 0 && !flight.summary;
  }

  tell() {
    this.tellCursor();
    this.tellEvents();
  }

  tellEvents() {
    const {events, cursor} = this.state;
    const late = cursor + 5e-10 + cursor * 4e-16;
    let current = -1;
    this.list.forEach(({event}, i) => {
      if (event.time <= late) current = i;
    });
    if (current === this.current || !events) return;
    this.current = current;
    this.list.forEach(({button, event}, i) => {
      button.classList.toggle("past", i < current);
      const now = current >= 0 && event.time === this.list[current].event.time;
      button.classList.toggle("current", now);
      if (now) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    });
    const pane = byId("pane-events");
    const button = this.list[Math.max(current, 0)]?.button;
    if (button && !pane.hidden) pane.scrollTop = button.offsetTop - pane.offsetTop - pane.clientHeight / 2;
  }

  tellCursor() {
    const {flight, cursor, chosen} = this.state;
    const {model} = flight;
    const section = (title, items) => make("div", "", make("h2", "", title), make("ul", "", ...items));
    const goals = (flight.goals.at(cursor) ?? []).map(([c, mode, by]) => {
      const place = placeOf(model, by);
      return make("li", "", model.components[c].name + " = " + model.components[c].modes[mode] + " ", place ? make("span", "place", place) : null);
    });
    for (const [text, by] of flight.constraints.at(cursor) ?? []) {
      const place = placeOf(model, by);
      goals.push(make("li", "", text + " ", place ? make("span", "place", place) : null));
    }
    const commands = flight.commands.map((track, i) => [model.controls[i], track.at(cursor)])
      .filter(([control, value]) => value !== undefined && value !== control.idle)
      .map(([control, value]) => make("li", "", control.name + " = " + control.values[value]));
    const [outcome, why] = flight.why.at(cursor) ?? [];
    if (outcome === "wait") commands.push(make("li", "", "waits"));
    if (outcome === "no-plan") commands.push(make("li", "bad", "no plan"));
    if (why) commands.push(make("li", "why", why));
    const nothing = () => [make("li", "quiet", "nothing")];
    const parts = [];
    if (model.locations) parts.push(section("asserted", goals.length ? goals : nothing()));
    parts.push(section("commanded", commands.length ? commands : nothing()), section("in doubt, or amiss", this.doubts()));
    if (chosen >= 0) parts.push(this.component(chosen));
    byId("pane-cursor").replaceChildren(make("div", "columns", ...parts));
  }

  /** Faults, what is estimated wrongly, and what is believed with less than all. */
  doubts() {
    const {flight, cursor} = this.state;
    const items = [];
    flight.model.components.forEach((component, c) => {
      const mode = flight.modes[c]?.at(cursor);
      if (mode === undefined) return;
      const truth = flight.estimated ? flight.truth[c]?.at(cursor) : undefined;
      const differs = truth !== undefined && truth !== mode;
      const shares = flight.belief[c]?.at(cursor) ?? [];
      const at = shares.findIndex((m, k) => k % 2 === 0 && m === mode);
      if (!isFault(component, mode) && !differs && shares.length === 0) return;
      const item = make("li", isFault(component, mode) ? "bad" : "", component.name + " = " + component.modes[mode]);
      if (shares.length) item.append(make("span", "quiet", " " + (at < 0 ? 0 : shares[at + 1]) + " %"));
      if (differs) item.append(make("span", "warn", " \u2013 in truth " + component.modes[truth]));
      items.push(item);
    });
    for (const event of flight.events) {
      if (event.to === undefined || event.from > cursor || event.to <= cursor || !isSevere(event)) continue;
      items.push(make("li", "bad", event.kind + ": " + event.text));
    }
    return items.length ? items : [make("li", "quiet", "nothing")];
  }

  component(c) {
    const {flight, cursor} = this.state;
    const {model} = flight;
    const component = model.components[c];
    const items = [];
    const mode = flight.modes[c]?.at(cursor);
    const shares = flight.belief[c]?.at(cursor) ?? [];
    const listed = shares.length ? shares : mode === undefined ? [] : [mode, 100];
    if (flight.estimated) {
      for (let k = 0; k < listed.length; k += 2) {
        const bar = make("i");
        bar.style.width = listed[k + 1] + "%";
        items.push(make("li", "share" + (isFault(component, listed[k]) ? " fault" : ""), make("span", "", component.modes[listed[k]]), bar, make("b", "", listed[k + 1] + " %")));
      }
    } else if (mode !== undefined) {
      items.push(make("li", "", component.modes[mode]));
    }
    const truth = flight.estimated ? flight.truth[c]?.at(cursor) : undefined;
    if (truth !== undefined) items.push(make("li", "quiet", "in truth " + component.modes[truth]));
    for (const row of channelRows(flight, c)) {
      const span = row.at(cursor);
      if (span) items.push(make("li", "", "channel " + row.label + " says " + span.text));
    }
    model.observables.forEach((variable, i) => {
      const value = flight.readings[i]?.at(cursor);
      if (ownerOf(model, variable.name) !== c || value === undefined) return;
      items.push(make("li", "", variable.name.slice(component.name.length + 1) + " reads " + (value < 0 ? "nothing" : variable.values[value])));
    });
    return make("div", "", make("h2", "", component.name + " : " + component.type), make("ul", "", ...items));
  }
}

/** Tabs by click and by arrow keys, as the pattern of ARIA has it. */
function listenToTabs(list, chosen) {
  const tabs = [...list.querySelectorAll('[role="tab"]')];
  const choose = (tab, focus) => {
    for (const other of tabs) {
      const on = other === tab;
      other.setAttribute("aria-selected", on);
      other.tabIndex = on ? 0 : -1;
      byId(other.getAttribute("aria-controls")).hidden = !on;
    }
    if (focus) tab.focus();
    chosen();
  };
  list.addEventListener("click", (event) => {
    const tab = event.target.closest('[role="tab"]');
    if (tab) choose(tab);
  });
  list.addEventListener("keydown", (event) => {
    const move = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    const visible = tabs.filter((tab) => !tab.hidden);
    const at = visible.indexOf(document.activeElement);
    if (!move || at < 0) return;
    choose(visible[(at + move + visible.length) % visible.length], true);
    event.preventDefault();
    event.stopPropagation();
  });
  return (id) => choose(byId(id));
}
