// A session of `rmpl-run step`: commands in, what comes of them out.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/painter.hpp"
#include "runtime/executive/step/flight_steps.hpp"
#include "runtime/executive/step/stepped_run.hpp"
#include "runtime/executive/step/trace_steps.hpp"
#include "tools/rmpl-run/step_model.hpp"

namespace rmpl::tools {

/// Answers go to standard output. A command that is wrong changes nothing.
class StepSession {
 public:
  /// `trace`: the text of one that is stepped through in place of a flight, and the name of its file; empty: none.
  StepSession(StepModel& model, const std::string& trace, const std::string& trace_name, const Common& common);

  /// Where the session begins.
  void greet();
  /// Does what a line says; false where it says to quit. Throws base::InputError where the command is wrong, or what it
  /// asks for cannot be, and Rejected where a formula is wrong and its diagnostics have been told.
  bool obey(const std::string& line);
  /// The words that a line can begin with, and the names and values that may follow.
  [[nodiscard]] std::vector<std::string> words() const;

 private:
  struct Verb {
    const char* name;
    char letter;
    const char* arguments;
    const char* meaning;
    void (StepSession::*run)(const std::string& rest);
  };
  static const std::vector<Verb>& verbs();
  [[nodiscard]] static const Verb& verb_of(const std::string& word);

  void next(const std::string& rest);
  void to(const std::string& rest);
  void until(const std::string& rest);
  void back(const std::string& rest);
  void goal(const std::string& rest);
  void fault(const std::string& rest);
  void command(const std::string& rest);
  void observe(const std::string& rest);
  void why(const std::string& rest);
  void show(const std::string& rest);
  void save(const std::string& rest);
  void help(const std::string& rest);
  void quit(const std::string& rest);

  void choose(const std::vector<std::string>& numbers);
  /// Steps until `enough` says so, the run is over, or a signal comes; whether `enough` did.
  bool go_on(const std::function<bool()>& enough, const runtime::SteppedRun::Look& look);
  void go_to(std::uint64_t position);
  void reopen(std::uint64_t position);
  void tell_story();
  void show_stop();
  [[nodiscard]] runtime::FlightSteps& flight(const char* what);

  StepModel& model_;
  const Common& common_;
  base::Painter painter_;
  std::unique_ptr<runtime::FlightSteps> flight_;  ///< null where a trace is stepped through
  std::unique_ptr<runtime::TraceSteps> trace_;
  runtime::SteppedRun* run_;
  bool quit_ = false;
};

}  // namespace rmpl::tools
