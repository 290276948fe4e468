// rmpl-run estimate: commands and observations in, beliefs out.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "runtime/executive/answer/marking_log_estimator.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/rmpl-run/answer_log.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/estimate_model.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/rmpl-run/log_options.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using runtime::LogLine;

using Engine = runtime::LogEstimatorOptions::Engine;

struct EstimateOptions {
  std::string plant;
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  std::string log;
  std::string script;
  LogOptions reading;
  runtime::LogEstimatorOptions estimator;
  bool beam = false;
  bool text = false;
};

constexpr const char* estimate_footer =
    R"(Each line of the log is a JSON object: "time" in seconds, the "command" that was in force since the
line before (absent variables are idle), and the "observations" at that time. For each a line comes out:
"time", the most likely modes as "estimate", and the "belief", most probable first, with the clocks that
count in seconds since they started. The first step is from time 0 and the initial distribution; lines before it,
at time 0 and without a "command", tell what is seen at the start. Several lines may have one time. A
trace of rmpl-run scenario is such a log. What comes from standard input is answered line by line.
A time may also be a duration with a unit, a date (ISO 8601, Unix time) or a mission time (T+4:34:45).
It is rounded to a nanosecond. A CSV file names its columns in its first row: a time, and channels of the
monitors, observed attributes or control variables. With --monitors a line of JSON may have numbers, as
"observations", below "channels", or by their names; an answer has "observations" and "channels". Samples that are out of order, doubled, before the origin or in another
unit of time are left out; standard error says how many.
Where a search ended early, the line says "cut": true, and its belief may lack states.
Of a model program a line has, in place of modes, the "marking" of the most likely entry and what it
entails as "estimate"; an entry of the belief has its "marking" and "values". Each line is a step. With
--window, also of a plant, there is the "history", trajectories best first, and "revised": where the best
now differs from what it was after the line before.
"missing_mass" is an upper bound of the probability of all states that a line does not list; where it is
above 1 %, standard error says so at the end. Readings that nothing explains are "set_aside". With --stats
a line also has "checked", the candidates that were checked, and "dropped", at most what this update left
out of all that follows from the belief before. With --ranks states have a "rank" in place of a probability.

exit code: 0 done; 2 an input is wrong, and of a file nothing was answered; 3 interrupted, or a limit was reached

examples:
  rmpl-run estimate lander.tcca --log flight.jsonl
  rmpl-run estimate lander.tcca --log flight.jsonl --estimator exact
  rmpl-run estimate pump.tcca --log data.csv --monitors pump.mon --origin first --text
  rmpl-run estimate lander.tcca --log downlink.jsonl --origin 2023-11-14T22:13:20Z
  rmpl-run estimate lander.tcca --log flight.jsonl -k 64 --deadline 5ms --stats
  rmpl-run estimate lander.tcca --log flight.jsonl -k 5 --ranks
  rmpl-run estimate camera.rmpl --log flight.jsonl --window 20 --text
  telemetry | rmpl-run estimate lander.tcca --log -
  echo '{"time": 0.5, "command": {"engine.cmd": "standby"}}' | rmpl-run estimate lander.tcca --log -)";

void report(const runtime::LogEstimator& flight, const Latency& latency, bool ranks, double seconds) {
  const runtime::LogAccount& account = flight.account();
  const runtime::Estimator& estimator = flight.estimator();
  const std::size_t groups = estimator.groups();
  std::ostringstream text;
  text << latency.count() << " cycles, " << groups << " independent group" << (groups == 1 ? "" : "s") << ", "
       << account.checked << " candidates checked, " << estimator.questions() << " questions to the store, "
       << estimator.solver_calls() << " solver calls, " << seconds << " s\n";
  if (latency.count() > 0) text << "a cycle: " << latency.text() << '\n';
  if (!ranks) {
    text << "missing mass: at most " << account.missing << "; dropped in one update: at most " << account.dropped
         << '\n';
  }
  print_error(text.str());
}

/// Answers a log line by line.
class Flight {
 public:
  Flight(const automata::Plant& plant, const EstimateOptions& options)
      : plant_(plant), options_(options), estimator_(plant, options.estimator) {
    if (!estimator_.starts()) {
      throw base::InputError(options.plant +
                             ": no initial state is possible: the initial modes contradict the interconnections");
    }
  }

  ~Flight() { estimator_.give_up(); }
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  /// The answer to the next line, until it is asked again; `name` is the log's, for messages. Nothing where an
  /// interruption came within it.
  std::optional<std::string_view> answer(const LogLine& line, const std::string& name) {
    const auto at_line = [&] { return name + ":" + std::to_string(line.number) + ": "; };
    try {
      const runtime::PlantAnswer answer = estimator_.answer(line);
      if (options_.text) return text_ = as_text(answer, plant_);
      writer_.write(json_, answer, plant_, [] {
        if (interrupted()) throw runtime::Interrupted();
      });
      return json_.raw("\n").text();
    } catch (const runtime::Interrupted&) {
      return std::nullopt;
    } catch (const runtime::MemorySpent& error) {
      throw base::LimitError(at_line() + error.what() +
                             "; expected more, independent groups of fewer states, or --estimator k-best");
    } catch (const runtime::TooManyStates& error) {
      throw base::LimitError(at_line() + error.what() +
                             (options_.estimator.window
                                  ? "; expected no --window, or independent groups of fewer states"
                                  : "; expected -k, to list the best of them, or --estimator k-best"));
    }
  }

  [[nodiscard]] const runtime::LogEstimator& estimator() const { return estimator_; }

 private:
  const automata::Plant& plant_;
  const EstimateOptions& options_;
  runtime::LogEstimator estimator_;
  runtime::AnswerWriter writer_;
  runtime::JsonLine json_;
  std::string text_;
};

/// A model program is estimated by markings.
ExitStatus run_model(const automata::ModelProgram& program, const EstimateOptions& options, const Common& common) {
  if (is_about_plants(options.estimator)) {
    throw base::InputError(options.plant +
                           ": --thesis, --ranks, --live-clocks, --all-clocks, --deadline and --max-memory apply to "
                           "plants, but this is a model program");
  }
  ModelEstimateOptions own;
  own.model = options.plant;
  own.log = options.log;
  own.reading = options.reading;
  own.estimator = marking_options(options.estimator, options.beam);
  own.text = options.text;
  own.stats = options.estimator.stats || common.verbose;
  own.quiet = common.quiet;
  return estimate_model(program, own);
}

ExitStatus run(EstimateOptions options, const Common& common) {
  const auto begin = std::chrono::steady_clock::now();
  check_standard_input({options.plant, options.log, options.reading.monitors_file});
  const compiler::Compilation compilation = load({options.plant}, common, {.main = options.main});
  if (is_model_program(compilation.document())) {
    if (!options.reading.monitors_file.empty() || options.reading.period || options.reading.script) {
      throw base::InputError(options.plant +
                             ": --monitors, --cycle and --scenario apply to plants, but this is a model program");
    }
    return run_model(only_model_program(compilation.document(), options.plant), options, common);
  }
  if (options.beam) throw base::InputError(options.plant + ": --beam applies to model programs, but this is a plant");
  if (options.estimator.window && (options.estimator.thesis || options.estimator.ranks || options.estimator.deadline)) {
    throw base::InputError("--window computes exact probabilities: use it without --thesis, --ranks and --deadline");
  }
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  if (!options.reading.monitors_file.empty()) {
    options.reading.monitors = load_monitors(options.reading.monitors_file, plant, common);
    options.estimator.sampled = runtime::Monitors(options.reading.monitors).channels();
  }
  const auto lines = check_log(options.log, plant, options.reading);
  Latency latency;
  options.estimator.interruption = &interruption();
  if (options.estimator.stats || common.verbose) {
    options.estimator.took = [&latency](double seconds) { latency.add(seconds); };
  }
  std::optional<Flight> begun;
  try {
    begun.emplace(plant, options);
  } catch (const runtime::Interrupted&) {
    tell("interrupted before the first line");
    return ExitStatus::undecided;
  } catch (const runtime::MemorySpent& error) {
    throw base::LimitError(options.plant + ": the belief at the start: " + error.what());
  }
  Flight& flight = *begun;
  const bool early =
      answer_log(options.log, plant, options.reading, lines,
                 [&](const LogLine& line, const std::string& name) { return flight.answer(line, name); });
  if (flight.estimator().account().cut) tell("a search ended early; a belief may lack states");
  if (options.estimator.weighs() && flight.estimator().account().lacking > runtime::told_missing && !common.quiet) {
    tell(runtime::missing_text(flight.estimator().account().lacking));
  }
  if (flight.estimator().account().searched)
    tell(
        "a group of components has too many histories to sum over all of them: probabilities are shares among the best "
        "ones");
  if (flight.estimator().account().history_cut)
    tell("a search for histories ended early; the output has the best histories, but fewer than requested");
  if (options.estimator.stats || common.verbose) {
    report(flight.estimator(), latency, options.estimator.ranks, seconds_since(begin));
  }
  return early ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_estimate(Program& program) {
  Command command = program.add_command("estimate", "estimate the state of a plant from a log");
  const auto options = std::make_shared<EstimateOptions>();
  add_plant(command, options->plant, options->main);
  Option log = command.add_option("--log", options->log, "commands and observations; - is standard input")
                   .option_text("IN.jsonl|IN.csv");
  Option script = command
                      .add_option("--scenario", options->script,
                                  "the log as a scenario of Livingstone2, one step per second or per --cycle")
                      .option_text("FILE.scr");
  command.require_one(log, script);
  add_log_times(command, options->reading);
  add_telemetry(command, options->reading);
  add_choice<Engine>(command, "--estimator", options->estimator.engine,
                     {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "keep the whole belief, or only its best states (default: k-best)");
  add_k(command, options->estimator.k);
  add_read(command, "--deadline", options->estimator.deadline, positive_duration,
           "time limit of one update; the best states found by then are kept")
      .option_text("TIME");
  add_read(command, "--max-memory", options->estimator.bytes, memory_size,
           "with exact: stop at this memory use; the belief grows with the product of the components")
      .option_text("BYTES[K|M|G]");
  command.add_flag("--thesis", options->estimator.thesis,
                   "k-best as in Fig. 6-11 of the thesis: no sum over trajectories that meet,\nno observation factor, "
                   "no normalisation");
  command.add_flag("--ranks", options->estimator.ranks,
                   "rank as Livingstone2 does: by powers of ten, without the observation factor, keeping all\nstates "
                   "that are as good as the k-th");
  Option all_clocks = command.add_flag("--all-clocks", options->estimator.all_clocks,
                                       "keep every clock, even if nothing depends on it");
  command
      .add_flag("--live-clocks", options->estimator.live_clocks,
                "drop the clock of a component while nothing depends on it (default, except with --thesis)")
      .excludes(all_clocks);
  command.add_flag("--beam", options->beam,
                   "model programs: keep the k most likely markings before the factors of the readings apply,\nas the "
                   "paper on model programs does");
  add_whole_number(command, "--window", options->estimator.window, 1, 1'000,
                   "write the k most likely histories of the last N updates, given all later readings");
  command.add_flag("--text", options->text,
                   "write text for people; for a model program, with the source of each marked location");
  command.add_flag("--stats", options->estimator.stats, "print the cost on standard error");
  command.footer(estimate_footer);
  program.add({command,
               [options, &common = program.common()] {
                 options->reading.quiet = common.quiet;
                 options->reading.script = !options->script.empty();
                 if (options->reading.script) options->log = options->script;
                 if (options->estimator.bytes && options->estimator.engine != Engine::exact) {
                   throw base::InputError(
                       "--max-memory limits the exact belief, and k-best keeps only its best states; use it with "
                       "--estimator exact");
                 }
                 if (options->estimator.engine == Engine::exact &&
                     (options->estimator.thesis || options->estimator.ranks || options->estimator.deadline)) {
                   throw base::InputError(
                       "--thesis, --ranks and --deadline configure k-best; use them with --estimator k-best");
                 }
                 if (options->beam && (options->estimator.engine == Engine::exact || options->estimator.window)) {
                   throw base::InputError(
                       "--beam replaces the estimator: use it without --estimator exact and without --window");
                 }
                 if (options->estimator.thesis && options->estimator.ranks) {
                   throw base::InputError("--thesis and --ranks are alternative ways to rank states; use one of them");
                 }
                 return within_limits([&] { return run(*options, common); });
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
