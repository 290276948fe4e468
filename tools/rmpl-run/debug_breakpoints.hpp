// Where a debugger is to stop: lines, conditions, modes that change, and what the executive reports.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/json/parse.hpp"
#include "runtime/executive/step/flight_steps.hpp"

namespace rmpl::tools {

/// What stopped a run.
struct DebugHit {
  const char* reason = "";                       ///< as the protocol names it
  std::vector<int> ids;                          ///< of breakpoints
  std::string text;                              ///< in words
  std::optional<automata::LocationId> location;  ///< of a line of a program
};

/// Each call of `set_…` takes the place of the one before, of its kind and file. The flight is that of the session, and
/// there by then; conditions are bound to it. Where it is another one, `bind` is called.
class DebugBreakpoints {
 public:
  using Json = automata::Json;

  void bind(runtime::FlightSteps& flight);
  Json set_lines(const std::string& path, const Json& lines);
  Json set_conditions(const Json& breakpoints);
  Json set_data(const Json& breakpoints);
  /// Throws base::InputError where there is no such filter.
  void set_reports(const Json& filters);

  /// After a cycle: what it hit, if anything. To be asked of every cycle.
  std::optional<DebugHit> look(const runtime::CycleRecord& record, bool ended);
  /// What the start hits: locations that are marked there.
  std::optional<DebugHit> look_at_start();
  /// The run went back: what was so before is as of now.
  void look_anew();

 private:
  struct Line {
    int id;
    std::string path;
    std::vector<automata::LocationId> locations;                            ///< of the program, that begin on the line
    std::vector<std::pair<automata::ComponentId, automata::ModeId>> modes;  ///< of the plant, declared on it
  };
  struct Condition {
    int id;
    std::string text;
    bool truth = false;
    automata::Formula formula;
    std::unique_ptr<runtime::Watch> watch;
    bool held = false;
  };
  struct Data {
    int id;
    automata::ComponentId component;
    bool truth = false;
  };

  void watch(Condition& condition);
  std::optional<DebugHit> newly_marked(bool all);

  runtime::FlightSteps* flight_ = nullptr;
  int last_id_ = 0;
  std::vector<Line> lines_;
  std::vector<Condition> conditions_;
  std::vector<Data> data_;
  std::set<std::string> reports_;
  automata::Marking marking_;  ///< before the last cycle
  automata::Modes estimate_, truth_;
};

/// A condition with `truth` before it, or without.
struct DebugCondition {
  bool truth = false;
  automata::Formula formula;
};
/// Reads a condition over a plant. Throws base::InputError with the reason where it is wrong.
DebugCondition debug_condition(const std::string& text, const automata::Plant& plant, bool has_truth);

/// Where a file is, whatever links lead to it.
std::string canonical_path(const std::string& path);

}  // namespace rmpl::tools
