// A witness as a scenario: the same readings for the executive, and an expectation that fails.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "automata/step/plant_step.hpp"
#include "verifier/property/property.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

struct ScenarioFrame {
  std::string name;
  std::string program, plant;  ///< paths, as the scenario is to name them
  std::string entry;           ///< the definition to start with; empty: the one that no other calls
  automata::Ticks cycle;
  std::int64_t patience = 20;  ///< cycles that a flight in which the program is not to end goes on after the trace
};

/// Whether the flight fails as the program has not ended when it is over, which may be too soon.
bool is_about_patience(const ProgramProperty& property);

/// Whether all components start in modes that are most likely there, as a flight takes them to.
bool starts_likely(const automata::Plant& plant, const Witness& witness);

/// Why no flight would fail as the run does; nothing where one does.
std::optional<std::string> no_scenario(automata::PlantStep& step, const ProgramProperty& property,
                                       const Witness& witness);

/// The text of a `.scn` file. `witness` violates `property` in cycles of the frame's length. The plant follows rules
/// only: every sensor reads what the modes of the trace imply; where they leave it open, it reads what tells a fault
/// from the other modes of its component, or is silent. What is expected is what the trace does not bring.
std::string scenario_text(automata::PlantStep& step, const ProgramProperty& property, const Witness& witness,
                          const ScenarioFrame& frame);

}  // namespace rmpl::verifier
