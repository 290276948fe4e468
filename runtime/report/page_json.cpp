// The data of a page: names once, then numbers. A track is a flat list of times and values.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "automata/place.hpp"
#include "base/check.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/report/page.hpp"

namespace rmpl::runtime {
namespace {

using automata::Variable;

template <class Value, class Write>
void write_track(JsonLine& json, const Track<Value>& track, const Write& write) {
  json.open('[');
  for (const Change<Value>& change : track.changes()) {
    json.seconds(change.time);
    write(change.value);
  }
  json.close(']');
}

template <class Value, class Write>
void write_tracks(JsonLine& json, std::string_view key, const std::vector<Track<Value>>& tracks, const Write& write) {
  json.key(key).open('[');
  for (const auto& track : tracks) write_track(json, track, write);
  json.close(']');
}

void write_variable(JsonLine& json, const Variable& variable) {
  json.key("name").string(variable.name).key("values").open('[');
  for (const std::string& value : variable.values) json.string(value);
  json.close(']');
}

void write_components(JsonLine& json, const automata::Plant& plant) {
  json.key("components").open('[');
  for (const automata::Component& component : plant.components) {
    json.open('{').key("name").string(component.name).key("type").string(component.type).key("modes").open('[');
    for (const automata::Mode& mode : component.modes) json.string(mode.name);
    json.close(']').key("faults").open('[');
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (component.modes[m].fault) json.number(m);
    }
    json.close(']').close('}');
  }
  json.close(']');
}

void write_program(JsonLine& json, const automata::Program& program) {
  json.key("program").string(program.name).key("locations").open('[');
  for (const automata::Location& location : program.locations) {
    json.open('{').key("label").string(location.label).key("composite").boolean(location.composite);
    if (location.parent) json.key("parent").number(location.parent->index());
    if (location.origin.line > 0) json.key("place").string(automata::short_place(location.origin));
    json.close('}');
  }
  json.close(']');
}

void write_model(JsonLine& json, const Model& model) {
  const automata::Plant& plant = *model.plant;
  json.open('{').key("plant").string(plant.name);
  write_components(json, plant);
  json.key("controls").open('[');
  for (const automata::Control& control : plant.controls) {
    json.open('{').key("idle").number(control.idle.index());
    write_variable(json, plant.variables[control.variable]);
    json.close('}');
  }
  json.close(']').key("observables").open('[');
  for (const automata::VariableId variable : plant.observables) {
    json.open('{');
    write_variable(json, plant.variables[variable]);
    json.close('}');
  }
  json.close(']');
  if (model.program != nullptr) write_program(json, *model.program);
  json.key("drawings").open('{').key("program").string(model.drawings.program);
  json.key("plant").string(model.drawings.plant).key("missing").string(model.drawings.missing);
  json.close('}').close('}');
}

void write_goals(JsonLine& json, const Flight& flight) {
  json.key("goals");
  write_track(json, flight.goals, [&](const std::vector<AssertedGoal>& goals) {
    json.open('[');
    for (const AssertedGoal& goal : goals) {
      const auto component = flight.plant->component_of(goal.goal.variable);
      CHECK(component && "a goal is about a mode");
      json.open('[').number(component->index()).number(goal.goal.value.index());
      if (goal.by) json.number(goal.by->index());
      json.close(']');
    }
    json.close(']');
  });
}

void write_constraints(JsonLine& json, const Flight& flight) {
  json.key("constraints");
  write_track(json, flight.constraints, [&](const std::vector<AssertedConstraint>& constraints) {
    json.open('[');
    for (const AssertedConstraint& constraint : constraints) {
      json.open('[').string(constraint.text);
      if (constraint.by) json.number(constraint.by->index());
      json.close(']');
    }
    json.close(']');
  });
  json.key("setAside");
  write_track(json, flight.set_aside, [&](const std::string& readings) { json.string(readings); });
}

void write_notes(JsonLine& json, const Flight& flight) {
  json.key("why");
  write_track(json, flight.explanations, [&](const Explanation& explanation) {
    json.open('[');
    if (!explanation.outcome.empty()) json.string(explanation.outcome).string(explanation.why);
    json.close(']');
  });
  json.key("events").open('[');
  for (const Happening& happening : flight.happenings) {
    json.open('{').key("kind").string(happening.kind).key("from").seconds(happening.from);
    if (happening.to) json.key("to").seconds(*happening.to);
    if (happening.component) json.key("component").number(happening.component->index());
    json.key("text").string(happening.text);
    if (happening.nominal) json.key("nominal").boolean(true);
    json.close('}');
  }
  json.close(']').key("asked").open('[');
  for (const Asked& asked : flight.asked) {
    json.open('{').key("text").string(asked.text).key("verdict").string(asked.verdict);
    if (asked.time) json.key("time").seconds(*asked.time);
    json.key("reason").string(asked.reason).key("evidence").string(asked.evidence).close('}');
  }
  json.close(']');
}

/// Limits by positions of observables and values; one that is open to a side has no number there.
void write_flown_channels(JsonLine& json, const Flight& flight) {
  const auto& observables = flight.plant->observables;
  const auto position = [&](automata::VariableId attribute) {
    return std::find(observables.begin(), observables.end(), attribute) - observables.begin();
  };
  json.key("channels").open('[');
  for (const FlownChannel& channel : flight.channels) {
    json.open('{').key("name").string(channel.name).key("attributes").open('[');
    for (const automata::VariableId attribute : channel.attributes) json.number(position(attribute));
    json.close(']').key("limits").open('[');
    for (const auto& [attribute, band] : channel.limits) {
      json.open('{').key("attribute").number(position(attribute)).key("value").number(band.value.index());
      if (std::isfinite(band.from)) json.key("from").number(band.from);
      if (std::isfinite(band.to)) json.key("to").number(band.to);
      json.close('}');
    }
    json.close(']').key("samples");
    write_track(json, channel.signal, [&](const Signal& signal) {
      if (signal.number) {
        json.number(*signal.number);
      } else {
        json.string(signal.text);
      }
    });
    json.close('}');
  }
  json.close(']');
}

void write_flight(JsonLine& json, const Flight& flight, const std::vector<Model>& models) {
  const auto model = std::find_if(models.begin(), models.end(), [&](const Model& m) {
    return m.plant == flight.plant && m.program == flight.program;
  });
  CHECK(model != models.end() && "every flight has its model");
  json.open('{').key("name").string(flight.name).key("model").number(model - models.begin());
  json.key("verdict").string(flight.verdict).key("summary").string(flight.summary);
  json.key("cycle").seconds(flight.cycle).key("end").seconds(flight.end);
  if (flight.seed) json.key("seed").string(std::to_string(*flight.seed));
  const auto index = [&](const auto& id) { json.number(id.index()); };
  write_tracks(json, "truth", flight.truth, index);
  write_tracks(json, "estimate", flight.estimate, index);
  write_tracks(json, "belief", flight.belief, [&](const Shares& shares) {
    json.open('[');
    for (const auto& [mode, percent] : shares) json.number(mode.index()).number(percent);
    json.close(']');
  });
  write_tracks(json, "commands", flight.commands, index);
  write_tracks(json, "readings", flight.readings, [&](const std::optional<automata::ValueId>& value) {
    if (value) {
      json.number(value->index());
    } else {
      json.number(-1);
    }
  });
  if (!flight.channels.empty()) write_flown_channels(json, flight);
  json.key("marking");
  write_track(json, flight.marking, [&](const automata::Marking& marking) {
    json.open('[');
    for (const automata::LocationId location : marking) json.number(location.index());
    json.close(']');
  });
  write_goals(json, flight);
  write_constraints(json, flight);
  write_notes(json, flight);
  json.close('}');
}

}  // namespace

std::string to_json(const Report& report) {
  JsonLine json;
  json.open('{').key("title").string(report.title).key("models").open('[');
  for (const Model& model : report.models) write_model(json, model);
  json.close(']').key("flights").open('[');
  for (const Flight& flight : report.flights) write_flight(json, flight, report.models);
  json.close(']').close('}');
  std::string text;
  for (const char c : json.text()) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace rmpl::runtime
