// The rows of the timeline: for each the spans that are drawn, and what it says at a time.

/** Spans of a track: {from, to, text, tone, share}; what `describe` gives null for is left open. */
function spansOf(track, end, describe) {
  const spans = [];
  track.times.forEach((from, i) => {
    const what = describe(track.values[i], from);
    const to = i + 1 < track.length ? track.times[i + 1] : end;
    if (what && (to > from || i + 1 === track.length)) spans.push({from, to, lasts: i + 1 === track.length, share: 1, ...what});
  });
  return spans;
}

/** The colour of a mode: faults are red, the first one is at rest, the others are told apart. */
function toneOf(component, mode) {
  if (isFault(component, mode)) return "fault";
  return mode === 0 ? "rest" : "m" + ((mode - 1) % 8);
}

function spanAt(spans, time) {
  const late = time + 5e-10 + time * 4e-16;
  for (let i = spans.length - 1; i >= 0; --i) {
    if (spans[i].from <= late) return late < spans[i].to || spans[i].lasts ? spans[i] : null;
  }
  return null;
}

/** Spans that are one but for the belief: {from, to, spans}. */
function runsOf(spans) {
  const runs = [];
  for (const span of spans) {
    if (!span.goesOn) runs.push({from: span.from, spans: []});
    const run = runs[runs.length - 1];
    run.to = span.to;
    run.spans.push(span);
  }
  return runs;
}

class Row {
  constructor(label, spans, more = {}) {
    Object.assign(this, {label, spans, component: -1, child: false, head: false, marks: null, under: null, children: [], open: false, curve: null}, more);
    this.runs = runsOf(spans);
  }
  at(time) {
    return spanAt(this.spans, time);
  }
}

function modeSpans(flight, track, c) {
  const component = flight.model.components[c];
  return spansOf(track, flight.end, (mode) => ({text: component.modes[mode], tone: toneOf(component, mode), mode}));
}

/** Estimated modes, cut where the belief changes, each as dark as it is believed. */
function believedSpans(flight, c) {
  const spans = modeSpans(flight, flight.modes[c], c);
  const belief = flight.belief[c];
  if (!belief || belief.length === 0) return spans;
  const cuts = [];
  for (const span of spans) {
    const times = [span.from, ...belief.times.filter((t) => t > span.from && t < span.to), span.to];
    for (let i = 0; i + 1 < times.length; ++i) {
      const shares = belief.at(times[i]) ?? [];
      const at = shares.findIndex((mode, k) => k % 2 === 0 && mode === span.mode);
      const share = shares.length === 0 ? 1 : at < 0 ? 0 : shares[at + 1] / 100;
      cuts.push({...span, from: times[i], to: times[i + 1], lasts: span.lasts && i + 2 === times.length, share, goesOn: i > 0});
    }
  }
  return cuts;
}

function variableRow(label, track, end, variable, idle) {
  return new Row(label, spansOf(track, end, (value) => {
    if (value < 0) return null;
    return value === idle ? null : {text: variable.values[value], tone: idle === undefined ? "m" + (value % 8) : "accent"};
  }), {child: true});
}

/** The rows below a component: its truth, belief, goals, commands and readings. */
function childrenOf(flight, c) {
  const {model} = flight;
  const component = model.components[c];
  const rows = [];
  const own = (name) => name.slice(component.name.length + 1);
  if (flight.estimated && flight.truth[c]) rows.push(new Row("truth", modeSpans(flight, flight.truth[c], c), {child: true, component: c}));
  const belief = flight.belief[c];
  if (belief?.length > 0) {
    component.modes.forEach((name, mode) => {
      const spans = spansOf(belief, flight.end, (shares) => {
        const at = shares.findIndex((m, k) => k % 2 === 0 && m === mode);
        return at < 0 ? null : {text: shares[at + 1] + " %", tone: toneOf(component, mode), share: shares[at + 1] / 100};
      });
      if (spans.length) rows.push(new Row("belief in " + name, spans, {child: true, component: c}));
    });
  }
  const goals = spansOf(flight.goals, flight.end, (list) => {
    const goal = list.find(([about]) => about === c);
    return goal ? {text: component.modes[goal[1]], tone: "warn"} : null;
  });
  if (goals.length) rows.push(new Row("goal", goals, {child: true, component: c}));
  model.controls.forEach((control, i) => {
    if (ownerOf(model, control.name) !== c) return;
    rows.push(Object.assign(variableRow(own(control.name), flight.commands[i], flight.end, control, control.idle), {component: c}));
  });
  model.observables.forEach((variable, i) => {
    if (ownerOf(model, variable.name) !== c || !flight.readings[i]) return;
    rows.push(Object.assign(variableRow(own(variable.name), flight.readings[i], flight.end, variable), {component: c}));
  });
  return rows;
}

/** What a sample of a channel says, with what is read then of its attributes. */
function sampleText(flight, channel, value, time) {
  const read = channel.attributes.map((i) => {
    const at = flight.readings[i]?.at(time) ?? -1;
    return at < 0 ? "no reading" : flight.model.observables[i].values[at];
  });
  return [String(value), ...read].join(" \u2013 ");
}

/** A channel of telemetry: its numbers as a line over the limits by which they are read, its texts as bars. */
function channelRow(flight, channel, component) {
  const {model} = flight;
  const spans = spansOf(channel.samples, flight.end, (value, from) => ({text: sampleText(flight, channel, value, from), tone: "m3", value}));
  const numbers = channel.samples.values.filter((value) => typeof value === "number");
  if (numbers.length === 0) return new Row(channel.name, spans, {component});
  const edges = channel.limits.flatMap(({from, to}) => [from, to]).filter((edge) => edge !== undefined);
  const all = [...numbers, ...edges];
  const least = all.reduce((a, b) => Math.min(a, b)), most = all.reduce((a, b) => Math.max(a, b));
  const room = (most - least) * 0.15 || Math.abs(most) * 0.15 || 1;  // beyond the outermost limit
  const limits = channel.limits.map(({attribute, value, from, to}) => ({from, to, text: model.observables[attribute].values[value], tone: "m" + (value % 8)}));
  return new Row(channel.name, spans, {component, curve: {low: least - room, high: most + room, edges: [...new Set(edges)], limits}});
}

/** The channels that are about a component, or about none. */
function channelRows(flight, component) {
  const owners = (channel) => channel.attributes.map((i) => ownerOf(flight.model, flight.model.observables[i].name));
  return flight.channels.filter((channel) => {
    const own = owners(channel);
    return component < 0 ? own.every((c) => c < 0) : own.find((c) => c >= 0) === component;
  }).map((channel) => channelRow(flight, channel, component));
}

function goalsRow(flight) {
  const {model} = flight;
  return new Row("goals", spansOf(flight.goals, flight.end, (goals) => goals.length
    ? {text: goals.map(([c, mode]) => model.components[c].name + " = " + model.components[c].modes[mode]).join(", "), tone: "warn"}
    : null), {head: true});
}

/** What goals ask besides modes. */
function constraintsRow(flight) {
  return new Row("goals besides modes", spansOf(flight.constraints, flight.end, (constraints) => constraints.length
    ? {text: constraints.map(([text]) => text).join(", "), tone: "warn"}
    : null), {head: true});
}

/** Readings that nothing explained, and that did not count. */
function setAsideRow(flight) {
  return new Row("set aside", spansOf(flight.setAside, flight.end, (text) => (text ? {text, tone: "fault", title: text} : null)), {head: true});
}

function commandsRow(flight) {
  const {model} = flight;
  const times = [...new Set(flight.commands.flatMap((track) => track.times))].sort((a, b) => a - b);
  const texts = times.map((time) => flight.commands
    .map((track, i) => [model.controls[i], track.at(time)])
    .filter(([control, value]) => value !== undefined && value !== control.idle)
    .map(([control, value]) => control.name + " = " + control.values[value]).join(", "));
  const track = {times, values: texts, length: times.length};
  return new Row("commands", spansOf(track, flight.end, (text) => (text ? {text, tone: "accent"} : null)), {head: true});
}

/** All rows of a flight; `quiet` ones never change, and are shown on demand. */
function rowsOf(flight, events) {
  const {model} = flight;
  const marks = events.filter((e) => e.severe || e.kind === "forced" || e.kind === "met");
  const spans = flight.events.filter((e) => e.to !== undefined && isSevere(e))
    .map((e) => ({from: e.from, to: e.to, text: "", tone: "fault", share: 0.25, title: e.text}));
  const rows = [new Row("events and verdicts", spans, {head: true, marks})];
  if (flight.goals.length) rows.push(goalsRow(flight));
  if (flight.constraints.values.some((constraints) => constraints.length)) rows.push(constraintsRow(flight));
  if (flight.commands.length) rows.push(commandsRow(flight));
  if (flight.setAside.values.some((text) => text)) rows.push(setAsideRow(flight));
  const goalOf = new Set(flight.goals.values.flat().map(([c]) => c));
  const blamed = new Set(flight.events.map((e) => e.component));
  const quiet = [];
  model.components.forEach((component, c) => {
    const row = new Row(component.name, believedSpans(flight, c), {component: c, children: childrenOf(flight, c)});
    if (flight.estimated && flight.truth[c]) row.under = modeSpans(flight, flight.truth[c], c);
    const telemetry = channelRows(flight, c);
    rows.push(...telemetry);  // above what is believed because of it
    const moves = telemetry.length || flight.modes[c].changes || flight.truth[c]?.changes || goalOf.has(c) || blamed.has(c) ||
      row.children.some((child) => child.spans.some((span) => span.tone === "accent"));
    (moves ? rows : quiet).push(row);
  });
  rows.push(...channelRows(flight, -1));
  const loose = [];
  model.controls.forEach((control, i) => {
    if (ownerOf(model, control.name) < 0 && flight.commands[i]) loose.push(variableRow(control.name, flight.commands[i], flight.end, control, control.idle));
  });
  model.observables.forEach((variable, i) => {
    if (ownerOf(model, variable.name) < 0 && flight.readings[i]) loose.push(variableRow(variable.name, flight.readings[i], flight.end, variable));
  });
  for (const row of loose) row.child = false;
  rows.push(...loose.filter((row) => row.spans.length > 1));
  quiet.push(...loose.filter((row) => row.spans.length <= 1));
  return {rows, quiet};
}
