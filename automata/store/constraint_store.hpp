// The constraint store of a plant (thesis 6.1.4, C_M): what its modes, a control action and observations imply.
//
// It is asked island by island (support.hpp), and each island remembers what it has proved: a question costs a few
// look-ups wherever the modes and controls that the islands read have been met before, whatever the rest of the plant
// does, and else a pass over what propagation derives on one island (truth_maintenance.hpp). Questions about a command
// have smaller islands: what the command gives links nothing, nor does what one mode tells (known_attributes.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "automata/dependencies/dependencies.hpp"
#include "automata/dependencies/known_attributes.hpp"
#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/commanded_island.hpp"
#include "automata/store/island_store.hpp"
#include "automata/store/memory.hpp"
#include "automata/store/standing_answers.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Not for use from two threads at once. Keeps a reference to the plant. All that it remembers is bounded.
class ConstraintStore {
 public:
  /// A conjunct of a watched formula, which one island judges, or which takes several.
  struct Part {
    std::size_t island;  ///< of a known command, or `no_island`
    std::size_t number;
  };

  explicit ConstraintStore(const Plant& plant);
  ConstraintStore(const ConstraintStore&) = delete;  // the islands refer to its members
  ConstraintStore& operator=(const ConstraintStore&) = delete;

  [[nodiscard]] const Plant& plant() const { return plant_; }
  /// The store as one theory, for questions that this class does not answer.
  [[nodiscard]] Theory& theory() { return theory_; }
  [[nodiscard]] const Dependencies& dependencies() const { return dependencies_; }
  [[nodiscard]] const Locality& locality() const { return locality_; }

  /// Has `implies` answer for a formula, conjunct by conjunct; none: it is true. Before the first question about a
  /// command.
  std::vector<Part> watch(const Formula& formula);
  /// Makes all theories beforehand, so that no question has to.
  void prepare();

  /// Whether the store of these modes (Q and the mode constraints) is consistent; else the state is impossible.
  bool possible(const Modes& modes);
  /// Of impossible modes: components whose modes cannot be together, none of which can be spared. A few questions.
  std::vector<ComponentId> conflict(const Modes& modes);
  /// Whether the store is consistent with the control action; else it implies everything.
  bool consistent(const Modes& modes, const ControlAction& action);
  /// Whether the store of modes and control action, which are consistent, implies a part.
  bool implies(const Part& part, const Modes& modes, const ControlAction& action);
  /// What the truth of a part depends on in a consistent store.
  [[nodiscard]] const Support& support_of(const Part& part);
  /// Why the store implies a part, or refutes it, whatever the modes of the components `unknown`, ascending. Nothing
  /// where neither is so.
  std::optional<Reason> reason(const Part& part, const Modes& modes, const ControlAction& action,
                               const std::vector<ComponentId>& unknown);
  /// Whether assumptions about modes and controls, which do not contradict the store, are enough for a part to follow
  /// or to fail, as far as propagation tells.
  std::optional<bool> decided(const Part& part, std::span<const Assignment> assumptions);

  /// The same for many questions about one state: each island is looked up once. Lasts until the next question.
  class Consequences {
   public:
    Consequences(ConstraintStore& store, const Modes& modes, const ControlAction& action);
    bool operator()(const Part& part);

   private:
    ConstraintStore& store_;
    const Modes& modes_;
    const ControlAction& action_;
  };

  /// P_O of semantics 4: per observation 1 if the store of `modes` entails it, 0 if it refutes it, 1/m otherwise; 0 if
  /// store and observations are jointly inconsistent (so also where the state itself is impossible).
  double observation_factor(const Modes& modes, const Observation& observation);
  /// Where store and observations are inconsistent: components to blame.
  Refutation refutation(const Modes& modes, const Observation& observation);

  /// How many questions the theories were asked, and how often that took a solver.
  [[nodiscard]] std::size_t questions() const;
  [[nodiscard]] std::size_t solver_calls() const;

 private:
  static constexpr std::size_t no_island = static_cast<std::size_t>(-1);
  struct Wide {
    Theory::Handle formula;
    Support support;
    Memory<bool> implied;
  };

  Part part(const Formula& conjunct);
  bool implies(Wide& wide, const Modes& modes, const ControlAction& action);
  [[nodiscard]] std::vector<Assignment> assumptions(const Support& support, const Modes& modes,
                                                    const ControlAction& action) const;
  /// Makes the islands of a known command, once all formulas are watched.
  void set_out();
  void observe(const Observation& observation);

  const Plant& plant_;
  Dependencies dependencies_;
  Locality locality_;
  Theory theory_;
  std::vector<IslandStore> islands_;           ///< as the locality has them
  std::optional<KnownAttributes> known_;       ///< until the first question
  Locality commanded_locality_;                ///< with all that watched formulas read
  std::vector<std::vector<Formula>> watched_;  ///< by island of these, until the first question
  std::map<std::pair<std::vector<ComponentId>, std::vector<std::size_t>>, std::size_t>
      of_modes_;  ///< islands without attributes, by their support
  /// By island of these; empty until the first question. Null for one that nobody asks.
  std::vector<std::unique_ptr<CommandedIsland>> commanded_;
  std::vector<std::size_t> excluding_;  ///< positions of those that can be inconsistent
  std::vector<Wide> wide_;
  std::vector<std::size_t> constrained_;              ///< positions of the islands that can be inconsistent
  StandingAnswers<bool> possible_;                    ///< of those
  StandingAnswers<bool> consistent_;                  ///< of those that exclude a command
  std::vector<CommandedIsland::Verdicts*> verdicts_;  ///< by island, of `Consequences`; null: not asked yet

  std::optional<Observation> observed_;  ///< what the islands were told last
  std::vector<std::size_t> weighed_;     ///< positions of the islands that can be inconsistent or that are observed
  StandingAnswers<double> factors_;      ///< of those
};

}  // namespace rmpl::automata
