// rmpl-run estimate: commands and observations in, beliefs out.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/plant_window.hpp"
#include "tools/rmpl-run/answer_log.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/estimate_answer.hpp"
#include "tools/rmpl-run/estimate_model.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using runtime::Belief;
using runtime::Estimate;
using runtime::Estimator;
using runtime::JsonLine;
using runtime::LogLine;

enum class Engine { exact, k_best };

struct Options {
  std::string plant;
  std::string log;
  Engine engine = Engine::k_best;
  std::optional<std::size_t> k;
  std::optional<automata::Ticks> deadline;
  bool thesis = false;
  bool ranks = false;
  bool live_clocks = false;
  bool stats = false;
  bool beam = false;
  std::optional<std::size_t> window;
  bool text = false;
};

constexpr const char* footer =
    R"(Each line of the log is a JSON object: "time" in seconds, the "command" that was in force since the
line before (absent variables are idle), and the "observations" at that time. For each a line comes out:
"time", the most likely modes as "estimate", and the "belief", most probable first, with clocks in
seconds since they started. The first step is from time 0 and the initial distribution; lines before it,
at time 0 and without a "command", tell what is seen at the start. Several lines may have one time. A
trace of rmpl-run scenario is such a log. What comes from standard input is answered line by line.
Where a search ended early, the line says "cut": true, and its belief may lack states.
Of a model program a line has, in place of modes, the "marking" of the most likely entry and what it
entails as "estimate"; an entry of the belief has its "marking" and "values". Each line is a step. With
--window, also of a plant, there is the "history", trajectories best first, and "revised": where the best
now differs from what it was after the line before.
With --stats a line also has "checked", the candidates that were checked; "dropped", at most what this
update left out of all that follows from the belief before; and "missing_mass", an upper bound of the
probability of all states that it does not list. With --ranks states have a "rank" in place of a
probability.

exit code: 0 done; 2 an input is wrong, and of a file nothing was answered; 3 interrupted

examples:
  rmpl-run estimate lander.tcca --log flight.jsonl
  rmpl-run estimate lander.tcca --log flight.jsonl --estimator exact
  rmpl-run estimate lander.tcca --log flight.jsonl -k 64 --deadline 5ms --stats
  rmpl-run estimate lander.tcca --log flight.jsonl -k 5 --ranks --live-clocks
  rmpl-run estimate camera.rmpl --log flight.jsonl --window 20 --text
  telemetry | rmpl-run estimate lander.tcca --log - --live-clocks
  echo '{"time": 0.5, "command": {"engine.cmd": "standby"}}' | rmpl-run estimate lander.tcca --log -)";

runtime::EstimatorOptions estimator_options(const Options& options) {
  runtime::EstimatorOptions estimator;
  if (options.k) estimator.k = estimator.listed = *options.k;
  if (options.deadline) estimator.deadline = std::chrono::nanoseconds(options.deadline->count);
  const bool as_is = options.thesis || options.ranks;
  estimator.merge_trajectories = estimator.observation_factor = estimator.normalise = !as_is;
  estimator.ranks = options.ranks;
  estimator.live_clocks_only = options.live_clocks;
  estimator.account = options.stats;
  estimator.interruption = &interruption();
  return estimator;
}

std::unique_ptr<Estimator> make_estimator(automata::PlantStep& step, const Options& options) {
  switch (options.engine) {
    case Engine::exact:
      return runtime::make_exact_estimator(step, estimator_options(options));
    case Engine::k_best:
      return runtime::make_k_best_estimator(step, estimator_options(options));
  }
  return nullptr;
}

/// The head of a belief: all of it, but with `exact` no more than was asked for.
Belief listed(const Belief& belief, const Options& options) {
  const std::size_t most = options.engine == Engine::exact && options.k ? *options.k : belief.size();
  return {belief.begin(), belief.begin() + static_cast<std::ptrdiff_t>(std::min(belief.size(), most))};
}

/// An upper bound of the probability of what a line does not list. A belief that is listed in full adds up to 1 but for
/// rounding.
double unlisted(const Estimate& estimate, const Belief& belief) {
  constexpr double rounding = 1e-12;
  const double missing = 1 - (1 - estimate.missing_total) * std::min(1.0, runtime::total(belief));
  return missing > rounding ? missing : estimate.missing_total;
}

/// What it cost, over all updates.
struct Account {
  Latency latency;
  std::size_t checked = 0;
  double dropped = 0;  ///< the most in any line, as is the next
  double missing = 0;
};

void report(const Account& account, const Estimator& estimator, bool ranks, double seconds) {
  const std::size_t groups = estimator.groups();
  std::ostringstream text;
  text << account.latency.count() << " cycles, " << groups << " independent group" << (groups == 1 ? "" : "s") << ", "
       << account.checked << " candidates checked, " << estimator.questions() << " questions to the store, "
       << estimator.solver_calls() << " solver calls, " << seconds << " s\n";
  if (account.latency.count() > 0) text << "a cycle: " << account.latency.text() << '\n';
  if (!ranks) {
    text << "missing mass: at most " << account.missing << "; dropped in one update: at most " << account.dropped
         << '\n';
  }
  print_error(text.str());
}

/// Answers a log line by line.
class Flight {
 public:
  Flight(const automata::Plant& plant, const Options& options)
      : plant_(plant), options_(options), step_(plant), estimator_(make_estimator(step_, options)) {
    if (options.live_clocks) live_ = runtime::live_clocks(plant);
    if (!estimator_->estimate().consistent) {
      throw base::InputError(options.plant +
                             ": no initial state is possible: the initial modes contradict the interconnections");
    }
    if (options.window) {
      window_.emplace(plant, estimator_options(options), options.engine == Engine::exact, *options.window);
    }
  }

  /// The answer to the next line; `name` is the log's, for messages. Nothing where an interruption came within it.
  std::optional<std::string> answer(const LogLine& line, const std::string& name) {
    Belief belief;
    const bool start = !begun_ && line.is_of_start();
    try {
      if (start) {
        take_in(line.observations);
        estimator_->start(at_start_);
        if (window_) {
          window_->start(at_start_);
          found_ = window_->trajectories();
        }
      } else {
        // Cycles that were left out went as the line before says.
        for (std::uint64_t i = 1; i <= line.unchanged; ++i) {
          if (interrupted()) return std::nullopt;
          update(before_, line.time_of_unchanged(i), false);
        }
        update(line, line.time, true);
      }
      belief = listed(estimator_->belief(), options_);
      if (window_) tell_history();
    } catch (const runtime::Interrupted&) {
      return std::nullopt;
    } catch (const runtime::TooManyStates& error) {
      throw base::LimitError(name + ":" + std::to_string(line.number) + ": " + error.what() +
                             (options_.window ? "; expected no --window, or independent groups of fewer states"
                                              : "; expected -k, to list the best of them, or --estimator k-best"));
    }
    const Estimate& estimate = estimator_->estimate();
    const UpdateCost cost{estimate.checked, estimate.missing_mass, unlisted(estimate, belief)};
    if (!start) {
      cut_ = cut_ || estimate.cut;
      account_.checked += cost.checked;
      account_.dropped = std::max(account_.dropped, cost.dropped);
      account_.missing = std::max(account_.missing, cost.missing);
    }
    before_ = line;
    write(json_,
          {line, estimate, belief, options_.stats ? &cost : nullptr, window_ ? &history_ : nullptr,
           live_ ? &*live_ : nullptr, options_.ranks},
          plant_);
    return std::string(json_.text()) + "\n";
  }

  [[nodiscard]] bool cut() const { return cut_; }
  /// Of the window: whether a group was searched, and whether that ended early.
  [[nodiscard]] bool searched() const { return searched_; }
  [[nodiscard]] bool history_cut() const { return history_cut_; }
  [[nodiscard]] const Account& account() const { return account_; }
  [[nodiscard]] const Estimator& estimator() const { return *estimator_; }

 private:
  /// `answered`: what most likely happened is told after it.
  void update(const LogLine& told, automata::Ticks time, bool answered) {
    begun_ = true;
    const automata::ControlAction action = automata::action_from(plant_, told.command);
    const runtime::Stopwatch stopwatch;
    estimator_->update(action, told.observations, time);
    if (window_) {
      window_->update(action, told.observations, time);
      if (answered) found_ = window_->trajectories();
    }
    account_.latency.add(stopwatch.seconds());
    ++updates_;
    times_.push_back(time);
    if (times_.size() > options_.window.value_or(0) + 1) times_.erase(times_.begin());
  }

  void tell_history() {
    PlantHistory next{times_, std::move(found_), updates_ + 1 - times_.size(), {}, window_->cut()};
    searched_ = searched_ || window_->searched();
    history_cut_ = history_cut_ || next.cut;
    for (std::size_t t = 0; !history_.trajectories.empty() && t < times_.size(); ++t) {
      const auto& last = history_.trajectories.front().states;
      if (next.first + t < history_.first || next.first + t >= history_.first + last.size()) continue;
      const automata::Modes& before = last[next.first + t - history_.first].modes;
      const automata::Modes& now = next.trajectories.front().states[t].modes;
      if (before != now) next.revised.push_back({times_[t], before, now});
    }
    history_ = std::move(next);
  }

  /// Of several readings of one attribute at the start the last counts.
  void take_in(const automata::Observation& observation) {
    for (const automata::Assignment& reading : observation) {
      std::erase_if(at_start_, [&](const automata::Assignment& known) { return known.variable == reading.variable; });
      at_start_.push_back(reading);
    }
    std::sort(at_start_.begin(), at_start_.end());
  }

  const automata::Plant& plant_;
  const Options& options_;
  automata::PlantStep step_;
  std::unique_ptr<Estimator> estimator_;
  std::optional<runtime::ClockTable> live_;  ///< with --live-clocks
  JsonLine json_;
  Account account_;
  bool begun_ = false;  ///< a step was taken
  bool cut_ = false, searched_ = false, history_cut_ = false;
  automata::Observation at_start_;
  LogLine before_;
  std::optional<runtime::PlantWindow> window_;
  std::vector<runtime::PlantTrajectory> found_;  ///< by it, after the last line
  PlantHistory history_;
  std::size_t updates_ = 0;
  std::vector<automata::Ticks> times_{automata::Ticks{}};  ///< of what the window sets out from, and of updates since
};

/// A model program is estimated by markings.
ExitStatus run_model(const automata::ModelProgram& program, const Options& options, const Common& common) {
  if (options.thesis || options.ranks || options.live_clocks || options.deadline) {
    throw base::InputError(options.plant +
                           ": --thesis, --ranks, --live-clocks and --deadline are about plants, and this is a model "
                           "program");
  }
  ModelEstimateOptions own;
  own.model = options.plant;
  own.log = options.log;
  using Kind = runtime::MarkingOptions::Kind;
  own.estimator.kind = options.beam ? Kind::beam : options.engine == Engine::exact ? Kind::exact : Kind::k_best;
  if (options.k) own.estimator.k = own.estimator.listed = *options.k;
  own.estimator.window = options.window.value_or(0);
  own.text = options.text;
  own.stats = options.stats || common.verbose;
  return estimate_model(program, own);
}

ExitStatus run(const Options& options, const Common& common) {
  const auto begin = std::chrono::steady_clock::now();
  check_standard_input({options.plant, options.log});
  const compiler::Compilation compilation = load({options.plant}, common);
  if (is_model_program(compilation.document())) {
    return run_model(only_model_program(compilation.document(), options.plant), options, common);
  }
  if (options.beam || options.text) {
    throw base::InputError(options.plant + ": --beam and --text are about model programs, and this is none");
  }
  if (options.window && (options.thesis || options.ranks || options.deadline)) {
    throw base::InputError("--window weighs exactly: expected none of --thesis, --ranks and --deadline");
  }
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  watch_for_interruption();
  const auto lines = check_log(options.log, plant);
  Flight flight(plant, options);
  const bool early = answer_log(options.log, plant, lines, [&](const LogLine& line, const std::string& name) {
    return flight.answer(line, name);
  });
  if (flight.cut()) tell("a search was cut short; a belief may lack states");
  if (flight.searched())
    tell("a group of components has too many histories to weigh them all: probabilities are shares of the best");
  if (flight.history_cut()) tell("a search for histories was cut short; the best are told, but fewer than wanted");
  if (options.stats || common.verbose) {
    report(flight.account(), flight.estimator(), options.ranks, seconds_since(begin));
  }
  return early ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_estimate(Program& program) {
  CLI::App* command = program.app().add_subcommand("estimate", "tell what state a plant is in, from a log");
  const auto options = std::make_shared<Options>();
  command->add_option("PLANT", options->plant, "a .tcca model, an .rmpl file with a model program, or a compiled .json")
      ->required();
  command->add_option("--log", options->log, "commands and observations; - is standard input")
      ->required()
      ->option_text("IN.jsonl");
  add_choice<Engine>(*command, "--estimator", options->engine, {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "the whole belief, or the best of it (default: k-best)");
  add_k(*command, options->k);
  add_read(*command, "--deadline", options->deadline, positive_duration,
           "how long one update may search; the best states found until then are kept")
      ->option_text("TIME");
  command->add_flag("--thesis", options->thesis,
                    "k-best as Fig. 6-11 of the thesis has it: trajectories that meet are not added up, the\n"
                    "observation factor is not applied, and nothing is normalised");
  command->add_flag("--ranks", options->ranks,
                    "count as Livingstone2 does: probabilities as powers of ten, compared as whole numbers, with no\n"
                    "observation factor, and all states that are as good as the k-th");
  command->add_flag("--live-clocks", options->live_clocks,
                    "forget the clock of a component while nothing depends on it, as the executive does");
  command->add_flag("--beam", options->beam,
                    "model programs: keep the k markings that were most likely before the readings' factors, as the\n"
                    "paper on model programs does");
  add_whole_number(*command, "--window", options->window, 1, 1'000,
                   "tell the k most likely histories of the last N updates, revised by what came since");
  command->add_flag("--text", options->text, "model programs: answer for people, with the source of what is marked");
  command->add_flag("--stats", options->stats, "say on standard error what it cost");
  command->footer(footer);
  program.add(
      {command, [options, &common = program.common()] {
         if (options->engine == Engine::exact && (options->thesis || options->ranks || options->deadline)) {
           throw base::InputError("--thesis, --ranks and --deadline are about k-best; expected --estimator k-best");
         }
         if (options->beam && (options->engine == Engine::exact || options->window)) {
           throw base::InputError("--beam keeps a beam of its own: expected neither --estimator exact nor --window");
         }
         if (options->thesis && options->ranks) {
           throw base::InputError("--thesis and --ranks are two ways to count; expected one of them");
         }
         return within_limits([&] { return run(*options, common); });
       }});
}

}  // namespace rmpl::tools
