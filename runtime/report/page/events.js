// What happens in a flight, in order: read off the tracks, so that nothing is told twice in the data.

const severe = new Set(["fault", "forced", "no-plan", "goal-conflict", "inconsistent", "failed"]);
/** Whether something is amiss; what a scenario forces into a nominal mode happens as planned. */
const isSevere = (event) => severe.has(event.kind) && !event.nominal;
const placeOf = (model, location) => model.locations?.[location]?.place ?? "";

/** All events of a flight: {time, kind, text, component, severe}. Kinds name what they are in the list. */
function eventsOf(flight) {
  const events = [];
  const {model} = flight;
  const add = (time, kind, text, component = -1, nominal = false) =>
    events.push({time, kind, text, component, severe: isSevere({kind, nominal}), order: events.length});
  addGoals(flight, add);
  addConstraints(flight, add);
  addCommands(flight, add);
  const told = new Set();  // diagnoses that come with their evidence
  for (const event of flight.events) {
    if (event.kind === "irreversible") continue;
    if (event.kind === "fault") told.add(event.component + "@" + event.from);
    add(event.from, event.kind, event.text, event.component ?? -1, event.nominal);
  }
  flight.modes.forEach((track, c) => {
    const component = model.components[c];
    for (let i = 1; i < track.length; ++i) {
      const fault = isFault(component, track.values[i]);
      if (fault && told.has(c + "@" + track.times[i])) continue;
      const text = component.name + ": " + component.modes[track.values[i - 1]] + " \u2192 " + component.modes[track.values[i]];
      add(track.times[i], fault ? "fault" : flight.estimated ? "estimate" : "mode", text, c);
    }
  });
  for (const asked of flight.asked) {
    if (asked.time === undefined || asked.verdict === "undecided") continue;
    add(asked.time, asked.verdict, asked.text + (asked.reason ? ": " + asked.reason : ""));
  }
  const rank = {goal: 2, command: 3, wait: 3};  // what a cycle ends with comes before what the next begins with
  return events.sort((a, b) => a.time - b.time || (rank[a.kind] ?? 1) - (rank[b.kind] ?? 1) || a.order - b.order);
}

function addGoals(flight, add) {
  const {model} = flight;
  const text = ([c, mode]) => model.components[c].name + " = " + model.components[c].modes[mode];
  let before = [];
  flight.goals.values.forEach((goals, i) => {
    const has = (list, goal) => list.some((other) => other[0] === goal[0] && other[1] === goal[1]);
    for (const goal of before) if (!has(goals, goal)) add(flight.goals.times[i], "goal", "\u2212 " + text(goal), goal[0]);
    for (const goal of goals) {
      if (has(before, goal)) continue;
      const place = placeOf(model, goal[2]);
      add(flight.goals.times[i], "goal", "+ " + text(goal) + (place ? " (" + place + ")" : ""), goal[0]);
    }
    before = goals;
  });
}

function addConstraints(flight, add) {
  let before = [];
  flight.constraints.values.forEach((constraints, i) => {
    const has = (list, text) => list.some(([other]) => other === text);
    for (const [text] of before) if (!has(constraints, text)) add(flight.constraints.times[i], "goal", "\u2212 " + text);
    for (const [text, by] of constraints) {
      if (has(before, text)) continue;
      const place = placeOf(flight.model, by);
      add(flight.constraints.times[i], "goal", "+ " + text + (place ? " (" + place + ")" : ""));
    }
    before = constraints;
  });
}

function addCommands(flight, add) {
  const {model} = flight;
  const times = new Map();
  flight.commands.forEach((track, i) => {
    track.values.forEach((value, k) => {
      if (value === model.controls[i].idle) return;
      const text = model.controls[i].name + " = " + model.controls[i].values[value];
      const at = times.get(track.times[k]) ?? {texts: [], component: ownerOf(model, model.controls[i].name)};
      at.texts.push(text);
      times.set(track.times[k], at);
    });
  });
  for (const [time, {texts, component}] of times) {
    const why = flight.why.at(time);
    add(time, "command", texts.join(", ") + (why?.[1] ? " " + why[1] : ""), component);
  }
  flight.why.values.forEach((why, i) => {
    if (why[0] === "wait") add(flight.why.times[i], "wait", why[1]);
  });
}
