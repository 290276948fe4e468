// What filters have in common that keep their belief as a list of states.
// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/reasoning/estimate/filter.hpp"

namespace rmpl::runtime {

class ListedFilter : public Filter {
 public:
  [[nodiscard]] bool steady() const override { return false; }
  void repeat(automata::Ticks now) override { last_ = now; }
  [[nodiscard]] const Belief& belief() const override { return belief_; }
  [[nodiscard]] const Belief& before() const override { return before_; }
  [[nodiscard]] const Estimate& estimate() const override { return estimate_; }

 protected:
  automata::Ticks last_;   ///< as of which `belief_` is
  mutable Belief belief_;  ///< may be listed when it is asked for, as `before_`
  mutable Belief before_;
  Estimate estimate_;
};

}  // namespace rmpl::runtime
