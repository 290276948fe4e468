// The k-best estimator: TimedME of thesis Fig. 6-11 with the corrections of 6.2.3.
//
// The extensions of a source depend on its modes, the control action, the length of the step and the readings of the
// clocks that matter. Where no clock matters they are remembered from cycle to cycle; where one runs, no reading comes
// twice, and they are worked out anew in the memory of the last cycle. Where none matters in any source, and the
// sources are those of the last cycle, only what they weigh is new: a plant at rest costs no search.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/listed_filter.hpp"
#include "runtime/reasoning/estimate/rank.hpp"
#include "runtime/reasoning/estimate/source_key.hpp"
#include "runtime/reasoning/estimate/trajectories.hpp"

namespace rmpl::runtime {
namespace {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;
using automata::Move;
using automata::Observation;
using automata::SystemState;
using automata::Ticks;

/// Beyond so many remembered modes, of all sources and observations together, all are forgotten.
constexpr std::size_t memory_limit = 1u << 15;

/// Beyond so many conflicts that need no observation all are forgotten: each candidate is compared with each.
constexpr std::size_t conflict_limit = 512;

/// The number of states kept is doubled so often at most while cycles are inconsistent.
constexpr std::size_t most_doublings = 6;

/// Up to so many extensions, components in a conflict are predicted exactly.
constexpr std::size_t exact_limit = 4096;

/// Unnormalised probabilities sink from cycle to cycle; below this they are scaled up before they vanish.
constexpr double least_scale = 1e-200;

/// What is remembered for one observation.
struct Context {
  Context(automata::PlantStep& step, const Observation& observation, ConflictSet& lasting, OpenReadings* open)
      : evidence(step, observation, lasting, open) {}
  ReadingEvidence evidence;
  std::unordered_map<SourceKey, Extensions, SourceKeyHash> extensions;
};

/// What a search over remembered extensions was about, beside the states that it went out from.
struct Rest {
  const Context* context;
  ControlAction action;
  Ticks step;
};

class KBest final : public ListedFilter {
 public:
  KBest(automata::PlantStep& step, const EstimatorOptions& options)
      : step_(step),
        options_(options),
        clocks_(step.plant(), options.live_clocks_only),
        table_(step.plant(), options.ranks),
        open_(step),
        search_(clocks_, options_) {
    CHECK(options.k > 0);
    if (options.observation_factor && options.merge_trajectories) open_.openings();
    estimate_.modes = likeliest_initial_modes(step.plant());
    estimate_.consistent = start({});
  }

  bool start(const Observation& observation) override {
    const std::size_t components = step_.plant().components.size();
    const SystemState origin{Modes(components), std::vector<Ticks>(components)};
    auto moves = step_.initial_moves();
    if (options_.ranks) rank(moves);
    const auto look = [&](const Observation& seen) {
      Extensions initial(context(seen).evidence, moves);
      const Source source{&origin, 1.0, &initial};
      belief_.clear();
      missing_ratio_ = 0;
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
    bound_memory();
    table_.forget_timed();
    estimate_.checked = 0;
    Context& seen = context(input.observation);
    if (at_rest(seen, input)) {
      for (std::size_t i = 0; i < sources_.size(); ++i) {
        sources_[i] = {&belief_[i].state, belief_[i].probability, sources_[i].extensions};
      }
      search_.run_again(sources_, input.now, input.deadline);
      explained_ = found();
    } else {
      explained_ = search(sources(seen, input.action, input.now), {}, input.now, options_.k, input.deadline);
    }
    return explained_;
  }

  bool predict(const StepInput& input, bool doubtful) override {
    if (doubtful) missing_ratio_ = std::numeric_limits<double>::infinity();
    if (!explained_) return widen(context(input.observation).evidence, input);
    return search(sources(context({}), input.action, input.now), {}, input.now, options_.k, input.deadline);
  }

  void adopt(const StepInput& input, bool consistent) override {
    settle(options_.account && consistent && missing_ratio_ > 0 ? greatest_factor(input.observation) : 1);
    if (consistent) inconsistent_cycles_ = 0;
    last_ = input.now;
  }

  void stay(const StepInput& input) override {
    before_ = belief_;
    estimate_.missing_total = share_missing();
    last_ = input.now;
  }

  void resume(Belief belief, double missing, Ticks now) override {
    belief_ = std::move(belief);
    normalise(belief_);
    tell_most_likely(belief_, estimate_);
    missing_ratio_ = missing / (1 - missing);
    estimate_.missing_total = share_missing();
    last_ = now;
  }

 private:
  Context& context(const Observation& observation) {
    const auto [known, fresh] = contexts_.try_emplace(observation, step_, observation, lasting_,
                                                      options_.observation_factor ? &open_ : nullptr);
    if (fresh) ++remembered_;
    return known->second;
  }

  /// Past the limits everything is forgotten; what was remembered is let go of bit by bit.
  void bound_memory() {
    for (std::size_t i = 0; i < 4 * options_.k && !retired_.empty(); ++i) {
      auto& extensions = retired_.begin()->second.extensions;
      if (extensions.empty()) {
        retired_.erase(retired_.begin());
      } else {
        extensions.erase(extensions.begin());
      }
    }
    // However large a state is: what a few cycles need.
    const std::size_t sources = std::max(memory_limit / (step_.plant().components.size() + 1), 8 * options_.k);
    if (remembered_ < sources && table_.size() < memory_limit && lasting_.conflicts().size() < conflict_limit) return;
    retired_ = std::exchange(contexts_, {});
    rest_.reset();
    remembered_ = 0;
    table_.forget();
    if (lasting_.conflicts().size() >= conflict_limit) lasting_ = {};
  }

  /// Whether the step goes out from the states of the last one, in their order, by the same extensions.
  [[nodiscard]] bool at_rest(const Context& context, const StepInput& input) const {
    return rest_ && rest_->context == &context && rest_->step == input.now - last_ && rest_->action == input.action &&
           search_.repeatable(options_.k) &&
           std::equal(belief_.begin(), belief_.end(), before_.begin(), before_.end(),
                      [](const BeliefEntry& a, const BeliefEntry& b) { return a.state == b.state; });
  }

  /// The states of the belief with their extensions under one observation. Valid until the next call.
  std::span<const Source> sources(Context& context, const ControlAction& action, Ticks now) {
    sources_.clear();
    std::size_t transient = 0;
    for (const BeliefEntry& entry : belief_) {
      Extensions* extensions = remembered(context, entry.state, action, now);
      if (extensions == nullptr) extensions = worked_out(transient++, context);
      sources_.push_back({&entry.state, entry.probability, extensions});
    }
    rest_.reset();
    if (transient == 0 && now > last_) rest_ = {&context, action, now - last_};
    return sources_;
  }

  /// The extensions of a state in which no clock matters; else null, and `moves_` are those of the state.
  Extensions* remembered(Context& context, const SystemState& state, const ControlAction& action, Ticks now) {
    key_ = {state.modes, action, now - last_};
    const auto known = context.extensions.find(key_);
    if (known != context.extensions.end()) return &known->second;
    table_.look_up(step_, state, action, last_, now, moves_);
    if (table_.timed()) return nullptr;
    ++remembered_;
    return &context.extensions.try_emplace(key_, context.evidence, moves_).first->second;
  }

  Extensions* worked_out(std::size_t position, Context& context) {
    if (position == transient_.size()) {
      transient_.push_back(std::make_unique<Extensions>(context.evidence, moves_));
    } else {
      transient_[position]->restart(context.evidence, moves_);
    }
    return transient_[position].get();
  }

  double greatest_factor(const Observation& observation) {
    const ReadingEvidence& evidence = context(observation).evidence;
    return evidence.bounds_factors() ? evidence.greatest_factor() : 1;
  }

  [[nodiscard]] double share_missing() const {
    return std::isfinite(missing_ratio_) ? missing_ratio_ / (1 + missing_ratio_) : 1.0;
  }

  /// Looks for the best targets; false where there is none.
  bool search(std::span<const Source> sources, std::span<const Source> obligatory, Ticks now, std::size_t k,
              const Deadline& deadline) {
    search_.run(sources, obligatory, now, k, deadline);
    return found();
  }

  bool found() {
    estimate_.checked += search_.checked();
    estimate_.cut = search_.cut();
    return !search_.kept().empty();
  }

  /// Takes the targets that were found last as the belief. What was missing before is worth so much more, by its
  /// factor, at most.
  void settle(double greatest_factor = 1) {
    const double before = belief_.empty() ? 1.0 : total(belief_);
    std::swap(before_, belief_);
    std::swap(belief_, search_.kept());
    const double kept = total(belief_);
    estimate_.missing_mass = search_.lost() > 0 ? search_.lost() / (search_.lost() + kept) : 0.0;
    missing_ratio_ = missing_ratio_ > 0 || search_.lost() > 0
                         ? (missing_ratio_ * before * greatest_factor + search_.lost()) / kept
                         : 0.0;
    estimate_.missing_total = share_missing();
    if (options_.ranks) {
      estimate_.rank += count_from_best(belief_);
    } else if (options_.normalise) {
      normalise(belief_);
    } else if (belief_.front().probability < least_scale) {
      const double scale = belief_.front().probability;
      for (BeliefEntry& entry : belief_) entry.probability /= scale;
    }
    tell_most_likely(belief_, estimate_);
    if (options_.ranks) estimate_.modes = belief_.front().state.modes;
  }

  /// What is left where no extension explains the observation: the last belief predicted forward, wider in each
  /// inconsistent cycle on end; from the second on, exact on the components that the conflicts name, each of the others
  /// taking its likeliest move. Where no successor is possible at all, the belief stays.
  bool widen(ReadingEvidence& evidence, const StepInput& input) {
    ++inconsistent_cycles_;
    const std::vector<bool> blamed = components_in(evidence.conflicts()->conflicts());
    Context& unseen = context({});
    const std::span<const Source> all = sources(unseen, input.action, input.now);
    std::vector<std::unique_ptr<Extensions>> widened;
    std::vector<Source> obligatory;
    if (inconsistent_cycles_ > 1) {
      std::size_t count = 0;
      for (const BeliefEntry& entry : belief_) {
        auto moves = step_.moves(entry.state, input.action, last_, input.now);
        if (options_.ranks) rank(moves);
        count += restrict_to(blamed, moves);
        if (count > exact_limit) break;
        widened.push_back(std::make_unique<Extensions>(unseen.evidence, moves));
        obligatory.push_back({&entry.state, entry.probability, widened.back().get()});
      }
      if (count > exact_limit) obligatory.clear();
    }
    const std::size_t k = options_.k << std::min(inconsistent_cycles_, most_doublings);
    return search(all, obligatory, input.now, k, input.deadline);
  }

  /// The components that observations bring into conflict; conflicts that need none are left out.
  [[nodiscard]] std::vector<bool> components_in(const std::vector<Conflict>& conflicts) const {
    std::vector<bool> named(step_.plant().components.size());
    const std::vector<Conflict>& lasting = lasting_.conflicts();
    for (const Conflict& conflict : conflicts) {
      if (std::find(lasting.begin(), lasting.end(), conflict) != lasting.end()) continue;
      for (const Decision& decision : conflict) named[decision.variable] = true;
    }
    return named;
  }

  /// Leaves each component that is not `free` its likeliest move; how many products of moves there are then, or a
  /// number above `exact_limit`.
  static std::size_t restrict_to(const std::vector<bool>& free, std::vector<std::vector<Move>>& moves) {
    std::size_t products = 1;
    for (std::size_t c = 0; c < moves.size(); ++c) {
      if (!free[c]) {
        moves[c] = {*std::max_element(moves[c].begin(), moves[c].end(),
                                      [](const Move& a, const Move& b) { return a.probability < b.probability; })};
      }
      products = std::min(products * moves[c].size(), exact_limit + 1);
    }
    return products;
  }

  automata::PlantStep& step_;
  const EstimatorOptions options_;
  const Clocks clocks_;
  MoveTable table_;
  MoveTable::Moves moves_;
  OpenReadings open_;
  ConflictSet lasting_;
  std::map<Observation, Context> contexts_;
  std::map<Observation, Context> retired_;  ///< forgotten, and not yet let go of
  std::size_t remembered_ = 0;
  SourceKey key_;
  std::vector<std::unique_ptr<Extensions>> transient_;  ///< of sources with a running clock; reused
  std::vector<Source> sources_;
  std::optional<Rest> rest_;  ///< of `sources_`, where no clock matters in any of them
  TrajectorySearch search_;
  std::size_t inconsistent_cycles_ = 0;
  bool explained_ = true;     ///< by what `condition` found last
  double missing_ratio_ = 0;  ///< what was not kept since the start, at most, by what was
};

}  // namespace

std::unique_ptr<Filter> make_k_best_filter(automata::PlantStep& step, const EstimatorOptions& options) {
  return std::make_unique<KBest>(step, options);
}

}  // namespace rmpl::runtime
