// Assignments to modes, controls and sensors.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/step_choice.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {

void choose_fault(runtime::FlightSteps& flight, const std::string& text, const Common& common) {
  if (!flight.has_truth())
    throw base::InputError("fault: the plant is declared 'rules only' and has no modes, so no component can fail");
  const automata::Plant& plant = flight.plant();
  const auto modes = assignments_option(text, plant, "fault", common);
  for (const automata::Assignment& mode : modes) {
    if (plant.component_of(mode.variable)) continue;
    throw base::InputError("fault: '" + plant.variables.name(mode.variable) + "' is no component");
  }
  for (const automata::Assignment& mode : modes) {
    flight.force(*plant.component_of(mode.variable), automata::ModeId(mode.value.index()));
  }
}

void choose_command(runtime::FlightSteps& flight, const std::string& text, const Common& common) {
  const auto assignments = assignments_option(text, flight.plant(), "command", common);
  (void)automata::action_from(flight.plant(), assignments);  // refuses what is no control
  for (const automata::Assignment& assignment : assignments) flight.command(assignment);
}

void choose_reading(runtime::FlightSteps& flight, const std::string& text, const Common& common) {
  constexpr std::string_view word = " for ";
  std::string said = text;
  automata::Ticks duration = automata::Ticks::infinite();
  if (const auto at = text.rfind(word); at != std::string::npos) {
    const auto read = automata::parse_duration(std::string_view(text).substr(at + word.size()));
    if (!read) throw base::InputError("observe: expected a duration behind 'for', such as 3 s");
    duration = *read;
    said = text.substr(0, at);
  }
  const automata::Plant& plant = flight.plant();
  const auto readings = assignments_option(said, plant, "observe", common);
  for (const automata::Assignment& reading : readings) {
    const auto& shown = plant.observables;
    if (std::find(shown.begin(), shown.end(), reading.variable) != shown.end()) continue;
    throw base::InputError("observe: '" + plant.variables.name(reading.variable) + "' is not observable");
  }
  for (const automata::Assignment& reading : readings) flight.observe(reading, duration);
}

}  // namespace rmpl::tools
