// Runs a scenario from start to verdict.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "automata/scenario.hpp"
#include "runtime/executive/plant/luck.hpp"
#include "runtime/executive/scenario/expectations.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

struct ScenarioOptions {
  enum class Engine { exact, k_best };
  std::optional<std::uint64_t> seed;  ///< instead of the scenario's own
  Engine engine = Engine::k_best;
  enum class Recovery { planner, one_step };
  Recovery recovery = Recovery::planner;
  std::shared_ptr<const NominalGraph> graph = nullptr;  ///< of the scenario's plant, where it was computed before
  std::size_t k = 16;                                   ///< system states that k-best keeps
  std::vector<automata::ForcedMode> awaited = {};       ///< faults besides the scenario's, as SimulatedPlant has them
  LuckUse luck = {};                                    ///< of the plant, where it is one of components
  bool real_time = false;                               ///< a cycle takes as long as it says
  bool measured = false;                                ///< records tell what the engines take
  std::function<bool()> interrupted = [] { return false; };  ///< asked once a cycle, and while waiting in real time
};

struct ScenarioResult {
  std::uint64_t seed = 0;
  std::uint64_t cycles = 0;              ///< that were run
  automata::Ticks time;                  ///< at the end of the last one
  std::optional<automata::Ticks> ended;  ///< when the program ended
  bool interrupted = false;
  std::vector<Judgement> judgements;  ///< one per expectation

  /// `failed` where an expectation failed, else `undecided` where one is or the run was interrupted, else `met`.
  [[nodiscard]] Judgement::Verdict verdict() const;
};

/// The run is over when its duration is; or when the program has ended and no expectation but `never` is open, unless
/// such a one is and the scenario has something in store, or what it forces waits for an occasion. Observers see every
/// cycle, from cycle 0 on, in order. Throws base::InputError where the model leaves the simulated plant no state to be
/// in.
ScenarioResult run_scenario(const automata::Document& document, const automata::Scenario& scenario,
                            const ScenarioOptions& options, const std::vector<CycleObserver*>& observers);

}  // namespace rmpl::runtime
