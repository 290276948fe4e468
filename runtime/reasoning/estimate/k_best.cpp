// The k-best estimator: TimedME of thesis Fig. 6-11 with the corrections of 6.2.3.
//
// What is kept are mode combinations, each with its clocks as a distribution. Where the sources of the search are those
// of the last cycle and no clock matters in them, only what they weigh is new: a plant at rest costs no search. Where
// they weigh what they weighed, too, and lead to themselves, nothing is new: such a cycle costs nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/clock_merging.hpp"
#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/listed_filter.hpp"
#include "runtime/reasoning/estimate/rank.hpp"
#include "runtime/reasoning/estimate/sources.hpp"
#include "runtime/reasoning/estimate/trajectories.hpp"

namespace rmpl::runtime {
namespace {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;
using automata::Move;
using automata::Observation;
using automata::Ticks;

/// The number of states kept is doubled so often while the same readings are set aside, once a cycle. Then it is as
/// before: a sensor that is out of order stays so.
constexpr std::size_t most_doublings = 6;

/// Unnormalised probabilities sink from cycle to cycle; below this they are scaled up before they vanish.
constexpr double least_scale = 1e-200;

class KBest final : public ListedFilter {
 public:
  explicit KBest(KBestModel& model)
      : merging_(model.merging),
        step_(model.step),
        options_(model.options),
        sources_(model),
        search_(model.clocks, model.options) {
    CHECK(options_.k > 0);
    estimate_.modes = likeliest_initial_modes(step_.plant());
    estimate_.consistent = start({});
  }

  bool start(const Observation& observation) override {
    const std::size_t components = step_.plant().components.size();
    const Modes origin(components);
    const std::vector<Clocked> clocks{{std::vector<Ticks>(components), 1.0}};
    auto moves = step_.initial_moves();
    if (options_.ranks) rank(moves);
    const auto look = [&](const Observation& seen) {
      Extensions initial(sources_.evidence(seen), moves);
      const Source source{&origin, clocks, 1.0, &initial};
      combinations_.clear();
      missing_ratio_ = 0;
      replaced_ = 0;
      estimate_.checked = 0;
      estimate_.rank = 0;
      if (!search({&source, 1}, {}, Ticks{}, options_.k, {})) return false;
      settle();
      return true;
    };
    const bool explained = look(observation);
    if (!explained && !observation.empty()) look({});
    return explained;
  }

  bool condition(const StepInput& input) override {
    CHECK(input.now >= last_);
    sources_.begin_update();
    estimate_.checked = 0;
    refuted_ = sources_.evidence(input.observation).conflicts();
    if (search_.repeatable(options_.k) && sources_.of_rest(combinations_, combinations_before_, input, last_)) {
      now_ = input.now;
      search_.run_again(sources_.all(), input.now, input.deadline);
      return found();
    }
    return search(sources_.of(combinations_, input, last_), {}, input.now, options_.k, input.deadline);
  }

  /// Wider in each cycle on end in which the same readings are set aside, for a while; from the second on, exact on the
  /// components that the conflicts with these readings name, each of the others taking its likeliest move.
  bool widen(const StepInput& rest, const Observation& set_aside, bool doubtful) override {
    if (doubtful) missing_ratio_ = std::numeric_limits<double>::infinity();
    if (set_aside_ != set_aside) {
      set_aside_ = set_aside;
      widened_ = 0;
    }
    const std::span<const Source> all = sources_.of(combinations_, rest, last_);
    if (widened_ == most_doublings) return search(all, {}, rest.now, options_.k, rest.deadline);
    ++widened_;
    std::vector<Source> obligatory;
    if (widened_ > 1) obligatory = sources_.exact_on_blamed(combinations_, *refuted_, rest, last_);
    return search(all, obligatory, rest.now, options_.k << widened_, rest.deadline);
  }

  void adopt(const StepInput& input, bool consistent) override {
    const std::pair missing(missing_ratio_, replaced_);
    settle(options_.account && consistent && missing_ratio_ > 0 ? greatest_factor(input.observation) : 1);
    // No clock starts at the end of the step: what is as it was before has none.
    steady_ = consistent && search_.only_weighed() && !merged_ && missing == std::pair(missing_ratio_, replaced_) &&
              combinations_ == combinations_before_;
    if (consistent) set_aside_.clear();
    last_ = input.now;
  }

  void stay(const StepInput& input) override {
    steady_ = false;
    combinations_before_ = combinations_;
    forget_lists();
    estimate_.missing_total = share_missing();
    last_ = input.now;
  }

  /// From what is best of the belief.
  void resume(Belief belief, double missing, Ticks now) override {
    combinations_ = combinations_of(belief);
    if (combinations_.size() > options_.k) combinations_.resize(options_.k);
    normalise(combinations_);
    forget_lists();
    tell_first();
    steady_ = false;
    missing_ratio_ = missing / (1 - missing);
    replaced_ = missing;  // clocks may have been merged
    estimate_.missing_total = share_missing();
    last_ = now;
  }

  [[nodiscard]] bool steady() const override { return steady_; }
  [[nodiscard]] const Belief& belief() const override { return listed(belief_, combinations_, belief_listed_); }
  [[nodiscard]] bool all_modes(base::FunctionRef<bool(const Modes&)> test) const override {
    return std::all_of(combinations_.begin(), combinations_.end(),
                       [&](const Combination& combination) { return test(combination.modes); });
  }
  [[nodiscard]] const Belief& before() const override { return listed(before_, combinations_before_, before_listed_); }

 private:
  static const Belief& listed(Belief& belief, const Combinations& combinations, bool& is_listed) {
    if (!is_listed) belief = states_of(combinations);
    is_listed = true;
    return belief;
  }

  void forget_lists() { belief_listed_ = before_listed_ = false; }

  /// The estimate by the first combination.
  void tell_first() {
    const double sum = total(combinations_);
    if (!(sum > 0)) return;
    estimate_.modes = combinations_.front().modes;
    estimate_.probability = combinations_.front().probability / sum;
    if (options_.merge_trajectories) return;
    // Several entries may have the same modes.
    tell_most_likely(states_of(combinations_), estimate_);
  }

  double greatest_factor(const Observation& observation) {
    const ReadingEvidence& evidence = sources_.evidence(observation);
    return evidence.bounds_factors() ? evidence.greatest_factor() : 1;
  }

  /// Looks for the best targets; false where there is none.
  bool search(std::span<const Source> sources, std::span<const Source> obligatory, Ticks now, std::size_t k,
              const Deadline& deadline) {
    now_ = now;
    search_.run(sources, obligatory, now, k, deadline);
    return found();
  }

  bool found() {
    estimate_.checked += search_.checked();
    estimate_.cut = search_.cut();
    return !search_.kept().empty();
  }

  /// What is missing from the belief, or does not belong to it, at most.
  [[nodiscard]] double share_missing() const {
    if (!std::isfinite(missing_ratio_) || replaced_ >= 1) return 1;
    return std::max(missing_ratio_ / (missing_ratio_ + 1 - replaced_), replaced_);
  }

  /// Takes the targets that were found last as the belief. What was missing before is worth so much more, by its
  /// factor, at most; so is what took the place of something else as clocks were merged.
  void settle(double greatest_factor = 1) {
    const double before = combinations_.empty() ? 1.0 : total(combinations_);
    std::swap(combinations_before_, combinations_);
    std::swap(combinations_, search_.kept());
    forget_lists();
    const double kept = total(combinations_);
    estimate_.missing_mass = search_.lost() > 0 ? search_.lost() / (search_.lost() + kept) : 0.0;
    missing_ratio_ = missing_ratio_ > 0 || search_.lost() > 0
                         ? (missing_ratio_ * before * greatest_factor + search_.lost()) / kept
                         : 0.0;
    replaced_ = std::min(1.0, replaced_ * before * greatest_factor / kept);
    if (options_.ranks) {
      estimate_.rank += count_from_best(combinations_);
    } else if (options_.normalise) {
      normalise(combinations_);
    } else if (combinations_.front().probability < least_scale) {
      scale(combinations_, 1 / combinations_.front().probability);
    }
    merged_ = false;
    if (options_.merge_trajectories) merge_clocks();
    estimate_.missing_total = share_missing();
    tell_first();
    if (options_.ranks) estimate_.modes = combinations_.front().modes;
  }

  /// Combinations that there are not leave their clocks to the others.
  void merge_clocks() {
    double changed = 0;
    const std::size_t most = options_.clocks * std::max<std::size_t>(1, options_.k / combinations_.size());
    for (Combination& combination : combinations_) {
      const std::size_t clocks = combination.clocks.size();
      changed += merging_.limit(combination, most, now_);
      merged_ = merged_ || combination.clocks.size() != clocks;
    }
    if (!(changed > 0)) return;
    changed /= total(combinations_);
    missing_ratio_ += changed;
    replaced_ = std::min(1.0, replaced_ + changed);
  }

  const ClockMerging& merging_;
  automata::PlantStep& step_;
  const EstimatorOptions& options_;
  Sources sources_;
  TrajectorySearch search_;
  std::shared_ptr<const ConflictSet> refuted_;       ///< by the readings that `condition` was asked about last
  Observation set_aside_;                            ///< in the last update
  std::size_t widened_ = 0;                          ///< cycles on end for these
  Combinations combinations_, combinations_before_;  ///< the belief, and the one that the last step started from
  mutable bool belief_listed_ = false, before_listed_ = false;
  bool merged_ = false;       ///< clocks, in the last step
  bool steady_ = false;       ///< as `steady` says
  Ticks now_;                 ///< the end of the step that is being worked out
  double missing_ratio_ = 0;  ///< what is missing since the start, at most, by what was kept
  double replaced_ = 0;       ///< the share of the belief, at most, that took the place of something else
};

class KBestFilters final : public Filters {
 public:
  KBestFilters(automata::PlantStep& step, const EstimatorOptions& options) : model_(step, options) {}
  std::unique_ptr<Filter> make() override { return std::make_unique<KBest>(model_); }

 private:
  KBestModel model_;
};

}  // namespace

std::unique_ptr<Filters> k_best_filters(automata::PlantStep& step, const EstimatorOptions& options) {
  return std::make_unique<KBestFilters>(step, options);
}

}  // namespace rmpl::runtime
