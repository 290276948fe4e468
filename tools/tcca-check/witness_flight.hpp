// Runs of the verifier as flights that a report can show.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/report/flight.hpp"
#include "tools/shared/report_file.hpp"
#include "verifier/property/property.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/fault_table.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::tools {

/// How a run is to be named, and what it shows.
struct Shown {
  std::string name;
  std::string verdict;
  std::string finding;
};

/// The modes are those of the plant: the truth. Steps of one moment stand a nanosecond apart, so that each can be
/// looked at. `period` as in CheckOptions.
runtime::Flight flight_of(const verifier::Subject& subject, const verifier::Witness& witness,
                          std::optional<automata::Ticks> period, const Shown& shown);

/// Every run that an answer has: the witness, those with other causes, and those of cut sets.
std::vector<runtime::Flight> flights_of(const verifier::Subject& subject, const std::string& name,
                                        const verifier::Property& property, const verifier::CheckOptions& options,
                                        const verifier::Answer& answer);
/// Every run of a table of faults.
std::vector<runtime::Flight> flights_of(const verifier::Subject& subject, const verifier::FaultTable& table,
                                        std::optional<automata::Ticks> period);

/// The option `--report`: the file, where one is asked for.
class TraceReport {
 public:
  TraceReport(const std::string& path, const verifier::Subject& subject);
  /// Writes the runs; says so where there is none, unless `quiet`, and removes the page of an earlier run.
  void write(std::vector<runtime::Flight> flights, const verifier::Subject& subject, bool quiet);

 private:
  std::optional<ReportFile> file_;
};

}  // namespace rmpl::tools
