// The k-best estimator: TimedME of thesis Fig. 6-11 with the corrections of 6.2.3.
//
// What is kept are mode combinations, each with its clocks as a distribution. The extensions of a combination depend on
// the control action, the length of the step and the readings of the clocks that matter. Where no clock matters they
// are remembered from cycle to cycle; where one runs, no reading comes twice, and they are worked out anew in the
// memory of the last cycle: one search for all clocks, by the best that any of them promises. Where none matters in any
// source, and the sources are those of the last cycle, only what they weigh is new: a plant at rest costs no search.
// Where they weigh what they weighed, too, and lead to themselves, nothing is new: such a cycle costs nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/clock_merging.hpp"
#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/listed_filter.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"
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
using automata::Ticks;

/// Beyond so many remembered modes, of all sources and observations together, all are forgotten.
constexpr std::size_t memory_limit = 1u << 15;

/// Beyond so many conflicts that need no observation all are forgotten: each candidate is compared with each.
constexpr std::size_t conflict_limit = 512;

/// The number of states kept is doubled so often while the same readings are set aside, once a cycle. Then it is as
/// before: a sensor that is out of order stays so.
constexpr std::size_t most_doublings = 6;

/// Up to so many extensions, components in a conflict are predicted exactly, and shares of what is possible summed.
constexpr std::size_t exact_limit = 4096;

/// Unnormalised probabilities sink from cycle to cycle; below this they are scaled up before they vanish.
constexpr double least_scale = 1e-200;

/// One by the share of the outcomes that is possible; 0 where none is, 1 where it is not known.
double scale_of(PossibleShare::Share share) { return !share.exact ? 1 : share.value > 0 ? 1 / share.value : 0; }

/// By how much more than that outcomes may be worth, at most.
double slack_of(PossibleShare::Share share) {
  if (share.exact) return 1;
  return share.value > 0 ? 1 / share.value : std::numeric_limits<double>::infinity();
}

/// The extensions of modes in which no clock matters.
struct Remembered {
  Remembered(ReadingEvidence& evidence, const MoveTable::Moves& moves, PossibleShare::Share share)
      : extensions(evidence, moves), scale(scale_of(share)), slack(slack_of(share)) {}
  Extensions extensions;
  double scale;
  double slack;
};

/// The extensions of one combination with a running clock.
struct Transient {
  std::vector<double> scales;  ///< by clocks, or of all
  std::optional<Extensions> extensions;
  std::vector<std::size_t> varied;
  std::vector<const ComponentMoves*> moves;  ///< by clocks, by varied component
  std::vector<ComponentMoves> best;          ///< by varied component
};

/// What is remembered for one observation.
struct Context {
  Context(automata::PlantStep& step, const Observation& observation, ConflictSet& lasting, OpenReadings* open)
      : evidence(step, observation, lasting, open) {}
  ReadingEvidence evidence;
  std::unordered_map<SourceKey, Remembered, SourceKeyHash> extensions;
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
        search_(clocks_, options_),
        possible_(step, exact_limit),
        merging_(step.plant(), possible_.excluding(), options.clocks) {
    CHECK(options.k > 0);
    if (options.observation_factor && options.merge_trajectories) open_.openings();
    estimate_.modes = likeliest_initial_modes(step.plant());
    estimate_.consistent = start({});
  }

  bool start(const Observation& observation) override {
    const std::size_t components = step_.plant().components.size();
    const Modes origin(components);
    const std::vector<Clocked> clocks{{std::vector<Ticks>(components), 1.0}};
    auto moves = step_.initial_moves();
    if (options_.ranks) rank(moves);
    const auto look = [&](const Observation& seen) {
      Extensions initial(context(seen).evidence, moves);
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
    bound_memory();
    table_.forget_timed();
    estimate_.checked = 0;
    Context& seen = context(input.observation);
    refuted_ = seen.evidence.conflicts();
    if (at_rest(seen, input)) {
      for (std::size_t i = 0; i < sources_.size(); ++i) {
        const Combination& own = combinations_[i];
        Source& source = sources_[i];
        source.modes = &own.modes;
        source.clocks = own.clocks;
        find_differing(own, differing_[i]);
        source.differing = differing_[i];
        source.weight = own.probability * (source.scales.empty() ? 1 : source.scales.front());
      }
      now_ = input.now;
      search_.run_again(sources_, input.now, input.deadline);
      return found();
    }
    return search(sources(seen, input.action, input.now), {}, input.now, options_.k, input.deadline);
  }

  /// Wider in each cycle on end in which the same readings are set aside, for a while; from the second on, exact on the
  /// components that the conflicts with these readings name, each of the others taking its likeliest move.
  bool widen(const StepInput& rest, const Observation& set_aside, bool doubtful) override {
    if (doubtful) missing_ratio_ = std::numeric_limits<double>::infinity();
    if (set_aside_ != set_aside) {
      set_aside_ = set_aside;
      widened_ = 0;
    }
    Context& context = this->context(rest.observation);
    const std::span<const Source> all = sources(context, rest.action, rest.now);
    if (widened_ == most_doublings) return search(all, {}, rest.now, options_.k, rest.deadline);
    ++widened_;
    obligatory_.clear();
    std::vector<Source> obligatory;
    if (widened_ > 1) obligatory = exact_on_blamed(context, rest);
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

  /// Whether the step goes out from the modes of the last one, in their order, by the same extensions.
  [[nodiscard]] bool at_rest(const Context& context, const StepInput& input) const {
    return rest_ && rest_->context == &context && rest_->step == input.now - last_ && rest_->action == input.action &&
           search_.repeatable(options_.k) &&
           std::equal(combinations_.begin(), combinations_.end(), combinations_before_.begin(),
                      combinations_before_.end(),
                      [](const Combination& a, const Combination& b) { return a.modes == b.modes; });
  }

  /// The combinations of the belief with their extensions under one observation. Valid until the next call.
  std::span<const Source> sources(Context& context, const ControlAction& action, Ticks now) {
    sources_.clear();
    std::size_t transient = 0;
    differing_.resize(std::max(differing_.size(), combinations_.size()));
    for (const Combination& own : combinations_) {
      std::vector<std::size_t>& differing = differing_[sources_.size()];
      find_differing(own, differing);
      Source& source = sources_.emplace_back(Source{&own.modes, own.clocks, own.probability, nullptr});
      source.differing = differing;
      if (Remembered* const known = remembered(context, own, action, now)) {
        source.extensions = &known->extensions;
        source.slack = known->slack;
        source.scales = {&known->scale, 1};
        source.weight *= known->scale;
      } else {
        work_out(transient++, context, own, now, source);
      }
    }
    rest_.reset();
    if (transient == 0 && now > last_) rest_ = {&context, action, now - last_};
    return sources_;
  }

  static void find_differing(const Combination& own, std::vector<std::size_t>& differing) {
    differing.clear();
    if (own.clocks.size() == 1) return;
    const std::vector<Ticks>& first = own.clocks.front().starts;
    for (std::size_t c = 0; c < first.size(); ++c) {
      const bool differs = std::any_of(own.clocks.begin() + 1, own.clocks.end(),
                                       [&](const Clocked& clocked) { return clocked.starts[c] != first[c]; });
      if (differs) differing.push_back(c);
    }
  }

  /// The extensions of modes in which no clock matters; else null, and `moves_` are those of the first clocks.
  Remembered* remembered(Context& context, const Combination& own, const ControlAction& action, Ticks now) {
    key_ = {own.modes, action, now - last_};
    const auto known = context.extensions.find(key_);
    if (known != context.extensions.end()) return &known->second;
    table_.look_up(step_, own.modes, own.clocks.front().starts, action, last_, now, moves_);
    if (!table_.timed().empty()) return nullptr;
    ++remembered_;
    const auto moves_of = [&](std::size_t c) { return moves_[c]->moves(); };
    const auto share = possible_share(own.modes, moves_of, possible_.all());
    return &context.extensions.try_emplace(key_, context.evidence, moves_, share).first->second;
  }

  /// After `remembered` found none. Where clocks differ in what they allow, the extensions are those of the best of
  /// them.
  void work_out(std::size_t position, Context& context, const Combination& own, Ticks now, Source& source) {
    if (position == transient_.size()) transient_.push_back(std::make_unique<Transient>());
    Transient& slot = *transient_[position];
    slot.varied.clear();
    slot.moves.clear();
    slot.best.clear();
    std::set_intersection(source.differing.begin(), source.differing.end(), table_.timed().begin(),
                          table_.timed().end(), std::back_inserter(slot.varied));
    if (!slot.varied.empty()) {
      for (const Clocked& clocked : own.clocks) {
        for (const std::size_t c : slot.varied) {
          slot.moves.push_back(table_.look_up_timed(step_, c, clocked.starts[c], last_, now));
        }
      }
      slot.best.reserve(slot.varied.size());
      for (std::size_t v = 0; v < slot.varied.size(); ++v) {
        moves_[slot.varied[v]] = &slot.best.emplace_back(best_of(slot.moves, v, slot.varied.size()));
      }
    }
    if (slot.extensions) {
      slot.extensions->restart(context.evidence, moves_);
    } else {
      slot.extensions.emplace(context.evidence, moves_);
    }
    source.extensions = &*slot.extensions;
    source.varied = slot.varied;
    source.moves = slot.moves;
    scale_up(slot, own, source);
  }

  /// What is possible is worth more, clock by clock where clocks differ in what may be excluded.
  void scale_up(Transient& slot, const Combination& own, Source& source) {
    const auto [touched, others] = possible_.divide(slot.varied);
    const auto common = [&](std::size_t c) { return moves_[c]->moves(); };
    shares_.assign(touched.empty() ? 1 : own.clocks.size(), possible_share(own.modes, common, others));
    for (const std::size_t cluster : touched) multiply_shares(slot, own.modes, cluster);
    slot.scales.clear();
    for (const PossibleShare::Share share : shares_) {
      source.slack = std::max(source.slack, slack_of(share));
      slot.scales.push_back(scale_of(share));
    }
    source.scales = slot.scales;
    source.weight = 0;
    for (std::size_t e = 0; e < own.clocks.size(); ++e) source.weight += source.weight_of(e);
  }

  /// Takes a cluster into the shares, clock by clock. Where one component of it varies, its moves are cases, and the
  /// share is a sum over these.
  void multiply_shares(const Transient& slot, const Modes& modes, std::size_t cluster) {
    const auto take = [&](std::size_t clock, PossibleShare::Share share) {
      shares_[clock] = {shares_[clock].value * share.value, shares_[clock].exact && share.exact};
    };
    std::vector<std::size_t> own;  // of those that vary
    for (std::size_t v = 0; v < slot.varied.size(); ++v) {
      if (possible_.has(cluster, slot.varied[v])) own.push_back(v);
    }
    if (own.size() == 1) {
      const std::size_t component = slot.varied[own.front()];
      std::vector<std::pair<automata::ModeId, PossibleShare::Share>> cases;
      for (const Move& move : moves_[component]->moves()) {
        const Move sure{move.mode, 1.0};
        const auto moves_of = [&](std::size_t c) {
          return c == component ? std::span<const Move>(&sure, 1) : moves_[c]->moves();
        };
        cases.emplace_back(move.mode, possible_share(modes, moves_of, {cluster}));
      }
      for (std::size_t e = 0; e < shares_.size(); ++e) {
        const ComponentMoves& moves = *slot.moves[e * slot.varied.size() + own.front()];
        PossibleShare::Share sum{0};
        for (const auto& [mode, share] : cases) {
          sum.value += moves.prior(mode) * share.value;
          sum.exact = sum.exact && share.exact;
        }
        take(e, sum);
      }
      return;
    }
    for (std::size_t e = 0; e < shares_.size(); ++e) {
      const auto moves_of = [&, first = e * slot.varied.size()](std::size_t c) {
        const auto at = std::lower_bound(slot.varied.begin(), slot.varied.end(), c);
        if (at == slot.varied.end() || *at != c) return moves_[c]->moves();
        return slot.moves[first + static_cast<std::size_t>(at - slot.varied.begin())]->moves();
      };
      take(e, possible_share(modes, moves_of, {cluster}));
    }
  }

  /// Fig. 6-11 scales nothing.
  PossibleShare::Share possible_share(const Modes& modes, PossibleShare::MovesOf moves,
                                      const PossibleShare::Clusters& clusters) {
    return options_.merge_trajectories ? possible_.of(modes, moves, clusters) : PossibleShare::Share{};
  }

  /// For each mode the greatest probability, over every `stride`-th of the moves from `first` on.
  static ComponentMoves best_of(const std::vector<const ComponentMoves*>& moves, std::size_t first,
                                std::size_t stride) {
    std::vector<double> greatest;
    for (std::size_t i = first; i < moves.size(); i += stride) {
      const std::vector<double>& priors = moves[i]->priors();
      if (greatest.size() < priors.size()) greatest.resize(priors.size(), 0.0);
      for (std::size_t m = 0; m < priors.size(); ++m) greatest[m] = std::max(greatest[m], priors[m]);
    }
    std::vector<Move> best;
    for (std::size_t m = 0; m < greatest.size(); ++m) {
      if (greatest[m] > 0) best.push_back({automata::ModeId(m), greatest[m]});
    }
    return ComponentMoves(best);
  }

  double greatest_factor(const Observation& observation) {
    const ReadingEvidence& evidence = context(observation).evidence;
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

  void merge_clocks() {
    double changed = 0;
    for (Combination& combination : combinations_) {
      const std::size_t clocks = combination.clocks.size();
      changed += merging_.limit(combination, now_);
      merged_ = merged_ || combination.clocks.size() != clocks;
    }
    if (!(changed > 0)) return;
    changed /= total(combinations_);
    missing_ratio_ += changed;
    replaced_ = std::min(1.0, replaced_ + changed);
  }

  /// The states of the belief with all moves of the components that the readings refute; none where these are too many.
  std::vector<Source> exact_on_blamed(Context& context, const StepInput& rest) {
    const std::vector<bool> blamed = components_in(refuted_->conflicts());
    std::vector<Source> result;
    std::size_t count = 0;
    for (const Combination& own : combinations_) {
      // Of all clocks.
      std::vector<std::vector<Move>> moves;
      for (const Clocked& clocked : own.clocks) {
        const auto& next = step_.moves({own.modes, clocked.starts}, rest.action, last_, rest.now);
        moves.resize(next.size());
        for (std::size_t c = 0; c < next.size(); ++c) take_best(moves[c], next[c]);
      }
      if (options_.ranks) rank(moves);
      count += restrict_to(blamed, moves);
      if (count > exact_limit) return {};
      obligatory_.push_back(std::make_unique<Extensions>(context.evidence, moves));
      result.push_back({&own.modes, own.clocks, own.probability, obligatory_.back().get()});
    }
    return result;
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

  /// For each mode the greater probability, in order of mode.
  static void take_best(std::vector<Move>& moves, const std::vector<Move>& others) {
    for (const Move& other : others) {
      const auto at = std::lower_bound(moves.begin(), moves.end(), other.mode,
                                       [](const Move& move, automata::ModeId mode) { return move.mode < mode; });
      if (at != moves.end() && at->mode == other.mode) {
        at->probability = std::max(at->probability, other.probability);
      } else {
        moves.insert(at, other);
      }
    }
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
  std::vector<std::unique_ptr<Transient>> transient_;  ///< of sources with a running clock; reused
  std::vector<Source> sources_;
  std::vector<PossibleShare::Share> shares_;         ///< of one source, by clock or of all
  std::vector<std::vector<std::size_t>> differing_;  ///< by source
  std::optional<Rest> rest_;                         ///< of `sources_`, where no clock matters in any of them
  TrajectorySearch search_;
  std::shared_ptr<const ConflictSet> refuted_;  ///< by the readings that `condition` was asked about last
  Observation set_aside_;                       ///< in the last update
  std::size_t widened_ = 0;                     ///< cycles on end for these
  std::vector<std::unique_ptr<Extensions>> obligatory_;
  PossibleShare possible_;
  ClockMerging merging_;
  Combinations combinations_, combinations_before_;  ///< the belief, and the one that the last step started from
  mutable bool belief_listed_ = false, before_listed_ = false;
  bool merged_ = false;       ///< clocks, in the last step
  bool steady_ = false;       ///< as `steady` says
  Ticks now_;                 ///< the end of the step that is being worked out
  double missing_ratio_ = 0;  ///< what is missing since the start, at most, by what was kept
  double replaced_ = 0;       ///< the share of the belief, at most, that took the place of something else
};

}  // namespace

std::unique_ptr<Filter> make_k_best_filter(automata::PlantStep& step, const EstimatorOptions& options) {
  return std::make_unique<KBest>(step, options);
}

}  // namespace rmpl::runtime
