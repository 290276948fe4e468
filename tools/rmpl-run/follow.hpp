// A flight on the terminal, redrawn while it goes on.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

#include "runtime/executive/scenario/live_view.hpp"

namespace rmpl::tools {

/// Draws below what was printed before, ten times a second, as wide and high as the terminal is at that moment.
class FollowScreen final : public runtime::CycleObserver {
 public:
  FollowScreen(const automata::Plant& plant, const automata::Program& program, const automata::Scenario& scenario,
               base::Painter painter)
      : view_(plant, program, scenario, painter) {}

  void observe(const runtime::CycleRecord& record) override;
  /// Draws the last cycle, which stays.
  void finish() { draw(); }

 private:
  void draw();

  runtime::LiveView view_;
  std::size_t drawn_ = 0;  ///< lines
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rmpl::tools
