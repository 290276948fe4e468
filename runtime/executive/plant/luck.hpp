// The luck of a flight: the random numbers that its plant drew, which another flight may have as well.
//
// A simulated plant takes one number after the other from its seed. So what one component draws shifts what all others
// draw after it, and two flights that part in one component part in all of them. A flight that follows the luck of
// another one has its numbers by step and by who draws (common random numbers: Law, Simulation Modeling and Analysis).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/executive/plant/random_source.hpp"

namespace rmpl::runtime {

/// The numbers that were drawn, in [0, 1), by step and by who drew: a component, or a sensor. What was certain drew
/// none.
class DrawnNumbers {
 public:
  /// The draws of a step follow; the first step is the start.
  void begin_step() { steps_.emplace_back(); }
  /// The step is drawn again: what it has drawn so far counts no more.
  void begin_again() { steps_.back().clear(); }
  void note(std::size_t who, double number) { steps_.back().emplace_back(who, number); }
  /// None where that flight was over, or the draw was certain there.
  [[nodiscard]] std::optional<double> at(std::size_t step, std::size_t who) const;

 private:
  std::vector<std::vector<std::pair<std::size_t, double>>> steps_;
};

struct Luck {
  DrawnNumbers moves;     ///< by component
  DrawnNumbers readings;  ///< by position among the observables, ascending
};

/// What a flight does with luck.
struct LuckUse {
  std::shared_ptr<Luck> noted = nullptr;           ///< gets what the flight draws
  std::shared_ptr<const Luck> followed = nullptr;  ///< is drawn once more
};

/// Where a plant has its numbers from: one after the other from the seed; or, in a flight that follows another, those
/// of that flight, and where it has none, from a source that each step has for each who draws. Then what one draws
/// never shifts what another draws.
class NumberSource {
 public:
  /// Keeps the pointers; null: no numbers are noted, none followed.
  NumberSource(std::uint64_t seed, std::uint64_t stream, DrawnNumbers* noted, const DrawnNumbers* followed);

  [[nodiscard]] bool follows() const { return followed_ != nullptr; }
  void begin_step();
  /// The step is drawn again.
  void begin_again();
  /// In [0, 1). Who draws again in one step gets another number.
  double number(std::size_t who);

 private:
  RandomSource random_;
  DrawnNumbers* noted_;
  const DrawnNumbers* followed_;
  std::uint64_t own_seed_;
  std::size_t steps_ = 0;
  std::vector<std::pair<std::size_t, RandomSource>> own_;  ///< of this step, by who has drawn
};

}  // namespace rmpl::runtime
