// Replaying a run of the closed loop on the rules of semantics 2 and 3, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "automata/step/plain_step.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "verifier/witness/replay.hpp"

namespace rmpl::verifier {

/// What runs of a program are replayed on: rules, a sequencer and a planner that no search asks. Keeps references.
class LoopJudge {
 public:
  /// `graph` is what planning in the plant computes before the first question; `cycle` is that of the executive, 0 in
  /// dense time.
  LoopJudge(const automata::Program& program, const automata::Plant& plant,
            std::shared_ptr<const runtime::NominalGraph> graph, automata::Ticks cycle = {});

  [[nodiscard]] automata::PlainStep& rules() { return rules_; }
  /// Why the run is not possible; nothing where it is. Every cycle is run: sequencer, planner, plant. Of the cycles of
  /// a wait those are run in which a clock is near a constant of the program or a bound of its mode: between them
  /// nothing differs.
  std::optional<std::string> replay(const Witness& witness, const ReplayRules& replay_rules);

 private:
  const automata::Program& program_;
  automata::PlainStep rules_;
  automata::PlantStep asked_;  ///< by the planner
  std::unique_ptr<runtime::Reconfigurer> planner_;
  automata::ProgramStep sequencer_;
};

}  // namespace rmpl::verifier
