// One island of the store by itself: what it excludes, what it implies, and how it fits what is seen.
//
// A theory of the island's own constraints answers, over its own few variables, so that a question costs what the
// island is worth, not what the plant is; and answers are remembered by the modes and controls that the island reads.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/memory.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Components whose modes cannot hold together; `lasting`: whatever is observed.
struct Refutation {
  std::vector<ComponentId> components;
  bool lasting = false;
};

/// Keeps references to the plant and to the island, which must outlive it.
class IslandStore {
 public:
  IslandStore(const Plant& plant, const Island& island);

  /// Whether there are modes and controls that the constraints exclude, as far as can be seen.
  [[nodiscard]] bool excludes() const { return excludes_; }
  /// Has `implies` answer for a formula over the island's attributes; returns its number. Before the first question.
  std::size_t watch(const Formula& formula);
  /// Makes the theory beforehand, so that no question has to.
  void prepare() { theory(); }

  /// Whether the constraints can hold under the modes.
  bool possible(const Modes& modes);
  /// Of impossible modes: whose cannot be together, none of which can be spared.
  std::vector<ComponentId> conflict(const Modes& modes);

  enum class Truth : std::uint8_t { refuted, implied, open };
  /// What is known under modes and controls: of the watched formulas most follow, or fail, by one model and what
  /// propagation derives; the others stay open until somebody asks.
  struct Verdicts {
    bool consistent;
    std::vector<Truth> truths;
  };
  /// Lasts until the next call.
  Verdicts& verdicts(const Modes& modes, const ControlAction& action);
  /// Whether the store implies a watched formula; `known` are the verdicts of these modes and controls. An inconsistent
  /// store implies all.
  bool implies(std::size_t watched, Verdicts& known, const Modes& modes, const ControlAction& action);

  /// The readings that `factor` and `refutation` are about: of the island's attributes, sorted.
  void observe(std::span<const Assignment> readings);
  /// The observation factor of semantics 4, as far as it is this island's: 0 also where the modes are impossible.
  double factor(const Modes& modes);
  /// After a factor of 0: who is to blame.
  Refutation refutation(const Modes& modes);

  [[nodiscard]] std::size_t questions() const { return theory_ ? theory_->questions() : 0; }
  [[nodiscard]] std::size_t solver_calls() const { return theory_ ? theory_->solver_calls() : 0; }

 private:
  static constexpr std::size_t observations_remembered = 1u << 12;
  [[nodiscard]] double weigh(const Modes& modes);
  /// The theory, made at the first question. Its variables are the modes of the support, then the attributes.
  Theory& theory();
  [[nodiscard]] VariableId own(VariableId variable) const;
  [[nodiscard]] std::vector<Assignment> assumptions(const Modes& modes) const;
  [[nodiscard]] std::vector<Assignment> assumptions(const Modes& modes, const ControlAction& action) const;

  const Plant* plant_;
  const Island* island_;
  bool excludes_;
  std::vector<Formula> watched_;
  std::vector<Theory::Handle> handles_;  ///< of what is watched
  std::optional<Theory> theory_;
  Memory<bool> possible_;
  Memory<Verdicts> verdicts_;
  std::vector<Assignment> readings_;  ///< of the theory's variables
  std::uint64_t seen_ = 0;            ///< a number that the readings have, and no others
  std::uint64_t seen_so_far_ = 0;
  base::BoundedCache<std::vector<std::uint64_t>, std::uint64_t> seen_before_{observations_remembered};
  Memory<double> factors_;  ///< by modes and readings
  /// Where the island reads one component at most, as most do: the factors by its mode, under the present readings.
  std::vector<std::optional<double>> by_mode_;
};

}  // namespace rmpl::automata
