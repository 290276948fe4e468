// Model programs by enumeration, from the paper and semantics 8 alone: every draw, every world, every trajectory.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/phca.hpp"
#include "automata/state.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::reference {

/// All marked locations, composites too.
using MarkedSet = std::set<automata::LocationId>;
/// Probabilities by marking; markings of probability 0 are left out.
using MarkingBelief = std::map<MarkedSet, double>;
/// Known commands.
using Commands = std::vector<automata::Assignment>;

/// The step of a model program.
class ModelProgramStep {
 public:
  explicit ModelProgramStep(const automata::ModelProgram& program);

  [[nodiscard]] const automata::ModelProgram& program() const { return program_; }
  /// The start markings whose stores are consistent; not normalised.
  [[nodiscard]] MarkingBelief initial() const;
  /// Where a step leads, markings with inconsistent stores left out; nothing where the commands contradict the marking.
  [[nodiscard]] MarkingBelief next(const MarkedSet& marking, const Commands& commands) const;
  /// The same with every draw by itself: `visit(target, probability, draws of a branch that another is likelier than)`.
  using Visit = std::function<void(const MarkedSet&, double, unsigned)>;
  void for_each_start(const Visit& visit) const;
  void for_each_next(const MarkedSet& marking, const Commands& commands, const Visit& visit) const;
  /// Whether the formula holds in all worlds of the marking's store, and in some.
  [[nodiscard]] bool entails(const MarkedSet& marking, const automata::Formula& formula) const;
  [[nodiscard]] bool allows(const MarkedSet& marking, const automata::Formula& formula) const;
  [[nodiscard]] double factor(const MarkedSet& marking, const automata::Observation& observation) const;
  /// The values that are entailed.
  [[nodiscard]] std::map<automata::VariableId, automata::ValueId> values(const MarkedSet& marking) const;

 private:
  using Worlds = std::vector<const World*>;
  [[nodiscard]] Worlds worlds(const MarkedSet& marking, const Commands& commands) const;
  [[nodiscard]] bool inside(automata::LocationId location, automata::LocationId composite) const;
  void mark(automata::LocationId target, MarkedSet& marked) const;
  [[nodiscard]] MarkedSet taken(const MarkedSet& marking,
                                const std::map<automata::LocationId, const automata::TransitionFunction*>& drawn,
                                const Worlds& store) const;

  const automata::ModelProgram& program_;
  std::vector<World> all_;
};

struct MarkingUpdate {
  MarkingBelief belief;
  automata::Observation set_aside =
      {};                ///< the first smallest set of readings without which something explains the rest
  bool possible = true;  ///< false: not even a prediction, `belief` is the one before
};

/// The initial belief, normalised, given what is seen at time 0.
MarkingUpdate start(const ModelProgramStep& step, const automata::Observation& observation);
MarkingUpdate update(const ModelProgramStep& step, const MarkingBelief& belief, const Commands& commands,
                     const automata::Observation& observation);
/// The paper's beam: the k markings of greatest predicted probability that the readings leave possible. `clear`: no tie
/// at the edge.
MarkingUpdate beam(const ModelProgramStep& step, const MarkingBelief& belief, const Commands& commands,
                   const automata::Observation& observation, std::size_t k, bool& clear);

/// Marking by marking, from where it set out.
using MarkingTrajectory = std::vector<MarkedSet>;
/// What was told to a step.
using Told = std::pair<Commands, automata::Observation>;
/// Every trajectory from a belief through some updates, normalised over all of them.
std::map<MarkingTrajectory, double> trajectories(const ModelProgramStep& step, const MarkingBelief& from,
                                                 const std::vector<Told>& updates);

}  // namespace rmpl::reference
