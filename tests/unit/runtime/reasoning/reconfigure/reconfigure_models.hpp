// Plants that the tests of reconfiguration share: the thesis's propulsion example, an engine alone, the lander.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime::crafts {

using automata::Formula;

/// Builds a plant by names.
class Builder {
 public:
  struct ModeLine {
    std::string name;
    Formula constraint = automata::constant(true);
    double reward = 0;
    bool fault = false;
  };
  void variable(const std::string& name, std::vector<std::string> values) {
    plant.variables.add({name, std::move(values)});
  }
  void control(const std::string& name, std::vector<std::string> values) {
    variable(name, std::move(values));
    plant.controls.push_back({*plant.variables.find(name), automata::ValueId(0)});
  }
  void component(const std::string& name, const std::vector<ModeLine>& modes) {
    automata::Component component;
    component.name = component.type = name;
    std::vector<std::string> names;
    for (const ModeLine& m : modes) {
      names.push_back(m.name);
      component.modes.push_back({m.name, m.fault, m.constraint, m.reward, {}});
    }
    component.initial.assign(modes.size(), 0.0);
    component.initial[0] = 1;
    component.mode = plant.variables.add({name, std::move(names)});
    plant.components.push_back(std::move(component));
  }
  /// A transition of the component that was added last.
  void transition(const std::string& from, const std::string& to, Formula guard = automata::constant(true),
                  std::optional<std::pair<int, int>> seconds = {}, automata::Weight weight = {}) {
    automata::Component& c = plant.components.back();
    automata::Transition t{mode(c, from), mode(c, to), std::move(guard), {}, weight, next_branch_++, {}};
    if (seconds) {
      t.timing = automata::Timing{
          automata::Ticks::of_seconds(seconds->first), automata::Ticks::of_seconds(seconds->second), {}};
    }
    c.transitions.push_back(std::move(t));
  }
  void connect(Formula constraint) { plant.interconnections.push_back(std::move(constraint)); }

  [[nodiscard]] Formula is(const std::string& name, const std::string& value) const {
    const auto v = *plant.variables.find(name);
    return automata::is(v, *plant.variables[v].find(value));
  }
  [[nodiscard]] Formula same(const std::string& a, const std::string& b) const {
    return automata::equality(*plant.variables.find(a), *plant.variables.find(b));
  }

  automata::Plant plant;

 private:
  static automata::ModeId mode(const automata::Component& c, const std::string& name) {
    for (std::size_t m = 0; m < c.modes.size(); ++m) {
      if (c.modes[m].name == name) return automata::ModeId(m);
    }
    throw std::logic_error("no mode " + name);
  }
  std::uint32_t next_branch_ = 1;
};

/// A plant with its reconfigurer, asked and answering by names.
class Craft {
 public:
  explicit Craft(Builder builder)
      : names(std::move(builder)), step(names.plant), reconfigurer(make_reconfigurer(step)) {}

  [[nodiscard]] automata::Modes modes(const std::vector<std::string>& by_component) const {
    automata::Modes result;
    for (std::size_t c = 0; c < by_component.size(); ++c) {
      const auto& component = names.plant.components[c];
      result.emplace_back(names.plant.variables[component.mode].find(by_component[c])->index());
    }
    return result;
  }
  [[nodiscard]] std::vector<std::string> text(const automata::Modes& state) const {
    std::vector<std::string> result;
    for (const auto& a : assignments_of(names.plant, state)) result.push_back(names.plant.variables.value(a));
    return result;
  }
  /// The values that are off idle, `wait` where none is.
  [[nodiscard]] std::string text(const automata::ControlAction& action) const {
    std::string result;
    for (const auto& a : commanded(names.plant, action)) {
      result += (result.empty() ? "" : " ") + names.plant.variables.value(a);
    }
    return result.empty() ? "wait" : result;
  }
  [[nodiscard]] std::vector<std::string> text(const std::vector<automata::ControlAction>& commands) const {
    std::vector<std::string> result;
    for (const auto& action : commands) result.push_back(text(action));
    return result;
  }
  Reconfiguration next(const std::vector<std::string>& from, const Formula& goal) {
    return reconfigurer->next(modes(from), goal);
  }
  Plan plan(const std::vector<std::string>& from, const Formula& goal) {
    return make_plan(names.plant, *reconfigurer, modes(from), goal);
  }
  [[nodiscard]] Formula is(const std::string& name, const std::string& value) const { return names.is(name, value); }

  Builder names;
  automata::PlantStep step;
  std::unique_ptr<Reconfigurer> reconfigurer;
};

inline const std::vector<std::string> pde_commands{
    "none", "on", "off", "reset", "standbyEngine", "offEngine", "fireEngine", "open1", "close1", "open2", "close2"};

/// Components in order: pde, valve1, valve2, tank1, tank2, engine (Fig. 6-14, 6-15, commanded through the pde alone).
inline Builder propulsion() {
  Builder b;
  b.control("pde.cmd", pde_commands);
  b.variable("pde.out", pde_commands);
  const std::vector<std::string> pressure{"low", "high"};
  for (const char* n : {"1", "2"}) {
    b.variable(std::string("valve") + n + ".cmd", {"none", "open", "close"});
    b.variable(std::string("valve") + n + ".inlet", pressure);
    b.variable(std::string("valve") + n + ".outlet", pressure);
  }
  b.variable("engine.cmd", {"none", "standby", "off", "fire"});
  b.variable("engine.fuel", pressure);
  b.variable("engine.oxidizer", pressure);
  b.variable("engine.thrust", {"zero", "full"});

  b.component("pde", {{"off", b.is("pde.out", "none")},
                      {"on", b.same("pde.out", "pde.cmd"), -2},
                      {"resettable", b.is("pde.out", "none"), -10, true},
                      {"failed", automata::constant(true), -20, true}});
  b.transition("off", "on", b.is("pde.cmd", "on"));
  b.transition("on", "off", b.is("pde.cmd", "off"));
  b.transition("resettable", "on", b.is("pde.cmd", "reset"));
  b.transition("resettable", "off", b.is("pde.cmd", "off"));
  for (const std::string n : {"1", "2"}) {
    const std::string valve = "valve" + n;
    b.component(valve, {{"closed", b.is(valve + ".outlet", "low")},
                        {"open", b.same(valve + ".outlet", valve + ".inlet"), -5},
                        {"stuck-open", b.same(valve + ".outlet", valve + ".inlet"), -20, true},
                        {"stuck-closed", b.is(valve + ".outlet", "low"), -10, true}});
    b.transition("closed", "open", b.is(valve + ".cmd", "open"));
    b.transition("open", "closed", b.is(valve + ".cmd", "close"));
    b.connect(equivalence(b.is("pde.out", "open" + n), b.is(valve + ".cmd", "open")));
    b.connect(equivalence(b.is("pde.out", "close" + n), b.is(valve + ".cmd", "close")));
  }
  for (const std::string n : {"1", "2"}) {
    b.component("tank" + n, {{"full", b.is("valve" + n + ".inlet", "high")},
                             {"empty", b.is("valve" + n + ".inlet", "low"), -20, true}});
  }
  b.component("engine", {{"off", b.is("engine.thrust", "zero")},
                         {"heating", b.is("engine.thrust", "zero")},
                         {"standby", b.is("engine.thrust", "zero")},
                         {"firing", automata::conjunction({b.is("engine.thrust", "full"), b.is("engine.fuel", "high"),
                                                           b.is("engine.oxidizer", "high")})},
                         {"failed", automata::constant(true), -20, true}});
  b.transition("off", "heating", b.is("engine.cmd", "standby"));
  b.transition("heating", "off", b.is("engine.cmd", "off"));
  b.transition("heating", "standby", negation(b.is("engine.cmd", "off")), std::pair{30, 60});
  b.transition("standby", "off", b.is("engine.cmd", "off"));
  b.transition("standby", "firing",
               automata::conjunction(
                   {b.is("engine.cmd", "fire"), b.is("engine.fuel", "high"), b.is("engine.oxidizer", "high")}));
  b.transition("firing", "standby", b.is("engine.cmd", "standby"));
  b.connect(b.same("valve1.outlet", "engine.fuel"));
  b.connect(b.same("valve2.outlet", "engine.oxidizer"));
  b.connect(equivalence(b.is("pde.out", "standbyEngine"), b.is("engine.cmd", "standby")));
  b.connect(equivalence(b.is("pde.out", "offEngine"), b.is("engine.cmd", "off")));
  b.connect(equivalence(b.is("pde.out", "fireEngine"), b.is("engine.cmd", "fire")));
  return b;
}

/// Components in order: valve1, valve2, engine, all commanded directly: the engine of Table 6.2.
inline Builder bare_engine() {
  Builder b;
  b.control("ecmd", {"none", "standby", "fire", "off"});
  for (const std::string valve : {"valve1", "valve2"}) {
    b.control(valve + ".cmd", {"none", "open", "close"});
    b.variable(valve + ".flow", {"zero", "some"});
    b.component(valve, {{"closed", b.is(valve + ".flow", "zero")}, {"open", b.is(valve + ".flow", "some")}});
    b.transition("closed", "open", b.is(valve + ".cmd", "open"));
    b.transition("open", "closed", b.is(valve + ".cmd", "close"));
  }
  b.component("engine",
              {{"off"}, {"heating"}, {"standby"}, {"firing"}, {"failed", automata::constant(true), -20, true}});
  b.transition("off", "heating", b.is("ecmd", "standby"));
  b.transition("heating", "off", b.is("ecmd", "off"));
  b.transition("heating", "standby", automata::constant(true), std::pair{30, 60});
  b.transition("standby", "off", b.is("ecmd", "off"));
  b.transition("standby", "firing",
               automata::conjunction({b.is("ecmd", "fire"), b.is("valve1.flow", "some"), b.is("valve2.flow", "some")}));
  b.transition("firing", "standby", b.is("ecmd", "standby"));
  b.transition("off", "failed", automata::constant(true), {}, {automata::Weight::Kind::probability, 0.001});
  return b;
}

/// Components in order: att, lander (Fig. 3-3).
inline Builder lander() {
  Builder b;
  b.control("att.cmd", {"none", "to-entry", "to-cruise"});
  b.control("lander.cmd", {"none", "fire-primary", "fire-backup"});
  b.variable("lander.contact", {"made", "broken"});
  b.component("att", {{"cruise"}, {"slewing"}, {"entry"}});
  b.transition("cruise", "slewing", b.is("att.cmd", "to-entry"));
  b.transition("slewing", "entry", automata::constant(true), std::pair{0, 300});
  b.transition("entry", "cruise", b.is("att.cmd", "to-cruise"));
  b.component("lander", {{"connected", b.is("lander.contact", "made")},
                         {"separated", b.is("lander.contact", "broken"), 5},
                         {"unsuccessful-attempt", b.is("lander.contact", "made"), -10, true},
                         {"failed", automata::constant(true), -20, true}});
  b.transition("connected", "separated", b.is("lander.cmd", "fire-primary"));
  b.transition("connected", "unsuccessful-attempt", b.is("lander.cmd", "fire-primary"), {},
               {automata::Weight::Kind::probability, 0.01});
  b.transition("unsuccessful-attempt", "separated", b.is("lander.cmd", "fire-backup"));
  return b;
}

}  // namespace rmpl::runtime::crafts
