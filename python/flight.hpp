// A scenario that was flown, with all that is told of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "python/model.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "runtime/report/flight.hpp"

namespace rmpl::python {

class Flight {
 public:
  /// Flies it. Throws base::InputError where the plant has no state to be in.
  Flight(ModelPointer model, const std::optional<std::string>& scenario, const runtime::ScenarioOptions& options,
         runtime::TraceDetail detail);

  [[nodiscard]] std::string result() const;  ///< as `rmpl-run scenario --format json` has it
  [[nodiscard]] const std::string& trace() const { return trace_; }
  [[nodiscard]] const std::string& story() const { return story_; }
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string vcd() const;
  [[nodiscard]] std::string mcap() const;
  /// What the report draws, in DOT, and the report with what was laid out of it; `missing` says why it was not.
  [[nodiscard]] std::string program_dot() const;
  [[nodiscard]] std::string plant_dot() const;
  [[nodiscard]] std::string html(const std::string& title, const std::string& program, const std::string& plant,
                                 const std::string& missing) const;

 private:
  ModelPointer model_;
  const automata::Scenario& scenario_;
  runtime::ScenarioResult result_;
  runtime::Flight data_;
  std::string trace_;
  std::string story_;
};

}  // namespace rmpl::python
