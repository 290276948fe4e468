// A heater that takes two seconds to warm up, may break, and is repaired by turning it off: a plant for small
// scenarios.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "automata/scenario.hpp"

namespace rmpl::runtime::heater {

using namespace rmpl::automata;

constexpr ComponentId component{std::size_t{0}};
constexpr VariableId mode{std::size_t{0}}, cmd{std::size_t{1}}, temp{std::size_t{2}};
constexpr ModeId off{std::size_t{0}}, heating{std::size_t{1}}, on{std::size_t{2}}, broken{std::size_t{3}};
constexpr ValueId none{std::size_t{0}}, turn_on{std::size_t{1}}, turn_off{std::size_t{2}};
constexpr ValueId low{std::size_t{0}}, high{std::size_t{1}};

inline Assignment in(ModeId m) { return {mode, ValueId(m.index())}; }

inline Mode make_mode(const std::string& name, bool fault, Formula constraint) {
  Mode result;
  result.name = name;
  result.fault = fault;
  result.constraint = std::move(constraint);
  return result;
}

inline Transition move(ModeId from, ModeId to, Formula guard) {
  Transition result;
  result.from = from;
  result.to = to;
  result.guard = std::move(guard);
  return result;
}

inline Plant plant() {
  Plant plant;
  plant.name = "house";
  plant.variables.add({"heater", {"off", "heating", "on", "broken"}});
  plant.variables.add({"heater.cmd", {"none", "on", "off"}});
  plant.variables.add({"heater.temp", {"low", "high"}});
  plant.controls.push_back({cmd, none});
  plant.observables.push_back(temp);
  Component heater;
  heater.name = "heater";
  heater.type = "Heater";
  heater.mode = mode;
  heater.modes = {make_mode("off", false, is(temp, low)), make_mode("heating", false, is(temp, low)),
                  make_mode("on", false, is(temp, high)), make_mode("broken", true, is(temp, low))};
  heater.initial = {1, 0, 0, 0};
  heater.transitions = {move(off, heating, is(cmd, turn_on)), move(heating, on, constant(true)),
                        move(on, off, is(cmd, turn_off)), move(broken, off, is(cmd, turn_off))};
  heater.transitions[1].timing = Timing{Ticks::of_seconds(2), Ticks::of_seconds(2), {}};
  for (const ModeId from : {off, heating, on}) {
    Transition fault = move(from, broken, constant(true));
    fault.weight = {Weight::Kind::rate, 1e-6};
    heater.transitions.push_back(fault);
  }
  for (std::size_t i = 0; i < heater.transitions.size(); ++i) {
    heater.transitions[i].branch = static_cast<std::uint32_t>(i);
  }
  plant.components.push_back(heater);
  return plant;
}

/// `heater = on`, then the end; with `hold`, for ever again.
inline Program program(bool hold = false) {
  Program program;
  program.name = "Warm";
  program.variables = plant().variables;
  program.locations.resize(2);
  program.locations[0].composite = true;
  program.locations[0].start = true;
  program.locations[1].parent = LocationId(0);
  program.locations[1].start = true;
  program.locations[1].goal = {in(on)};
  if (hold) program.locations[1].arcs.push_back({{}, LocationId(1)});
  return program;
}

inline Document document(bool hold = false) {
  Document document;
  document.plants.push_back(plant());
  document.programs.push_back(program(hold));
  return document;
}

inline Scenario scenario() {
  Scenario scenario;
  scenario.name = "warm up";
  scenario.duration = Ticks::of_seconds(20);
  return scenario;
}

inline Expectation expects(Expectation::Kind kind, Formula condition = constant(true)) {
  Expectation result;
  result.kind = kind;
  result.condition = std::move(condition);
  result.text = "…";
  return result;
}

}  // namespace rmpl::runtime::heater
