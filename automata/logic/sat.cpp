// CaDiCaL behind the small interface.
// SPDX-License-Identifier: MIT
#include "automata/logic/sat.hpp"

#include <cadical.hpp>

#include "base/check.hpp"

namespace rmpl::automata {

struct Sat::Solver {
  CaDiCaL::Solver cadical;
};

namespace {
constexpr int satisfiable = 10;
}

Sat::Sat() : solver_(std::make_unique<Solver>()) {
  // Questions are many and small: simplification between them costs more than it saves.
  solver_->cadical.set("quiet", 1);
  solver_->cadical.set("profile", 0);
  solver_->cadical.set("elim", 0);
  solver_->cadical.set("lucky", 0);
  // Assumptions are many: to jump back over them and decide them again costs less than it gains in order.
  solver_->cadical.set("chrono", 0);
}
Sat::~Sat() = default;
Sat::Sat(Sat&&) noexcept = default;
Sat& Sat::operator=(Sat&&) noexcept = default;

Literal Sat::fresh() { return ++last_; }

void Sat::add(std::span<const Literal> clause) {
  for (const Literal literal : clause) solver_->cadical.add(literal);
  solver_->cadical.add(0);
}

void Sat::prefer_true() { solver_->cadical.set("forcephase", 1); }

bool Sat::solve(std::span<const Literal> assumptions) {
  for (const Literal literal : assumptions) solver_->cadical.assume(literal);
  ++calls_;
  const int status = solver_->cadical.solve();
  CHECK(status != 0 && "no limit is set, so the solver decides");
  return status == satisfiable;
}

bool Sat::failed(Literal assumption) const { return solver_->cadical.failed(assumption); }

bool Sat::value(Literal literal) const { return solver_->cadical.val(literal) > 0; }

}  // namespace rmpl::automata
