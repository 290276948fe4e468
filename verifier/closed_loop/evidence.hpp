// Evidence: from a path that a search has found to a witness that has been replayed.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verifier/closed_loop/program_system.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/lasso.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/witness/claim.hpp"
#include "verifier/witness/loop_replay.hpp"

namespace rmpl::verifier {

/// Makes witnesses of one closed loop. Every one has been run anew by rules, a sequencer and a reconfigurer that have
/// no part in the search, and shows what it is to show; else an InternalError is thrown.
class Evidence {
 public:
  /// Keeps references.
  Evidence(Loop& loop, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
           std::shared_ptr<const runtime::NominalGraph> graph, const CheckOptions& options);

  /// Of a path to an accepted state. `shown` is what the witness is to show, where it is a property.
  Witness of(const std::vector<PathState>& path, const SymbolicState& end, ProgramSystem& system, const Query& query,
             const ProgramProperty* shown);
  /// Of a run that goes round for ever.
  Witness of(const Lasso& lasso, const Query& query, const ProgramProperty& shown);

 private:
  Witness stopped(std::vector<PathState> path, const SymbolicState& accepted, ProgramSystem& system, const Query& query,
                  const ProgramProperty* shown);
  void note_owed(Witness& witness, const ProgramProperty* shown);
  void add_refusals(Witness& witness);
  void explain(Witness& witness);
  Witness replayed(Witness witness, const ProgramProperty* shown);
  /// Made where there is something to replay.
  LoopJudge& judge();
  [[nodiscard]] ClaimTerms claim_terms() const { return {options_.entailed, options_.period}; }

  Loop& loop_;
  automata::PlantStep& step_;
  runtime::Reconfigurer& reconfigurer_;
  std::shared_ptr<const runtime::NominalGraph> graph_;
  const CheckOptions& options_;
  std::optional<LoopJudge> judge_;
};

}  // namespace rmpl::verifier
