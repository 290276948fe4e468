// A Markov decision process in steps, whose states are met as it is walked.
//
// Clocks of a program that run for long are kept apart from states, by the step in which they started: while none of
// them comes to a bound, what follows a state is the same step after step, however long they have run.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "verifier/markov/enclosure.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// The number of a state of a process: modes, clocks, and what else tells what may follow.
using StateNumber = std::uint32_t;

/// A state, and when its long clocks started: numbers of the process.
struct Point {
  StateNumber state = 0;
  std::uint32_t starts = 0;
  auto operator<=>(const Point&) const = default;
};

struct Branch {
  StateNumber to = 0;
  Enclosure probability;
  std::uint32_t passage = 0;  ///< what becomes of long clocks, a number of the process; 0: they go on
};

/// At most how likely it is to come to what is wanted: once and for all, and for each step more.
struct Prospect {
  Real once = 1;
  Real each_step = 0;

  [[nodiscard]] Real within(Units steps) const {
    const Real all = once + each_step * static_cast<Real>(std::max<Units>(steps, 0));
    return std::min<Real>(rounding::up(all, 2), 1);
  }
  bool operator==(const Prospect&) const = default;
  /// Of one of two, nobody knows which.
  [[nodiscard]] Prospect operator|(const Prospect& other) const {
    return {std::max(once, other.once), std::max(each_step, other.each_step)};
  }
  /// One more that is so likely to come into question.
  void add(Real probability, const Prospect& other) {
    once = rounding::up(once + probability * other.once, 2);
    each_step = rounding::up(each_step + probability * other.each_step, 2);
  }
};

/// What one choice leads to. Nothing at all: nothing can follow.
struct Row {
  std::vector<Branch> edges;  ///< the likelier ones first
  Real left_out = 0;          ///< at most the probability of what is not known
  Prospect foreseen{0, 0};    ///< of what else the edges do not lead to, from the end of the step on
};

class Process {
 public:
  Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  virtual ~Process() = default;

  struct Start {
    Point point;
    Enclosure probability;
  };
  virtual std::vector<Start> initial() = 0;
  /// A row for each choice. Outcomes may be left out from which it is less likely than that to come to what is wanted,
  /// as far as that is foreseen. The reference lasts until the next call. Throws LimitReached.
  virtual const std::vector<Row>& rows(StateNumber state, Real less_likely_than) = 0;
  /// Whether it is a state that the question asks for.
  virtual bool wanted(StateNumber state) = 0;
  /// From a state on, whatever clocks read.
  virtual Prospect prospect(StateNumber /*state*/) { return {}; }
  /// Whether states had been taken for one that are not. What followed such a state was left out. From now on they are
  /// told apart; numbers of states are void.
  virtual bool tells_more_apart() { return false; }
  /// How many states have been met.
  [[nodiscard]] virtual std::size_t states() const = 0;

  /// Where an edge from `from` leads that is taken in the step that ends at `now`, in steps.
  virtual Point follow(const Point& /*from*/, const Branch& edge, Units /*now*/) { return {edge.to, 0}; }
  /// The last step that may end there without a long clock coming to a bound.
  virtual Units lasts_until(const Point& /*at*/) { return unbounded; }

  // What follows a point depends on what clocks read, and not on the step: later, it is the same, later.

  /// Whether clocks run there.
  virtual bool has_clocks(const Point& /*at*/) { return false; }
  /// Where clocks begin to run that may run for long, and no other clock has run for more than a few steps: the point
  /// that it would be at step 0.
  virtual std::optional<Point> as_begun(const Point& /*at*/, Units /*now*/) { return std::nullopt; }
  /// The same, so many steps later.
  virtual Point later(const Point& at, Units /*steps*/) { return at; }
};

}  // namespace rmpl::verifier
