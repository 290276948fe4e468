// A log of a plant answered line by line: what was commanded and seen goes in, the belief and what most likely happened
// come out.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/answer/estimate_answer.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/window/plant_window.hpp"

namespace rmpl::runtime {

struct LogEstimatorOptions {
  enum class Engine { exact, k_best };
  Engine engine = Engine::k_best;
  std::optional<std::size_t> k;
  std::optional<automata::Ticks> deadline;  ///< k-best: of one update
  std::optional<std::size_t> bytes;         ///< exact: of memory
  bool thesis = false;                      ///< k-best as Fig. 6-11 has it
  bool ranks = false;                       ///< k-best: powers of ten in place of probabilities
  bool all_clocks = false;
  bool live_clocks = false;                            ///< with `thesis`, where no clock is forgotten otherwise
  bool stats = false;                                  ///< an answer tells what it cost
  std::optional<std::size_t> window;                   ///< tell the most likely histories of so many updates
  std::optional<std::vector<std::string>> sampled;     ///< the channels of monitors, where there are some
  const std::atomic<bool>* interruption = nullptr;     ///< set from outside, it ends an answer: throws Interrupted
  std::function<void(double seconds)> took = nullptr;  ///< called with what an update took, where it is measured

  /// Whether clocks that make no difference are forgotten. The clocks of Fig. 6-11 are all there are.
  [[nodiscard]] bool forgets_clocks() const { return live_clocks || (!all_clocks && !thesis); }
  /// Whether probabilities are those of the exact estimator, as far as nothing is missing.
  [[nodiscard]] bool weighs() const { return !thesis && !ranks; }
};

/// Over all lines that were answered.
struct LogAccount {
  std::size_t updates = 0;
  std::size_t checked = 0;  ///< candidates
  double dropped = 0;       ///< the most in any line, as is the next
  double missing = 0;
  double lacking = 0;  ///< the most that may be missing from a belief, listed or not, or that one update dropped
  bool cut = false;    ///< a search ended early
  bool searched = false, history_cut = false;  ///< of the window: a group was searched, and that ended early
};

class LogEstimator {
 public:
  /// Keeps the reference to the plant. Throws Interrupted, MemorySpent.
  LogEstimator(const automata::Plant& plant, LogEstimatorOptions options);

  /// Whether some initial state is possible. Where none is, nothing can be answered.
  [[nodiscard]] bool starts() const { return estimator_->estimate().consistent; }

  /// Takes a line in. What is told of it stands until the next call; `line` outlives that. Throws Interrupted,
  /// MemorySpent, TooManyStates: what was to be worked out is lost then.
  PlantAnswer answer(const LogLine& line);

  [[nodiscard]] const LogAccount& account() const { return account_; }
  [[nodiscard]] const Estimator& estimator() const { return *estimator_; }
  /// To be called where the process ends: millions of states are not freed one by one, which takes seconds.
  void give_up();

 private:
  /// What a line says of its step.
  struct Step {
    std::vector<automata::Assignment> command;
    automata::Observation observations;
  };

  [[nodiscard]] EstimatorOptions estimator_options() const;
  [[nodiscard]] Belief listed(const Belief& belief) const;
  void take_in(const automata::Observation& observation);
  void update(const Step& told, automata::Ticks time, bool answered);
  void list_belief();
  void tell_history();

  const automata::Plant& plant_;
  const LogEstimatorOptions options_;
  std::unique_ptr<Estimator> estimator_;
  std::optional<ClockTable> live_;  ///< where the others are forgotten
  LogAccount account_;
  bool begun_ = false;  ///< a step was taken
  automata::Observation at_start_;
  Step before_;
  Belief belief_;
  bool stayed_ = false;        ///< since it was listed
  bool tells_clocks_ = false;  ///< of it, which grow
  UpdateCost cost_;
  std::optional<PlantWindow> window_;
  std::vector<PlantTrajectory> found_;  ///< by it, after the last line
  PlantHistory history_;
  std::vector<automata::Ticks> times_{automata::Ticks{}};  ///< of what the window sets out from, and of updates since
};

}  // namespace rmpl::runtime
