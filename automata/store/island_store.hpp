// One island of the store by itself, whatever is commanded: what it excludes, and how it fits what is seen. Answers are
// remembered by the modes that the island reads.
// SPDX-License-Identifier: MIT
#pragma once

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

/// Components whose modes cannot hold together; `lasting`: whatever is observed.
struct Refutation {
  std::vector<ComponentId> components;
  bool lasting = false;
};

/// Keeps references to the plant, its index and the island, which must outlive it.
class IslandStore {
 public:
  IslandStore(const Plant& plant, const PlantIndex& index, const Island& island);

  /// Whether there are modes and controls that the constraints exclude, as far as can be seen.
  [[nodiscard]] bool excludes() const { return possible_.has_value(); }
  /// Makes the theory beforehand, so that no question has to.
  void prepare() { theory_(); }

  /// Whether the constraints can hold under the modes.
  bool possible(const Modes& modes);
  /// Of impossible modes: whose cannot be together, none of which can be spared.
  std::vector<ComponentId> conflict(const Modes& modes);

  /// The readings that `factor` and `refutation` are about: of the island's attributes, sorted.
  void observe(std::span<const Assignment> readings);
  /// The observation factor of semantics 4, as far as it is this island's: 0 also where the modes are impossible.
  double factor(const Modes& modes);
  /// After a factor of 0: who is to blame.
  Refutation refutation(const Modes& modes);

  [[nodiscard]] std::size_t questions() const { return theory_.questions(); }
  [[nodiscard]] std::size_t solver_calls() const { return theory_.solver_calls(); }

 private:
  static constexpr std::size_t observations_remembered = 1u << 12;
  [[nodiscard]] double weigh(const Modes& modes);

  IslandTheory theory_;
  std::optional<Consistency> possible_;                        ///< where something may contradict the island
  std::optional<Memory<std::vector<ComponentId>>> conflicts_;  ///< once asked for
  std::vector<Assignment> readings_;                           ///< of the theory's variables
  std::uint64_t seen_ = 0;                                     ///< a number that the readings have, and no others
  std::uint64_t seen_so_far_ = 0;
  base::BoundedCache<std::vector<std::uint64_t>, std::uint64_t> seen_before_{observations_remembered};
  Memory<double> factors_;  ///< by modes and readings
  /// Where the island reads one component at most, as most do: the factors by its mode, under the present readings.
  std::vector<std::optional<double>> by_mode_;
};

}  // namespace rmpl::automata
