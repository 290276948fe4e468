// Reads a trace back as the records of its cycles: what looks on at a flight can look on at its trace.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "automata/json/parse.hpp"
#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/log_names.hpp"

namespace rmpl::runtime {

class ToldEstimator;

/// Adds a line to what all lines before it come to. A line that tells changes (key `delta`) changes what they said, by
/// name where a key holds names; any other line says all anew.
void merge_line(automata::Json& whole, const automata::Json& line);

/// Of a trace of any detail. Cycles in which nothing changed were left out of it, and have no record. What a trace does
/// not tell a record does not have: times that things took, and of traces without beliefs all but the estimate, which
/// then is certain.
class TraceReader {
 public:
  /// Turns the text of a goal that is no assignment of modes into a formula. Throws base::InputError.
  using Constraint = std::function<automata::Formula(const std::string& text)>;

  /// Keeps references. `name` is the file's, for messages.
  TraceReader(std::istream& in, std::string name, const automata::Plant& plant, const automata::Program& program,
              Constraint constraint);
  ~TraceReader();

  /// The next one, which stands until the call after; null at the end. A last line that was never finished, as of a
  /// process that was killed, is no line. Throws base::InputError, located by file and line, where a line is none of a
  /// trace of this plant and program.
  const CycleRecord* next();
  /// What made readings of the samples, for those who look on: a trace does not tell. Keeps a reference.
  void know(const std::vector<automata::Monitor>& monitors) { record_.monitors = &monitors; }

 private:
  [[nodiscard]] std::optional<std::string> next_text();
  void interpret(const automata::Json& line);
  void read_channels(const automata::Json& line);
  void read_marking();
  void read_goals();
  void read_reason();
  void read_events();
  void read_evidence(const automata::Json& line);
  void read_belief(const automata::Json& line);
  [[nodiscard]] automata::Modes named_modes(const automata::Json& names) const;
  [[nodiscard]] automata::ComponentId component_of(const automata::Json& object) const;
  [[nodiscard]] automata::ModeId mode_of(automata::ComponentId component, const automata::Json& name) const;
  [[nodiscard]] automata::LocationId location_of(const automata::Json& number) const;
  [[nodiscard]] std::optional<TransitionOf> transition_of(const automata::Json& object) const;
  [[nodiscard]] std::vector<automata::Assignment> assignments_of(const automata::Json& object) const;

  std::istream& in_;
  std::string name_;
  const automata::Plant& plant_;
  LogNames names_;
  const automata::Program& program_;
  Constraint constraint_;
  std::istringstream line_;
  LogReader reader_;
  automata::Json whole_;  ///< what all lines so far come to
  bool begun_ = false;
  automata::Modes truth_;
  std::vector<std::string> channels_;  ///< by the order in which they come first
  std::unique_ptr<ToldEstimator> estimator_;
  CycleRecord record_;
};

}  // namespace rmpl::runtime
