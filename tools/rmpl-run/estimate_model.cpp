// One answer a line of the log: as JSON, or for people.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/estimate_model.hpp"

#include <chrono>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/limit_error.hpp"
#include "runtime/executive/answer/marking_log_estimator.hpp"
#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/rmpl-run/answer_log.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

using automata::ModelProgram;
using runtime::LogLine;

/// Answers a log line by line.
class ModelFlight {
 public:
  ModelFlight(const ModelProgram& program, const ModelEstimateOptions& options)
      : program_(program),
        options_(options),
        estimator_(program, options.estimator, &interruption(), [this](double seconds) { latency_.add(seconds); }) {
    if (!estimator_.starts()) refuse_start(program, options.model);
  }

  /// Until it is asked again; nothing where an interruption came within it.
  std::optional<std::string_view> answer(const LogLine& line, const std::string& name) {
    try {
      const runtime::MarkingAnswer& answer = estimator_.answer(line);
      if (options_.text) return text_ = as_text(answer, program_);
      write(json_, answer, program_, options_.stats);
      return json_.raw("\n").text();
    } catch (const runtime::Interrupted&) {
      return std::nullopt;
    } catch (const runtime::TooManyStates& error) {
      throw base::LimitError(name + ":" + std::to_string(line.number) + ": " + error.what() +
                             (options_.estimator.window > 0
                                  ? "; expected no --window, or independent groups of fewer states"
                                  : "; expected -k, to list the best of them, or --estimator k-best"));
    }
  }

  [[nodiscard]] const runtime::LogAccount& account() const { return estimator_.account(); }

  void report(double seconds) {
    runtime::MarkingEstimator& estimator = estimator_.estimator();
    std::ostringstream text;
    text << latency_.count() << " cycles, " << estimator.groups() << " independent group"
         << (estimator.groups() == 1 ? "" : "s") << ", " << account().checked << " candidates checked, "
         << estimator.questions() << " questions to the store, " << estimator.solver_calls() << " solver calls, "
         << seconds << " s\n";
    if (latency_.count() > 0) text << "a cycle: " << latency_.text() << '\n';
    text << "missing mass: at most " << account().missing << "; dropped in one update: at most " << account().dropped
         << '\n';
    print_error(text.str());
  }

 private:
  const ModelProgram& program_;
  const ModelEstimateOptions& options_;
  Latency latency_;
  runtime::MarkingLogEstimator estimator_;
  runtime::JsonLine json_;
  std::string text_;
};

}  // namespace

ExitStatus estimate_model(const ModelProgram& program, const ModelEstimateOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto lines = check_log(options.log, program, options.reading);
  ModelFlight flight(program, options);
  const bool early =
      answer_log(options.log, program, options.reading, lines,
                 [&](const LogLine& line, const std::string& name) { return flight.answer(line, name); });
  if (flight.account().cut) tell("a search ended early; a belief may lack markings");
  if (flight.account().lacking > runtime::told_missing && !options.quiet) {
    tell(runtime::missing_text(flight.account().lacking));
  }
  if (options.stats) flight.report(seconds_since(begin));
  return early ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace rmpl::tools
