// The exact estimator: BeliefUpdate of thesis Fig. 6-10 over the whole belief, normalised.
//
// The reference: every positive product of moves of every state is enumerated, so the cost is exponential in the
// number of components. So whatever is done for each state looks for an interruption, the release of memory included:
// where it comes it is answered at once, with millions of states at hand.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/listed_filter.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"

namespace rmpl::runtime {
namespace {

using automata::Modes;
using automata::Move;
using automata::SystemState;
using automata::Ticks;

/// Memory is looked at once in so many states: that is a system call.
constexpr std::size_t states_between_looks = 1u << 10;

/// Probabilities of target states, summed (step 3 of Fig. 6-10).
using Targets = std::unordered_map<SystemState, double, SystemStateHash>;

class Exact final : public ListedFilter {
 public:
  Exact(automata::PlantStep& step, const EstimatorOptions& options)
      : step_(step),
        options_(options),
        clocks_(step.plant(), options.live_clocks_only),
        possible_(step, PossibleShare::no_limit, [this] {
          options_.go_on();
          options_.keep_within_memory();
        }) {
    estimate_.modes = likeliest_initial_modes(step.plant());
    estimate_.consistent = start({});
  }

  bool start(const automata::Observation& observation) override {
    const std::size_t components = step_.plant().components.size();
    const SystemState origin{Modes(components), std::vector<Ticks>(components)};
    Targets initial;
    spread({origin, 1.0}, step_.initial_moves(), std::vector<bool>(components), Ticks{}, initial);
    const bool explained = weigh(initial, observation);
    if (explained || weigh(initial, {})) settle();
    return explained;
  }

  bool condition(const StepInput& input) override {
    CHECK(input.now >= last_);
    release(before_);
    release_targets();
    for (const BeliefEntry& entry : belief_) {
      const auto& moves = step_.moves(entry.state, input.action, last_, input.now);
      const auto moves_of = [&](std::size_t c) { return std::span<const Move>(moves[c]); };
      const double share = possible_.of(entry.state.modes, moves_of).value;
      if (share == 0) continue;  // no state follows
      spread({entry.state, entry.probability / share}, moves, step_.restarted(entry.state.modes, input.action),
             input.now, targets_);
    }
    estimate_.checked = targets_.size();
    return weigh(targets_, input.observation);
  }

  bool widen(const StepInput& rest, const automata::Observation& /*set_aside*/, bool /*doubtful*/) override {
    return weigh(targets_, rest.observation);
  }

  void adopt(const StepInput& input, bool /*consistent*/) override {
    release_targets();
    settle();
    last_ = input.now;
  }

  void stay(const StepInput& input) override {
    release_targets();
    before_ = belief_;
    last_ = input.now;
  }

  [[nodiscard]] bool all_modes(base::FunctionRef<bool(const Modes&)> test) const override {
    return std::all_of(belief_.begin(), belief_.end(),
                       [&](const BeliefEntry& entry) { return test(entry.state.modes); });
  }

  void resume(Belief belief, double missing, Ticks now) override {
    belief_ = std::move(belief);
    tell_most_likely(belief_, estimate_);
    estimate_.missing_total = missing;
    last_ = now;
  }

 private:
  /// Adds to `targets` where an entry goes: step 2 of Fig. 6-10.
  void spread(const BeliefEntry& entry, const std::vector<std::vector<Move>>& moves, const std::vector<bool>& restarted,
              Ticks now, Targets& targets) {
    SystemState target = entry.state;
    std::vector<double> probabilities{entry.probability};  // of what is taken so far
    base::multiply_out(
        moves,
        [&](std::size_t component, std::size_t m) {
          const Move& move = moves[component][m];
          target.modes[component] = move.mode;
          target.clock_starts[component] =
              clocks_.advance(component, entry.state.modes[component], entry.state.clock_starts[component], move.mode,
                              now, restarted[component]);
          probabilities.push_back(probabilities.back() * move.probability);
          return true;
        },
        [&](std::size_t, std::size_t) { probabilities.pop_back(); },
        [&] {
          options_.go_on();
          targets[target] += probabilities.back();
          if (targets.size() % states_between_looks == 0) options_.keep_within_memory();
          return false;
        });
  }

  /// Conditions the targets on the observation (steps 4 and 5), into `posterior_`; false where nothing is left.
  bool weigh(const Targets& targets, const automata::Observation& observation) {
    release(posterior_);
    for (const auto& [state, probability] : targets) {
      options_.go_on();
      const double factor = step_.observation_factor(state.modes, observation);
      const double conditioned = probability * (options_.observation_factor || factor == 0 ? factor : 1.0);
      if (conditioned > 0) posterior_.push_back({state, conditioned});
      if (posterior_.size() % states_between_looks == 0) options_.keep_within_memory();
    }
    return !posterior_.empty();
  }

  /// Takes the posterior as the belief.
  void settle() {
    put_in_order(
        posterior_, [](const BeliefEntry& a, const BeliefEntry& b) { return a.state < b.state; },
        [this] { options_.go_on(); });
    if (options_.normalise) normalise(posterior_);
    release(before_);
    before_ = std::exchange(belief_, std::move(posterior_));
    posterior_ = {};
    tell_most_likely(belief_, estimate_, [this] { options_.go_on(); });
  }

  void release(Belief& belief) {
    for (; !belief.empty(); belief.pop_back()) options_.go_on();
    belief = {};
  }

  void release_targets() {
    for (; !targets_.empty(); targets_.erase(targets_.begin())) options_.go_on();
    targets_ = {};
  }

  automata::PlantStep& step_;
  EstimatorOptions options_;
  Clocks clocks_;
  PossibleShare possible_;
  Targets targets_;
  Belief posterior_;
};

class ExactFilters final : public Filters {
 public:
  ExactFilters(automata::PlantStep& step, const EstimatorOptions& options) : step_(step), options_(options) {}
  std::unique_ptr<Filter> make() override { return std::make_unique<Exact>(step_, options_); }

 private:
  automata::PlantStep& step_;
  EstimatorOptions options_;
};

}  // namespace

std::unique_ptr<Filters> exact_filters(automata::PlantStep& step, const EstimatorOptions& options) {
  return std::make_unique<ExactFilters>(step, options);
}

}  // namespace rmpl::runtime
