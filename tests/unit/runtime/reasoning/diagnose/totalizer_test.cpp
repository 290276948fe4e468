// Totalizers against counting.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/totalizer.hpp"

#include <gtest/gtest.h>

#include <bit>

namespace rmpl::runtime {
namespace {

using automata::Literal;

/// Bounds are asked for in any order; each output must hold exactly where more inputs do than it says.
TEST(Totalizer, CountsWhatHolds) {
  for (std::size_t size = 1; size <= 6; ++size) {
    for (std::size_t first_bound = 0; first_bound < size; ++first_bound) {
      automata::Sat sat;
      std::vector<Literal> inputs;
      for (std::size_t i = 0; i < size; ++i) inputs.push_back(sat.fresh());
      Totalizer totalizer(inputs);
      for (std::size_t step = 0; step < size; ++step) {
        const std::size_t bound = (first_bound + step) % size;
        const Literal more = totalizer.more_than(bound, sat);
        EXPECT_EQ(totalizer.more_than(bound, sat), more) << "the same literal again";
        for (std::size_t world = 0; world < (1u << size); ++world) {
          std::vector<Literal> assumptions{-more};
          for (std::size_t i = 0; i < size; ++i) {
            assumptions.push_back(((world >> i) & 1) != 0 ? inputs[i] : -inputs[i]);
          }
          EXPECT_EQ(sat.solve(assumptions), static_cast<std::size_t>(std::popcount(world)) <= bound)
              << size << " inputs, bound " << bound << ", world " << world;
        }
      }
    }
  }
}

}  // namespace
}  // namespace rmpl::runtime
