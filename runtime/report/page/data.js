// The data of the report, and what was when.
"use strict";

const report = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);

/** A thing over time: times ascending, and its value from each on. */
class Track {
  constructor(flat) {
    this.times = [];
    this.values = [];
    for (let i = 0; i < flat.length; i += 2) {
      this.times.push(flat[i]);
      this.values.push(flat[i + 1]);
    }
  }
  /** Position of the last change up to a time; -1 before the first. */
  find(time) {
    const late = time + 5e-10 + time * 4e-16;  // times are whole nanoseconds, that a sum of floats may just miss
    let low = 0, high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= late) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  at(time) {
    return this.values[this.find(time)];
  }
  /** Whether there is more than one value. */
  get changes() {
    return this.times.length > 1;
  }
  get length() {
    return this.times.length;
  }
}

/** A flight, its tracks made of the flat lists. */
function flightOf(index) {
  const raw = report.flights[index];
  const model = report.models[raw.model];
  const tracks = (list) => list.map((flat) => new Track(flat));
  const flight = {
    ...raw,
    model,
    truth: tracks(raw.truth),
    estimate: tracks(raw.estimate),
    belief: tracks(raw.belief),
    commands: tracks(raw.commands),
    readings: tracks(raw.readings),
    channels: (raw.channels ?? []).map((channel) => ({...channel, samples: new Track(channel.samples)})),
    marking: new Track(raw.marking),
    goals: new Track(raw.goals),
    constraints: new Track(raw.constraints),  // what goals ask besides modes: text, location
    setAside: new Track(raw.setAside),        // readings that did not count
    why: new Track(raw.why),
  };
  flight.modes = flight.estimate.length ? flight.estimate : flight.truth;  // what a component's row is about
  flight.estimated = flight.estimate.length > 0;
  return flight;
}

const isFault = (component, mode) => component.faults.includes(mode);

/** The component that a variable belongs to by its name, `component.attribute`. */
function ownerOf(model, name) {
  const path = name.slice(0, name.lastIndexOf("."));
  return model.components.findIndex((c) => c.name === path);
}

/** An element with a class and texts or elements inside. */
function make(tag, className, ...inside) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...inside.filter((part) => part !== null && part !== undefined && part !== ""));
  return element;
}
