// A witness as a scenario.
// SPDX-License-Identifier: MIT
#include "verifier/export/witness_scenario.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Formula;
using automata::Modes;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;
using Kind = ProgramProperty::Kind;

namespace {

/// What each sensor reads; one that is silent is absent.
using Readings = std::map<VariableId, ValueId>;

class Writer {
 public:
  Writer(automata::PlantStep& step, const ProgramProperty& property, const Witness& witness, const ScenarioFrame& frame)
      : step_(step), plant_(step.plant()), property_(property), witness_(witness), frame_(frame) {}

  /// Whether what is never to hold can be seen to hold in the end.
  bool shows() {
    if (property_.kind != Kind::never) return true;
    if (has_knowledge(property_.formula)) return false;  // what a flight knows is not the truth
    const std::vector<Event>& events = witness_.events;
    const Modes& modes = events[events.size() - 2].modes;
    std::vector<Assignment> store = automata::assignments_of(plant_, modes);
    for (const auto& [sensor, value] : readings(modes, {}, true)) store.push_back({sensor, value});
    return step_.theory().entails(store, step_.theory().encode(property_.formula));
  }

  std::string write() {
    std::string text = "// Written by tcca-check: " + std::string(name_of(property_.kind)) +
                       " is violated, with the estimate taken as the truth.\n" + doubt() + "\nscenario \"" +
                       frame_.name + "\" {\n";
    text += "  program \"" + frame_.program + "\"" + (frame_.entry.empty() ? "" : " main " + frame_.entry) + ";\n";
    text += "  plant   \"" + frame_.plant + "\" rules only;\n";
    text += "  cycle   " + automata::format_seconds(frame_.cycle) + " s;\n";
    text += "  duration " + automata::format_seconds(duration()) + " s;\n\n";
    text += observations() + "\n" + expectation() + "}\n";
    return text;
  }

 private:
  /// A flight reads its sensors at the end of the first cycle for the first time.
  [[nodiscard]] std::string doubt() const {
    if (starts_likely(plant_, witness_)) return "";
    return "// The witness does not start in the most likely initial modes, but a flight assumes them in its first "
           "cycle.\n";
  }

  /// A few cycles longer than the trace: what does not come is missed when the run is over.
  [[nodiscard]] Ticks duration() const {
    const std::int64_t after = is_about_patience(property_) ? frame_.patience : 4;
    return witness_.events.back().time + Ticks{after * frame_.cycle.count};
  }

  /// How long it takes to go round once; 0 where the run does not.
  [[nodiscard]] Ticks round() const {
    const std::vector<Event>& events = witness_.events;
    if (!witness_.repeats_from) return Ticks{0};
    return events[events.size() - 2].time - events[*witness_.repeats_from - 1].time;
  }

  std::string observations() {
    const std::vector<Event>& events = witness_.events;
    // From when on there is which set of readings.
    std::vector<std::pair<Ticks, Readings>> changes = {
        {Ticks{0}, readings(events.front().modes, {}, events.size() == 2)}};
    const Modes* before = &events.front().modes;
    const auto see = [&](const Event& event, Ticks later, bool last) {
      if (event.modes == *before && !last) return;
      changes.emplace_back(event.time + later, readings(event.modes, changes.back().second, last));
      before = &event.modes;
    };
    // What the last cycle leads to is not known.
    for (std::size_t e = 1; e + 1 < events.size(); ++e) see(events[e], Ticks{0}, e + 2 == events.size());
    for (Ticks later = round(); Ticks{0} < later && events.back().time + later < duration() + round();
         later += round()) {
      for (std::size_t e = *witness_.repeats_from; e + 1 < events.size(); ++e) see(events[e], later, false);
    }
    std::string text;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const auto& [time, now] = changes[i];
      for (const auto& reading : now) {
        const VariableId sensor = reading.first;
        const ValueId value = reading.second;
        if (i > 0 && reads(changes[i - 1].second, sensor) == value) continue;
        text += "  at " + automata::format_seconds(time) + " s observe " + text_of({sensor, value});
        // Until it falls silent; another reading replaces it anyway.
        const auto silent = std::find_if(changes.begin() + static_cast<std::ptrdiff_t>(i), changes.end(),
                                         [&](const auto& c) { return reads(c.second, sensor) != value; });
        if (silent != changes.end() && !reads(silent->second, sensor)) {
          text += " for " + automata::format_seconds(silent->first - time) + " s";
        }
        text += ";\n";
      }
    }
    return text;
  }

  static std::optional<ValueId> reads(const Readings& readings, VariableId sensor) {
    const auto at = readings.find(sensor);
    return at == readings.end() ? std::nullopt : std::optional(at->second);
  }

  /// What the sensors read in a state. Those that the modes leave open: as before where that can be.
  Readings readings(const Modes& modes, const Readings& before, bool last) {
    std::vector<Assignment> store = automata::assignments_of(plant_, modes);
    std::vector<std::vector<Assignment>> alternatives = others(modes);
    const bool shown = last && property_.kind == Kind::never;
    const std::vector<VariableId> asked = shown ? automata::variables_of(property_.formula) : std::vector<VariableId>{};
    const Formula wanted = shown ? property_.formula : automata::constant(true);
    const automata::Theory::Handle handle = step_.theory().encode(wanted);
    Readings result;
    for (const VariableId sensor : plant_.observables) {
      std::vector<ValueId> candidates;
      for (std::size_t v = 0; v < plant_.variables[sensor].values.size(); ++v) {
        store.push_back({sensor, ValueId(v)});
        if (step_.theory().allows(store, handle)) candidates.emplace_back(v);
        store.pop_back();
      }
      if (candidates.empty()) continue;
      const auto most = std::max_element(candidates.begin(), candidates.end(), [&](ValueId a, ValueId b) {
        return refuted(alternatives, {sensor, a}) < refuted(alternatives, {sensor, b});
      });
      ValueId chosen = *most;
      if (refuted(alternatives, {sensor, chosen}) == 0 && candidates.size() > 1) {
        const auto known = before.find(sensor);
        const bool stays =
            known != before.end() && std::find(candidates.begin(), candidates.end(), known->second) != candidates.end();
        if (!stays && std::find(asked.begin(), asked.end(), sensor) == asked.end()) continue;
        if (stays) chosen = known->second;
      }
      result.emplace(sensor, chosen);
      store.push_back({sensor, chosen});
      for (auto& alternative : alternatives) alternative.push_back({sensor, chosen});
    }
    return result;
  }

  /// The states in which one component is not in its fault mode, but in another mode.
  [[nodiscard]] std::vector<std::vector<Assignment>> others(const Modes& modes) const {
    std::vector<std::vector<Assignment>> result;
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const auto& all = plant_.components[c].modes;
      if (!all[modes[c].index()].fault) continue;
      for (std::size_t m = 0; m < all.size(); ++m) {
        Modes other = modes;
        other[c] = automata::ModeId(m);
        if (m != modes[c].index()) result.push_back(automata::assignments_of(plant_, other));
      }
    }
    return result;
  }

  /// How many of the alternatives that are still possible a reading rules out.
  std::size_t refuted(const std::vector<std::vector<Assignment>>& alternatives, Assignment reading) {
    return static_cast<std::size_t>(
        std::count_if(alternatives.begin(), alternatives.end(), [&](std::vector<Assignment> alternative) {
          if (!step_.theory().consistent(alternative)) return false;
          alternative.push_back(reading);
          return !step_.theory().consistent(alternative);
        }));
  }

  [[nodiscard]] std::string text_of(Assignment a) const { return to_text(plant_.variables, a); }

  [[nodiscard]] std::string expectation() const {
    switch (property_.kind) {
      case Kind::goal_conflict:
      case Kind::no_plan:
        return "  expect never " + std::string(name_of(property_.kind)) + ";\n";
      case Kind::endless_wait:
      case Kind::termination:
      case Kind::stuck:
        return "  expect finished;\n";
      case Kind::undone:
      case Kind::response:
        break;
      case Kind::never:
        return "  expect never " + property_.text + ";\n";
      case Kind::eventually:
        if (property_.within.is_infinite()) return "  expect " + property_.text + ";\n";
        return "  expect " + property_.text + " within " + automata::format_seconds(property_.within) + " s;\n";
      case Kind::finally:
        return "  expect finished with " + property_.text + ";\n";
    }
    return "";
  }

  automata::PlantStep& step_;
  const automata::Plant& plant_;
  const ProgramProperty& property_;
  const Witness& witness_;
  const ScenarioFrame& frame_;
};

}  // namespace

bool is_about_patience(const ProgramProperty& property) {
  const bool some_day = property.kind == Kind::eventually && property.within.is_infinite();
  return property.kind == Kind::endless_wait || property.kind == Kind::termination || some_day;
}

bool starts_likely(const automata::Plant& plant, const Witness& witness) {
  const Modes& modes = witness.events.front().modes;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const std::vector<double>& initial = plant.components[c].initial;
    if (initial[modes[c].index()] < *std::max_element(initial.begin(), initial.end())) return false;
  }
  return true;
}

std::optional<std::string> no_scenario(automata::PlantStep& step, const ProgramProperty& property,
                                       const Witness& witness) {
  if (witness.stop) return "a flight always continues, so it cannot show a deadlock or a timelock";
  if (automata::speaks_of_control(step.plant(), property.formula)) {
    return "'" + property.text +
           "' is about a control: the check leaves unconstrained controls free, a flight fixes them";
  }
  if (property.kind == Kind::response) return "scenarios have no expectation for a response";
  if (property.kind == Kind::undone) return "scenarios have no expectation for an undone goal";
  if (Writer(step, property, witness, {}).shows()) return std::nullopt;
  return "no sensor shows that '" + property.text + "' holds, so the estimate of a flight cannot decide it";
}

std::string scenario_text(automata::PlantStep& step, const ProgramProperty& property, const Witness& witness,
                          const ScenarioFrame& frame) {
  return Writer(step, property, witness, frame).write();
}

}  // namespace rmpl::verifier
