// Fuzzes the constraint store as a sequence of calls (the manner of CaDiCaL's mobical): what is told and asked is drawn
// from the input, and every answer is compared with an enumeration of all worlds.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "automata/logic/theory.hpp"
#include "base/check.hpp"
#include "tests/fuzz/draws.hpp"

using namespace rmpl::automata;
using rmpl::fuzz::Draws;

namespace {

constexpr std::size_t variable_count = 4;
constexpr std::array<std::size_t, variable_count> domain_sizes = {2, 3, 2, 3};
using World = std::array<std::size_t, variable_count>;

Assignment draw_assignment(Draws& draws) {
  const std::size_t variable = draws.below(variable_count);
  return {VariableId(variable), ValueId(draws.below(domain_sizes[variable]))};
}

Formula draw_formula(Draws& draws, unsigned depth) {
  switch (draws.below(depth == 0 ? 2 : 8)) {
    case 0: {
      const Assignment a = draw_assignment(draws);
      return is(a.variable, a.value);
    }
    case 1:  // variables i and i + 2 have one domain
      if (draws.below(2) == 0) return constant(draws.below(2) == 0);
      return draws.below(2) == 0 ? equality(VariableId(0), VariableId(2)) : equality(VariableId(1), VariableId(3));
    case 2:
      return negation(draw_formula(draws, depth - 1));
    case 3:
      return implication(draw_formula(draws, depth - 1), draw_formula(draws, depth - 1));
    case 4:
      return equivalence(draw_formula(draws, depth - 1), draw_formula(draws, depth - 1));
    case 5:
      return conjunction({draw_formula(draws, depth - 1), draw_formula(draws, depth - 1)});
    default:
      return disjunction({draw_formula(draws, depth - 1), draw_formula(draws, depth - 1)});
  }
}

/// All worlds that what was told permits.
class Worlds {
 public:
  Worlds() {
    for (World w{}; w[0] < domain_sizes[0]; advance(w)) worlds_.push_back(w);
  }
  void tell(const Formula& formula) {
    std::erase_if(worlds_, [&](const World& world) { return !holds(formula, world); });
  }
  [[nodiscard]] bool some(const std::vector<Assignment>& assumptions, const Formula& formula) const {
    const Formula all = conjunction({conjunction_of(assumptions), formula});
    for (const World& world : worlds_) {
      if (holds(all, world)) return true;
    }
    return false;
  }

 private:
  static bool holds(const Formula& formula, const World& world) {
    return evaluate(formula, [&](VariableId v) { return ValueId(world[v.index()]); });
  }
  static void advance(World& world) {
    for (std::size_t i = variable_count; i-- > 0;) {
      if (++world[i] < domain_sizes[i] || i == 0) return;
      world[i] = 0;
    }
  }
  std::vector<World> worlds_;
};

void ask(Theory& theory, const Worlds& worlds, Draws& draws) {
  std::vector<Assignment> assumptions;
  for (std::size_t i = draws.below(4); i > 0; --i) assumptions.push_back(draw_assignment(draws));
  const Formula formula = draw_formula(draws, 2);
  const Theory::Handle handle = theory.encode(formula);
  switch (draws.below(4)) {
    case 0: {
      const bool consistent = theory.consistent(assumptions);
      CHECK(consistent == worlds.some(assumptions, constant(true)));
      if (!consistent) CHECK(!worlds.some(theory.minimal_conflict(theory.conflict()), constant(true)));
      break;
    }
    case 1: {
      const bool allowed = theory.allows(assumptions, handle);
      CHECK(allowed == worlds.some(assumptions, formula));
      if (!allowed) CHECK(!worlds.some(theory.minimal_conflict(theory.conflict(), handle), formula));
      break;
    }
    case 2: {
      const bool entailed = theory.entails(assumptions, handle);
      CHECK(entailed == !worlds.some(assumptions, negation(formula)));
      if (entailed) CHECK(!worlds.some(theory.conflict(), negation(formula)));
      break;
    }
    default: {
      const Assignment a = draw_assignment(draws);
      CHECK(theory.allows_other(assumptions, a) == worlds.some(assumptions, negation(is(a.variable, a.value))));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Variables variables;
  const std::array<std::vector<std::string>, 2> domains = {std::vector<std::string>{"a", "b"}, {"p", "q", "r"}};
  for (std::size_t i = 0; i < variable_count; ++i) variables.add({"v" + std::to_string(i), domains[i % 2]});
  Draws draws(data, size);
  Theory theory(variables, draws.below(2) == 0 ? Theory::Upkeep::searched : Theory::Upkeep::maintained);
  Worlds worlds;
  for (int calls = 0; calls < 200 && !draws.empty(); ++calls) {
    switch (draws.below(8)) {
      case 0: {
        const Formula formula = draw_formula(draws, 2);
        theory.tell(formula);
        worlds.tell(formula);
        break;
      }
      case 1: {
        const Assignment condition = draw_assignment(draws);
        const Formula formula = draw_formula(draws, 2);
        theory.tell_if(condition, formula);
        worlds.tell(implication(is(condition.variable, condition.value), formula));
        break;
      }
      default:
        ask(theory, worlds, draws);
    }
  }
  return 0;
}
