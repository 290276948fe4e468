// A draw a cycle, of what is forced where that is possible.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/simulated_software.hpp"

#include <algorithm>
#include <string>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "base/error.hpp"

namespace rmpl::runtime {

SimulatedSoftware::SimulatedSoftware(const automata::ModelProgram& program, const automata::MarkedPlant& plant,
                                     const automata::Scenario& scenario, std::uint64_t seed)
    : plant_(plant),
      scenario_(scenario),
      model_(program, seed, scenario.truth),
      script_(plant.plant(), scenario),
      forced_(scenario.forced),
      command_(automata::command_of(automata::idle_action(plant.plant()))),
      truth_(plant.modes(model_.marking(), model_.values())) {
  std::stable_sort(forced_.begin(), forced_.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
}

void SimulatedSoftware::issue(const automata::ControlAction& action, automata::Ticks now) {
  command_ = automata::command_of(action);
  script_.hear_command(action, now);
}

automata::Assignment SimulatedSoftware::value_of(const automata::ForcedMode& forced) const {
  return {plant_.plant()[forced.component].mode, automata::ValueId(forced.mode.index())};
}

/// All that is due at once, else the first of it that can come about, else what comes.
void SimulatedSoftware::step(automata::Ticks now) {
  const auto due = std::find_if(forced_.begin(), forced_.end(), [&](const auto& forced) { return forced.at > now; });
  const auto take = [&](auto from, auto to) {
    SimulatedModel::Wanted wanted;
    for (auto at = from; at != to; ++at) wanted.push_back(value_of(*at));
    if (wanted.empty() || !model_.step(command_, wanted)) return false;
    for (auto at = from; at != to; ++at) {
      const automata::Component& component = plant_.plant()[at->component];
      happenings_.push_back({Event::Kind::forced, to_text(component, at->mode), at->component, {}});
    }
    forced_.erase(from, to);
    return true;
  };
  if (take(forced_.begin(), due)) return;
  for (auto one = forced_.begin(); one != due && due - forced_.begin() > 1; ++one) {
    if (take(one, one + 1)) return;
  }
  model_.step(command_);
}

const automata::Observation& SimulatedSoftware::sense(automata::Ticks now) {
  happenings_.clear();
  time_ = now;
  try {
    step(now);
  } catch (const base::InputError& error) {
    throw base::InputError("the simulated plant '" + plant_.plant().name + "' at " + automata::format_seconds(now) +
                           " s: " + error.what());
  }
  truth_ = plant_.modes(model_.marking(), model_.values());
  readings_ = model_.read();
  script_.apply(readings_, now);
  script_.add_remarks(happenings_);
  return readings_;
}

void SimulatedSoftware::finish(automata::Ticks now) const {
  const auto missed =
      std::find_if(forced_.begin(), forced_.end(), [&](const auto& forced) { return forced.at <= now; });
  if (missed == forced_.end()) return;
  throw base::InputError(to_text(missed->origin) + ": from " + automata::format_seconds(missed->at) +
                         " s to the end at " + automata::format_seconds(now) + " s no draw led to " +
                         to_text(plant_.plant()[missed->component], missed->mode) + ": scenario '" + scenario_.name +
                         "' forces a mode that no draw could reach");
}

}  // namespace rmpl::runtime
