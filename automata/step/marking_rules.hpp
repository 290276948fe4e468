// The rules of semantics 8: what may be marked after one step of a PHCA, given what the store entails. Pure.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "automata/phca.hpp"
#include "automata/step/program_rules.hpp"
#include "base/function_ref.hpp"
#include "base/limit_error.hpp"

namespace rmpl::automata {

/// Whether another branch of a draw is likelier; probabilities that differ by rounding alone are the same.
template <class Branch>
bool is_improbable(const Branch& branch, const std::vector<Branch>& all) {
  constexpr double rounding = 1e-9;
  return std::any_of(all.begin(), all.end(),
                     [&](const Branch& other) { return other.probability > branch.probability * (1 + rounding); });
}

/// One way in which a part of a step may turn out.
struct MarkingOutcome {
  double probability = 0;
  Marking marked;  ///< primitive locations
  /// The fewest improbable draws with which it comes about: draws of a branch that another one is likelier than.
  unsigned improbable = 0;
  bool operator==(const MarkingOutcome&) const = default;
};

/// What a step may lead to: the union of `certain` and of an outcome of each part. Parts are drawn independently, and
/// neither `certain` nor two parts have a location in common, so that each union comes about in one way.
struct MarkingMoves {
  Marking certain;                                 ///< primitive locations
  std::vector<std::vector<MarkingOutcome>> parts;  ///< at least two outcomes each, by `marked`
};

/// What is marked where the parts turn out so, in order.
Marking united(const MarkingMoves& moves, std::span<const MarkingOutcome* const> outcomes);

/// Threads whose draws have to do with each other may turn out in more ways than there is room for.
class TooManyOutcomes : public base::LimitError {
 public:
  using LimitError::LimitError;
};

/// Keeps a reference to the program. A marking is given by its primitive locations: a composite is marked where
/// something in it is (`whole`).
class MarkingRules {
 public:
  /// Whether a condition, by its position in `conditions`, holds. Asked about one marking and command.
  using Holds = base::FunctionRef<bool(std::size_t)>;

  explicit MarkingRules(const ModelProgram& program);

  [[nodiscard]] const ModelProgram& program() const { return program_; }
  /// All guards and maintenance conditions, each once.
  [[nodiscard]] const std::vector<Condition>& conditions() const { return conditions_; }
  /// The primitive locations with the composites that hold them.
  [[nodiscard]] Marking whole(const Marking& primitive) const;
  /// The start markings, each in one way, as moves from nowhere.
  [[nodiscard]] MarkingMoves initial() const;
  /// What may be marked after a step. Throws TooManyOutcomes.
  [[nodiscard]] MarkingMoves moves(const Marking& primitive, const Holds& holds) const;

 private:
  friend class MarkingMovement;
  struct RuledArc {
    std::vector<std::size_t> guard;  ///< conditions
    LocationId source, target;
  };
  struct RuledFunction {
    double probability;
    bool improbable;  ///< another one is likelier
    std::vector<LocationId> started;
    std::vector<RuledArc> arcs;
  };
  std::vector<RuledArc> ruled(const std::vector<GuardedArc>& arcs, std::size_t source);
  std::size_t condition(const Condition& condition);

  const ModelProgram& program_;
  std::vector<Condition> conditions_;
  std::vector<Marking> holders_;                         ///< per location: what holds it, from the inside out
  std::vector<Marking> started_;                         ///< per location: the primitives marked with it, fully
  std::vector<std::optional<std::size_t>> maintenance_;  ///< per location: a condition
  std::vector<std::vector<RuledFunction>> functions_;    ///< per primitive location
  std::vector<std::vector<RuledArc>> arcs_;              ///< per composite
};

}  // namespace rmpl::automata
