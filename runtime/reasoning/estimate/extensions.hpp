// The extensions of one system state by one step, best first: the OCSP of thesis Fig. 6-11, step 3.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/component_moves.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

/// What one observation says of candidate states. Decision variables are components, their values modes, so that what
/// is learnt about one source state holds for all.
class Evidence {
 public:
  /// `lasting` holds the conflicts that need no observation; those found here are added to it.
  Evidence(automata::PlantStep& step, automata::Observation observation, ConflictSet& lasting);

  /// The observation factor of semantics 4; 0 where modes and observation are jointly inconsistent.
  double factor(const automata::Modes& modes);
  /// The mode assignments to blame for a factor of 0.
  Conflict blame(const automata::Modes& modes);
  /// All that is known to be inconsistent with this observation.
  [[nodiscard]] const std::shared_ptr<ConflictSet>& conflicts() const { return conflicts_; }

 private:
  automata::PlantStep& step_;
  automata::Observation observation_;
  ConflictSet& lasting_;
  std::shared_ptr<ConflictSet> conflicts_;
};

/// One target of a step. `prior` is P_T, the product of the moves' probabilities in order of component; `factor` the
/// observation factor, above 0.
struct Extension {
  automata::Modes modes;
  double prior;
  double factor;
};

/// The consistent extensions of a source, in order of prior, found as far as somebody asks. They depend on the moves
/// and the observation alone.
class Extensions {
 public:
  /// `moves`: per component. Evidence and moves must outlive this.
  Extensions(Evidence& evidence, const std::vector<const ComponentMoves*>& moves) { restart(evidence, moves); }
  /// The same with moves of its own, as PlantStep gives them.
  Extensions(Evidence& evidence, const std::vector<std::vector<automata::Move>>& moves);
  /// Begins anew with other moves, in the memory of the last.
  void restart(Evidence& evidence, const std::vector<const ComponentMoves*>& moves);

  /// Those found so far.
  [[nodiscard]] const std::vector<Extension>& found() const { return found_; }
  /// Checks one candidate that holds no known conflict, if there is one; a consistent one is added to `found`.
  void check_one();
  /// The prior of the i-th extension and of all after it is at most this (up to rounding); 0 where there is none.
  [[nodiscard]] double bound(std::size_t i) const;
  /// The probability of moving to exactly these modes, before the observation.
  [[nodiscard]] double prior(const automata::Modes& modes) const {
    double product = 1;
    for (std::size_t c = 0; c < modes.size() && product > 0; ++c) product *= prior(c, modes[c]);
    return product;
  }
  [[nodiscard]] double prior(std::size_t component, automata::ModeId mode) const {
    return moves_[component]->prior(mode);
  }
  /// How many candidates were checked.
  [[nodiscard]] std::size_t checked() const { return started_ ? search_.checked() : 0; }

 private:
  void start();

  Evidence* evidence_ = nullptr;
  std::vector<const ComponentMoves*> moves_;  ///< by component
  std::vector<ComponentMoves> own_;           ///< where nobody else has them
  double best_ = 1;                           ///< the product of the greatest priors
  bool started_ = false;                      ///< most sources are too unlikely for a search ever to begin
  OptimalSearch search_{{}};
  std::vector<Extension> found_;
};

}  // namespace rmpl::runtime
