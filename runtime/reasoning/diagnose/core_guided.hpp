// Minimum-cardinality diagnosis by unsatisfiable cores: OLL over an incremental solver.
//
// Soft literals say "this component works". While they cannot all hold, a core of them (a conflict in the sense of
// livingstone) costs one fault, and is relaxed by a totalizer that lets one of its members, and no second, fail
// (Andres, Kaufmann, Matheis, Schaub 2012). The cost of every model is the bound plus the soft literals that it
// breaks, so once all hold, the models are exactly the diagnoses of minimum cardinality.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "automata/logic/sat.hpp"
#include "runtime/reasoning/diagnose/totalizer.hpp"

namespace rmpl::runtime {

class CoreGuided {
 public:
  /// The solver must outlive this object.
  explicit CoreGuided(automata::Sat& sat) : sat_(sat) {}

  /// A soft literal more.
  void keep(automata::Literal soft) { active_.push_back(soft); }
  /// Finds the smallest number of soft literals that must be broken, and leaves the solver with a model that breaks no
  /// more. May be called again after clauses and soft literals were added: cores that were found still hold. False
  /// where the hard clauses alone contradict each other.
  bool minimise();
  /// That number. Proved: each core needs one fault more.
  [[nodiscard]] std::size_t cost() const { return cost_; }
  /// Makes the bound permanent, so that every further model has minimum cost, and no assumptions are needed.
  void commit();

 private:
  struct Bound {
    std::size_t totalizer;
    std::size_t limit;  ///< this soft literal says: no more than `limit` of the totalizer's inputs hold
  };
  std::vector<automata::Literal> core_of(const std::vector<automata::Literal>& assumptions) const;
  void relax(const std::vector<automata::Literal>& core);
  void bound(std::size_t totalizer, std::size_t limit);

  automata::Sat& sat_;
  std::vector<automata::Literal> active_;   ///< soft literals that are assumed, in order of birth
  std::vector<automata::Literal> waiting_;  ///< those that are not assumed yet
  std::vector<Totalizer> totalizers_;
  std::map<automata::Literal, Bound> bounds_;  ///< of soft literals that are negated outputs
  std::size_t cost_ = 0;
};

}  // namespace rmpl::runtime
