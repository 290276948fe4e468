// Small plants built in place, for the tests of the verifier.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/time/time.hpp"

namespace rmpl::verifier::test {

inline automata::Ticks seconds(std::int64_t s) { return automata::Ticks::of_seconds(s); }

inline automata::Timing within(std::int64_t lower, std::int64_t upper) { return {seconds(lower), seconds(upper), {}}; }

inline automata::Weight probability(double p) { return {automata::Weight::Kind::probability, p}; }
inline automata::Weight rate(double per_second) { return {automata::Weight::Kind::rate, per_second}; }

/// Writes a plant down piece by piece. Names of fault modes end in '!'.
class PlantBuilder {
 public:
  /// A control variable; its first value is idle.
  automata::VariableId control(const std::string& name, std::vector<std::string> values) {
    const auto id = variable(name, std::move(values));
    plant.controls.push_back({id, automata::ValueId(0)});
    return id;
  }
  automata::VariableId variable(const std::string& name, std::vector<std::string> values) {
    return plant.variables.add({name, std::move(values)});
  }
  /// A component that starts in its first mode.
  automata::Component& component(const std::string& name, const std::vector<std::string>& modes) {
    automata::Component c;
    c.name = c.type = name;
    for (const std::string& mode : modes) {
      const bool fault = mode.back() == '!';
      c.modes.push_back({fault ? mode.substr(0, mode.size() - 1) : mode, fault, automata::constant(true), 0, {}});
      c.initial.push_back(c.modes.size() == 1 ? 1 : 0);
    }
    std::vector<std::string> values;
    for (const automata::Mode& mode : c.modes) values.push_back(mode.name);
    c.mode = variable(name, values);
    plant.components.push_back(std::move(c));
    return plant.components.back();
  }
  static void transition(automata::Component& c, std::size_t from, std::size_t to,
                         automata::Formula guard = automata::constant(true),
                         std::optional<automata::Timing> timing = std::nullopt, automata::Weight weight = {}) {
    const auto branch = static_cast<std::uint32_t>(c.transitions.size());
    c.transitions.push_back(
        {automata::ModeId(from), automata::ModeId(to), std::move(guard), timing, weight, branch, {}});
  }
  [[nodiscard]] automata::Formula is(const std::string& name, const std::string& value) const {
    const auto id = plant.variables.find(name).value();
    return automata::is(id, plant.variables[id].find(value).value());
  }

  automata::Plant plant;
};

/// The engine of language.md: off, heating for 30 to 60 s, standby, firing; a fault.
inline PlantBuilder engine() {
  PlantBuilder b;
  b.control("cmd", {"none", "standby", "fire", "off"});
  auto& e = b.component("engine", {"off", "heating", "standby", "firing", "failed!"});
  b.transition(e, 0, 1, b.is("cmd", "standby"));
  b.transition(e, 1, 0, b.is("cmd", "off"));
  b.transition(e, 1, 2, automata::negation(b.is("cmd", "off")), within(30, 60));
  b.transition(e, 2, 3, b.is("cmd", "fire"));
  b.transition(e, 2, 0, b.is("cmd", "off"));
  b.transition(e, 3, 0, b.is("cmd", "off"));
  for (std::size_t mode = 0; mode < 4; ++mode)
    b.transition(e, mode, 4, automata::constant(true), {}, probability(0.001));
  return b;
}

}  // namespace rmpl::verifier::test
