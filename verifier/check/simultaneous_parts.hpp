// Parts of a target that have nothing to do with each other, and are wanted at one time.
//
// Searched as one plant such parts multiply, though nothing connects them but time. Here each is searched by itself,
// for the first time from some time on at which it can be as wanted; the others are asked from that time on, until all
// name the same time, or one knows of none. So n parts cost about what each of them does, times the rounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "verifier/check/search_scope.hpp"
#include "verifier/search/standstill.hpp"
#include "verifier/slice/slices.hpp"

namespace rmpl::verifier {

class SimultaneousParts {
 public:
  /// In dense time. Keeps references.
  SimultaneousParts(Slices& slices, const Target& target, const SearchScope::Terms& terms);

  /// Whether there are two parts at least.
  [[nodiscard]] bool worthwhile() const { return groups_.size() > 1; }

  /// Whether a run is possible and shows the target.
  using Shows = std::function<bool(const Witness&)>;
  struct Result {
    bool never = false;              ///< no run comes to the target
    std::optional<Witness> witness;  ///< a run that does; where the target asks for the fastest, that
  };
  /// Neither where parts that can each be as wanted at one time cannot be together, as a step of the one is a step of
  /// the other, or where it takes too many rounds to know. Throws what the meter throws.
  Result look(const Shows& shows);
  /// Whether a part has been seen where more faults are certain than there may be.
  [[nodiscard]] bool spent() const { return cut_off_.spent; }

 private:
  /// What is wanted of some components.
  struct Group {
    automata::Formula formula;
    Cone cone;
  };
  using Faults = std::vector<unsigned>;  ///< by group: how many there may be

  [[nodiscard]] std::vector<Faults> shares_of(unsigned faults) const;
  [[nodiscard]] Result meet(const Faults& share, const Shows& shows);
  [[nodiscard]] std::optional<Witness> earliest(std::size_t group, unsigned faults, Interval window);
  [[nodiscard]] SearchScope& scope(std::size_t group, unsigned faults);
  [[nodiscard]] Witness together(const std::vector<Witness>& parts) const;

  Slices& slices_;
  const Target& target_;
  const SearchScope::Terms& terms_;
  std::vector<Group> groups_;
  std::map<std::pair<std::size_t, unsigned>, std::unique_ptr<SearchScope>> scopes_;
  CutOff cut_off_;  ///< of the parts
};

}  // namespace rmpl::verifier
