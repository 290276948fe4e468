// A flight as it stands, on one screen: what the program asserts, what is commanded and why, what is believed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "automata/scenario.hpp"
#include "base/painter.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// Keeps up with a flight; draws it when asked. Keeps references to plant, program and scenario.
class LiveView final : public CycleObserver {
 public:
  LiveView(const automata::Plant& plant, const automata::Program& program, const automata::Scenario& scenario,
           base::Painter painter);

  void observe(const CycleRecord& record) override;
  /// Lines of at most `width` columns (at least 40): the progress, what holds in the last cycle, and the latest that
  /// happened; as many for every cycle of the flight, whatever happens in it, but no more than `height` (at least 16).
  [[nodiscard]] std::vector<std::string> lines(std::size_t width, std::size_t height) const;

 private:
  struct Now {
    automata::Ticks time;
    std::vector<std::string> goals;
    std::string command, why;
    automata::Modes estimate;
    double probability = 0;
    std::string set_aside;  ///< readings that nothing explains
  };

  [[nodiscard]] std::string progress(std::size_t width) const;
  [[nodiscard]] std::vector<std::string> believed(std::size_t width, std::size_t rows) const;

  const automata::Plant& plant_;
  const automata::Program& program_;
  const automata::Scenario& scenario_;
  base::Painter painter_;
  Story story_;
  std::deque<std::string> latest_;  ///< lines of the story
  Now now_;
  std::vector<automata::Ticks> since_;  ///< per component: when the estimate last changed
};

}  // namespace rmpl::runtime
