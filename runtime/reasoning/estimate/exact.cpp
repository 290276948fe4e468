// The exact estimator: BeliefUpdate of thesis Fig. 6-10 over the whole belief, normalised.
//
// The reference: every positive product of moves of every state is enumerated, so the cost is exponential in the
// number of components.
// SPDX-License-Identifier: MIT
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/listed_filter.hpp"

namespace rmpl::runtime {
namespace {

using automata::Modes;
using automata::Move;
using automata::SystemState;
using automata::Ticks;

/// Probabilities of target states, summed (step 3 of Fig. 6-10).
using Targets = std::unordered_map<SystemState, double, SystemStateHash>;

class Exact final : public ListedFilter {
 public:
  Exact(automata::PlantStep& step, const EstimatorOptions& options)
      : step_(step), options_(options), clocks_(step.plant(), options.live_clocks_only) {
    estimate_.modes = likeliest_initial_modes(step.plant());
    estimate_.consistent = start({});
  }

  bool start(const automata::Observation& observation) override {
    const std::size_t components = step_.plant().components.size();
    const SystemState origin{Modes(components), std::vector<Ticks>(components)};
    Targets initial;
    spread({origin, 1.0}, step_.initial_moves(), Ticks{}, initial);
    const bool explained = weigh(initial, observation);
    if (explained || weigh(initial, {})) settle();
    return explained;
  }

  bool condition(const StepInput& input) override {
    CHECK(input.now >= last_);
    targets_.clear();
    for (const BeliefEntry& entry : belief_) {
      spread(entry, step_.moves(entry.state, input.action, last_, input.now), input.now, targets_);
    }
    estimate_.checked = targets_.size();
    return weigh(targets_, input.observation);
  }

  bool predict(const StepInput& /*input*/, bool /*doubtful*/) override { return weigh(targets_, {}); }

  void adopt(const StepInput& input, bool /*consistent*/) override {
    settle();
    last_ = input.now;
  }

  void stay(const StepInput& input) override {
    before_ = belief_;
    last_ = input.now;
  }

  void resume(Belief belief, double missing, Ticks now) override {
    belief_ = std::move(belief);
    tell_most_likely(belief_, estimate_);
    estimate_.missing_total = missing;
    last_ = now;
  }

 private:
  /// Adds to `targets` where an entry goes: step 2 of Fig. 6-10.
  void spread(const BeliefEntry& entry, const std::vector<std::vector<Move>>& moves, Ticks now, Targets& targets) {
    SystemState target = entry.state;
    const auto visit = [&](const auto& self, std::size_t component, double probability) -> void {
      if (component == moves.size()) {
        options_.go_on();
        targets[target] += probability;
        return;
      }
      for (const Move& move : moves[component]) {
        target.modes[component] = move.mode;
        target.clock_starts[component] = clocks_.advance(component, entry.state.modes[component],
                                                         entry.state.clock_starts[component], move.mode, now);
        self(self, component + 1, probability * move.probability);
      }
    };
    visit(visit, 0, entry.probability);
  }

  /// Conditions the targets on the observation (steps 4 and 5), into `posterior_`; false where nothing is left.
  bool weigh(const Targets& targets, const automata::Observation& observation) {
    posterior_.clear();
    for (const auto& [state, probability] : targets) {
      options_.go_on();
      const double factor = step_.observation_factor(state.modes, observation);
      const double conditioned = probability * (options_.observation_factor || factor == 0 ? factor : 1.0);
      if (conditioned > 0) posterior_.push_back({state, conditioned});
    }
    return !posterior_.empty();
  }

  /// Takes the posterior as the belief.
  void settle() {
    put_in_order(posterior_);
    if (options_.normalise) normalise(posterior_);
    before_ = std::exchange(belief_, std::move(posterior_));
    posterior_ = {};
    tell_most_likely(belief_, estimate_);
  }

  automata::PlantStep& step_;
  EstimatorOptions options_;
  Clocks clocks_;
  Targets targets_;
  Belief posterior_;
};

}  // namespace

std::unique_ptr<Filter> make_exact_filter(automata::PlantStep& step, const EstimatorOptions& options) {
  return std::make_unique<Exact>(step, options);
}

}  // namespace rmpl::runtime
