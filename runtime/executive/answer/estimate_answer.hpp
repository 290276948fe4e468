// The answer to a line of a plant's log, as JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/window/plant_window.hpp"

namespace rmpl::runtime {

/// What an update cost.
struct UpdateCost {
  std::size_t checked = 0;
  double dropped = 0;  ///< of what followed from the belief before
};

/// Readings of an update that no history explains.
struct UnexplainedByHistory {
  automata::Ticks time;
  automata::Observation readings;
};

/// What most likely happened: trajectories, best first, the times of their states, and where the best of them differs
/// from what it was after the line before.
struct PlantHistory {
  std::vector<automata::Ticks> times;
  std::vector<PlantTrajectory> trajectories;
  std::size_t first = 0;  ///< the update after which they set out
  struct Revision {
    automata::Ticks time;
    automata::Modes before, now;
  };
  std::vector<Revision> revised;
  bool cut = false;  ///< the search for them ended early
  std::vector<UnexplainedByHistory> unexplained = {};
};

/// What is told of a line.
struct PlantAnswer {
  const LogLine& line;
  const Estimate& estimate;
  const Belief& belief;
  std::optional<double> missing;  ///< at most, of the belief as it is listed; where probabilities are counted
  const UpdateCost* cost;         ///< where it is told
  const PlantHistory* history;    ///< where there is a window
  const ClockTable* clocks;       ///< those that are told; all where it is empty
  bool ranks;                     ///< in place of probabilities
  const std::vector<std::string>* channels = nullptr;  ///< names of what was sampled, where there are monitors
  bool repeats = false;                                ///< but for cycle, time and samples, the answer before it
};

/// From such a share on it is told unasked what may be missing from a belief.
constexpr double told_missing = 0.01;
/// `up to 3 % of the probability may be missing from a belief; …`.
std::string missing_text(double share);

/// `no history explains a.s = high at 3 s: set aside`.
std::string to_text(const std::vector<UnexplainedByHistory>& unexplained, const automata::Variables& variables);

/// For people: the samples, what they were read as, and the states of the belief, best first.
std::string as_text(const PlantAnswer& answer, const automata::Plant& plant);

/// Writes answers as lines of JSON, in the order in which they came. What an answer repeats is not written anew.
class AnswerWriter {
 public:
  /// Without the end of the line; `json` is the buffer. `go_on` is called for each state of a belief, and may throw.
  void write(JsonLine& json, const PlantAnswer& answer, const automata::Plant& plant, base::FunctionRef<void()> go_on);

 private:
  std::string rest_;  ///< of the last line, from what the next answer may repeat
};

}  // namespace rmpl::runtime
