// The locations of a program that may be marked, with all conditions free that can hold and can fail.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "automata/program.hpp"

namespace rmpl::compiler {

/// What a condition may be: asked once of each guard, maintenance condition and goal of a program.
struct Freedom {
  bool may_hold = true;
  bool may_fail = true;
};
using FreedomOf = std::function<Freedom(const automata::Condition&)>;

/// Two least fixpoints over the locations: which may come to an end, with all that follows from them, and which may be
/// marked. What is not marked here is never marked; threads are taken for independent, so what is may not be.
class ReachableLocations {
 public:
  /// Refers to the program.
  ReachableLocations(const automata::Program& program, const FreedomOf& freedom);

  [[nodiscard]] bool reached(automata::LocationId location) const { return reached_[location.index()]; }
  /// Whether nothing may be left of a location, some time after it was marked. Of a composite: of what it holds, and
  /// of what follows it.
  [[nodiscard]] bool may_vanish(automata::LocationId location) const { return vanishes_[location.index()]; }
  /// Whether a composite may end: what it holds vanishes, or its maintenance condition fails.
  [[nodiscard]] bool may_end(automata::LocationId composite) const;

 private:
  void add_entries(std::size_t source, std::size_t target);
  bool update_vanishing(std::size_t location);
  [[nodiscard]] bool may_leave(std::size_t location) const;
  [[nodiscard]] bool arcs_may_vanish(std::size_t location) const;
  void mark(std::size_t location);

  const automata::Program& program_;
  std::vector<std::vector<Freedom>> guards_;       ///< per location, per arc
  std::vector<Freedom> maintenance_;               ///< per location
  std::vector<Freedom> goals_;                     ///< per location: of its being achieved
  std::vector<std::vector<std::size_t>> starts_;   ///< per composite, its start locations
  std::vector<std::vector<std::size_t>> entries_;  ///< per composite, what arcs from outside lead to within it
  std::vector<bool> vanishes_;
  std::vector<bool> reached_;
  std::vector<std::size_t> pending_;
};

}  // namespace rmpl::compiler
