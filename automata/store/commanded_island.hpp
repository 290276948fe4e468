// One island of the store under a command: whether it is consistent, what it implies, and by which of the assumptions.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/consistency.hpp"
#include "automata/store/island_theory.hpp"
#include "automata/store/memory.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Whether something follows or is refuted, and assumptions that are enough for that.
struct Reason {
  bool implied;
  std::vector<Assignment> assumptions;  ///< of modes and controls of the plant
};

/// Keeps references to the plant, its index and the island, which must outlive it.
class CommandedIsland {
 public:
  /// `excludes`: whether modes and controls may contradict the constraints.
  CommandedIsland(const Plant& plant, const PlantIndex& index, const Island& island, bool excludes);

  /// Has `implies` answer for a formula over the island's attributes, modes and controls; returns its number. Before
  /// the first question.
  std::size_t watch(const Formula& formula) { return theory_.watch(formula); }
  /// Makes the theory beforehand, so that no question has to.
  void prepare() { theory_(); }

  /// Whether the constraints can hold under modes and controls.
  bool consistent(const Modes& modes, const ControlAction& action);

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

  /// Why a watched formula follows from modes and controls, or cannot hold with them, whatever the modes of the
  /// components `unknown`, ascending. Nothing where neither is so.
  std::optional<Reason> reason(std::size_t watched, const Modes& modes, const ControlAction& action,
                               const std::vector<ComponentId>& unknown);
  /// The same, where assumptions that do not contradict each other are enough as far as propagation tells.
  std::optional<bool> decided(std::size_t watched, std::span<const Assignment> assumptions);

  [[nodiscard]] std::size_t questions() const { return theory_.questions(); }
  [[nodiscard]] std::size_t solver_calls() const { return theory_.solver_calls(); }

 private:
  IslandTheory theory_;
  std::optional<Consistency> consistent_;  ///< where something may contradict the island
  Memory<Verdicts> verdicts_;
};

}  // namespace rmpl::automata
