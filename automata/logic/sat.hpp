// The one small interface behind which a SAT solver stands: clauses in, assumptions, failed assumptions out.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace rmpl::automata {

/// A literal in the DIMACS manner: +v or -v, v from 1.
using Literal = int;

/// An incremental solver (CaDiCaL). Not copyable; one thread at a time.
class Sat {
 public:
  Sat();
  ~Sat();
  Sat(Sat&&) noexcept;
  Sat& operator=(Sat&&) noexcept;

  /// A fresh variable, as its positive literal.
  Literal fresh();
  void add(std::span<const Literal> clause);
  void add(std::initializer_list<Literal> clause) { add(std::span<const Literal>(clause.begin(), clause.size())); }
  /// Has the search always try "true" first, instead of what a variable was last: for clauses whose variables are
  /// meant to hold unless something speaks against it. Before the first clause.
  void prefer_true();
  /// Whether the clauses can hold together with the assumptions. Assumptions last one call.
  bool solve(std::span<const Literal> assumptions);
  /// After a `solve` that returned false: whether this assumption takes part in the proof.
  [[nodiscard]] bool failed(Literal assumption) const;
  /// After a `solve` that returned true: whether this literal is true in the model found.
  [[nodiscard]] bool value(Literal literal) const;
  [[nodiscard]] std::size_t calls() const { return calls_; }

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
  Literal last_ = 0;
  std::size_t calls_ = 0;
};

}  // namespace rmpl::automata
