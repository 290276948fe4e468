// The answer to a line of a model program's log, as JSON and for people.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "runtime/executive/answer/estimate_answer.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"

namespace rmpl::runtime {

/// What is told of a line.
struct MarkingAnswer {
  /// A marking that the most likely trajectory now has at a time, in place of what it had after the line before.
  struct Revision {
    automata::Ticks time;
    automata::Marking before, now;
  };
  std::optional<std::uint64_t> cycle;
  automata::Ticks time;
  MarkingBelief belief;
  std::vector<automata::Ticks> times;  ///< of the markings of a trajectory; none where there is no window
  std::vector<MarkingTrajectory> history;
  std::vector<Revision> revised;
  std::vector<UnexplainedByHistory> unexplained;
  MarkingEstimate estimate;
  double missing = 0;  ///< at most, of the belief as it is listed
};

/// For people: the entries of the belief, best first, with the source of what is marked.
std::string as_text(const MarkingAnswer& answer, const automata::ModelProgram& program);

/// One line of JSON, without its end. `json` is the buffer; `stats`: with what it cost.
void write(JsonLine& json, const MarkingAnswer& answer, const automata::ModelProgram& program, bool stats);

}  // namespace rmpl::runtime
