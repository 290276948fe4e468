// Small plants that the tests of estimation share, built by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime::test {

/// Writes a plant down, names instead of positions.
class PlantWriter {
 public:
  struct ModeLine {
    std::string name;
    bool fault = false;
    automata::Formula constraint = automata::constant(true);
  };

  automata::VariableId variable(const std::string& name, std::vector<std::string> values) {
    return plant.variables.add({name, std::move(values)});
  }
  automata::VariableId control(const std::string& name, std::vector<std::string> values) {
    const auto id = variable(name, std::move(values));
    plant.controls.push_back({id, automata::ValueId(0)});
    return id;
  }
  automata::VariableId observable(const std::string& name, std::vector<std::string> values) {
    const auto id = variable(name, std::move(values));
    plant.observables.push_back(id);
    return id;
  }
  /// A component that starts in its first mode.
  automata::ComponentId component(const std::string& name, std::vector<ModeLine> modes) {
    automata::Component component;
    component.name = name;
    std::vector<std::string> names;
    for (ModeLine& mode : modes) {
      names.push_back(mode.name);
      component.modes.push_back({mode.name, mode.fault, std::move(mode.constraint), 0, {}});
    }
    component.mode = variable(name, names);
    component.initial.assign(names.size(), 0.0);
    component.initial[0] = 1;
    plant.components.push_back(std::move(component));
    return automata::ComponentId(plant.components.size() - 1);
  }
  automata::Transition& transition(automata::ComponentId id, const std::string& from, const std::string& to) {
    automata::Component& component = plant.components[id.index()];
    automata::Transition t;
    t.from = mode(id, from);
    t.to = mode(id, to);
    t.branch = static_cast<std::uint32_t>(component.transitions.size());
    component.transitions.push_back(t);
    return component.transitions.back();
  }
  /// A fault transition from every mode but the target, or from every nominal mode.
  void fault(automata::ComponentId id, const std::string& to, double probability, bool nominal_only = false) {
    for (std::size_t m = 0; m < plant.components[id.index()].modes.size(); ++m) {
      const automata::Mode source = plant.components[id.index()].modes[m];
      if (source.name == to || (nominal_only && source.fault)) continue;
      transition(id, source.name, to).weight = {automata::Weight::Kind::probability, probability};
    }
  }
  [[nodiscard]] automata::ModeId mode(automata::ComponentId id, const std::string& name) const {
    const automata::VariableId variable = plant[id].mode;
    return automata::ModeId(plant.variables[variable].find(name)->index());
  }
  [[nodiscard]] automata::Assignment assignment(const std::string& variable, const std::string& value) const {
    const auto id = *plant.variables.find(variable);
    return {id, *plant.variables[id].find(value)};
  }
  [[nodiscard]] automata::Formula is(const std::string& variable, const std::string& value) const {
    const automata::Assignment a = assignment(variable, value);
    return automata::is(a.variable, a.value);
  }
  [[nodiscard]] automata::ControlAction command(const std::string& variable, const std::string& value) const {
    return automata::action_from(plant, std::vector{assignment(variable, value)});
  }

  automata::Plant plant;
};

inline automata::Timing uniform(double lower, double upper) {
  return {*automata::ticks_from_seconds(lower), *automata::ticks_from_seconds(upper), {}};
}

inline automata::Ticks at(double seconds) { return *automata::ticks_from_seconds(seconds); }

/// The engine of Fig. 6-5 with a failure probability of 0.001; `temp` is seen, and tells standby from heating.
inline PlantWriter engine() {
  PlantWriter w;
  w.control("cmd", {"none", "standby", "fire", "off"});
  w.observable("temp", {"low", "nominal"});
  const auto e = w.component("engine", {{"off", false, w.is("temp", "low")},
                                        {"heating"},
                                        {"standby", false, w.is("temp", "nominal")},
                                        {"firing"},
                                        {"failed", true}});
  w.transition(e, "off", "heating").guard = w.is("cmd", "standby");
  w.transition(e, "heating", "off").guard = w.is("cmd", "off");
  auto& heated = w.transition(e, "heating", "standby");
  heated.guard = automata::negation(w.is("cmd", "off"));
  heated.timing = uniform(30, 60);
  w.transition(e, "standby", "firing").guard = w.is("cmd", "fire");
  w.transition(e, "standby", "off").guard = w.is("cmd", "off");
  w.transition(e, "firing", "off").guard = w.is("cmd", "off");
  w.fault(e, "failed", 0.001);
  return w;
}

/// `count` switches in a row, each passing its input on while it is on; a switch may stick in `open` or `closed`, or
/// fail so that nothing is known. Seen are the ends of the chain; one control closes all switches.
inline PlantWriter chain(std::size_t count) {
  PlantWriter w;
  w.control("cmd", {"none", "close"});
  std::vector<std::string> wires;
  for (std::size_t i = 0; i <= count; ++i) {
    wires.push_back("wire" + std::to_string(i));
    w.observable(wires.back(), {"zero", "one"});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto zero = w.is(wires[i + 1], "zero");
    const auto same = automata::equivalence(w.is(wires[i], "one"), w.is(wires[i + 1], "one"));
    const auto s = w.component("switch" + std::to_string(i), {{"opened", false, zero},
                                                              {"closing", false, zero},
                                                              {"closed", false, same},
                                                              {"stuck_open", true, zero},
                                                              {"failed", true}});
    w.transition(s, "opened", "closing").guard = w.is("cmd", "close");
    w.transition(s, "closing", "closed").timing = uniform(1 + static_cast<double>(i), 4 + static_cast<double>(i));
    w.fault(s, "stuck_open", 0.01 * static_cast<double>(i + 1), true);
    w.fault(s, "failed", 0.002);
  }
  return w;
}

/// The probability of a plant state, summed over clocks.
inline double probability(const Belief& belief, const automata::Modes& modes) {
  double sum = 0;
  for (const BeliefEntry& entry : belief) sum += entry.state.modes == modes ? entry.probability : 0.0;
  return sum;
}

}  // namespace rmpl::runtime::test
