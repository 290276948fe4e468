// Memory from update to update, and shares of what is possible, clock by clock.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/sources.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "runtime/reasoning/estimate/rank.hpp"

namespace rmpl::runtime {

using automata::ControlAction;
using automata::Modes;
using automata::Move;
using automata::Observation;
using automata::Ticks;

namespace {

/// Beyond so many remembered modes, of all sources and observations together, all are forgotten.
constexpr std::size_t most_remembered = 1u << 15;

/// Beyond so many conflicts that need no observation all are forgotten: each candidate is compared with each.
constexpr std::size_t most_lasting = 512;

constexpr std::size_t exact_limit = KBestModel::exact_limit;

/// One by the share of the outcomes that is possible; 0 where none is, 1 where it is not known.
double scale_by(PossibleShare::Share share) { return !share.exact ? 1 : share.value > 0 ? 1 / share.value : 0; }

/// By how much more than that outcomes may be worth, at most.
double slack_of(PossibleShare::Share share) {
  if (share.exact) return 1;
  return share.value > 0 ? 1 / share.value : std::numeric_limits<double>::infinity();
}

/// For each mode the greatest probability, over every `stride`-th of the moves from `first` on.
ComponentMoves best_of(const std::vector<const ComponentMoves*>& moves, std::size_t first, std::size_t stride) {
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

/// For each mode the greater probability, in order of mode.
void take_best(std::vector<Move>& moves, const std::vector<Move>& others) {
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
std::size_t restrict_to(const std::vector<bool>& free, std::vector<std::vector<Move>>& moves) {
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

}  // namespace

Sources::Remembered::Remembered(ReadingEvidence& evidence, const MoveTable::Moves& moves, PossibleShare::Share share)
    : extensions(evidence, moves), scale(scale_by(share)), slack(slack_of(share)) {}

Sources::Sources(KBestModel& model)
    : model_(model),
      step_(model.step),
      table_(step_.plant(), model.options.ranks),
      open_(step_, model.openings ? &*model.openings : nullptr) {}

Sources::Context& Sources::context(const Observation& observation) {
  const auto [known, fresh] = contexts_.try_emplace(observation, step_, observation, lasting_,
                                                    model_.options.observation_factor ? &open_ : nullptr);
  if (fresh) ++remembered_;
  return known->second;
}

/// What was remembered is let go of bit by bit.
void Sources::begin_update() {
  table_.limit_timed();
  for (std::size_t i = 0; i < 4 * model_.options.k && !retired_.empty(); ++i) {
    auto& extensions = retired_.begin()->second.extensions;
    if (extensions.empty()) {
      retired_.erase(retired_.begin());
    } else {
      extensions.erase(extensions.begin());
    }
  }
  // However large a state is: what a few cycles need.
  const std::size_t sources = std::max(most_remembered / (step_.plant().components.size() + 1), 8 * model_.options.k);
  if (remembered_ < sources && table_.size() < most_remembered && lasting_.conflicts().size() < most_lasting) return;
  retired_ = std::exchange(contexts_, {});
  rest_.reset();
  remembered_ = 0;
  table_.forget();
  if (lasting_.conflicts().size() >= most_lasting) lasting_ = {};
}

std::span<const Source> Sources::of(const Combinations& belief, const StepInput& input, Ticks last) {
  Context& context = this->context(input.observation);
  sources_.clear();
  std::size_t transient = 0;
  differing_.resize(std::max(differing_.size(), belief.size()));
  restarted_.resize(std::max(restarted_.size(), belief.size()));
  for (const Combination& own : belief) {
    std::vector<std::size_t>& differing = differing_[sources_.size()];
    find_differing(own, model_.clocks, differing);
    Source& source = sources_.emplace_back(Source{&own.modes, own.clocks, own.probability, nullptr});
    source.differing = differing;
    source.restarted = restarted(own.modes, input.action, restarted_[sources_.size() - 1]);
    if (Remembered* const known = remembered(context, own, input, last)) {
      source.extensions = &known->extensions;
      source.slack = known->slack;
      source.scales = {&known->scale, 1};
      source.weight *= known->scale;
    } else {
      work_out(transient++, context, own, last, input.now, source);
    }
  }
  rest_.reset();
  if (transient == 0 && input.now > last) rest_ = {&context, input.action, input.now - last};
  return sources_;
}

bool Sources::of_rest(const Combinations& belief, const Combinations& before, const StepInput& input, Ticks last) {
  const auto same_modes = [](const Combination& a, const Combination& b) { return a.modes == b.modes; };
  if (!rest_ || rest_->step != input.now - last || rest_->action != input.action ||
      !std::equal(belief.begin(), belief.end(), before.begin(), before.end(), same_modes) ||
      rest_->context != &context(input.observation)) {
    return false;
  }
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Combination& own = belief[i];
    Source& source = sources_[i];
    source.modes = &own.modes;
    source.clocks = own.clocks;
    find_differing(own, model_.clocks, differing_[i]);
    source.differing = differing_[i];
    source.weight = own.probability * (source.scales.empty() ? 1 : source.scales.front());
  }
  return true;
}

/// The components whose clocks restarts start anew, as `result`.
std::span<const std::size_t> Sources::restarted(const Modes& modes, const ControlAction& action,
                                                std::vector<std::size_t>& result) {
  result.clear();
  if (!model_.has_restarts) return result;
  const std::vector<bool>& all = step_.restarted(modes, action);
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (all[c]) result.push_back(c);
  }
  return result;
}

/// The extensions of modes in which no clock matters; else null, and `moves_` are those of the first clocks.
Sources::Remembered* Sources::remembered(Context& context, const Combination& own, const StepInput& input, Ticks last) {
  key_ = {own.modes, input.action, input.now - last};
  const auto known = context.extensions.find(key_);
  if (known != context.extensions.end()) return &known->second;
  table_.look_up(step_, own.modes, own.clocks.front().starts, input.action, last, input.now, moves_);
  if (!table_.timed().empty()) return nullptr;
  ++remembered_;
  const auto moves_of = [&](std::size_t c) { return moves_[c]->moves(); };
  const auto share = possible_share(own.modes, moves_of, model_.possible.all());
  return &context.extensions.try_emplace(key_, context.evidence, moves_, share).first->second;
}

/// After `remembered` found none. Where clocks differ in what they allow, the extensions are those of the best of
/// them.
void Sources::work_out(std::size_t position, Context& context, const Combination& own, Ticks last, Ticks now,
                       Source& source) {
  if (position == transient_.size()) transient_.push_back(std::make_unique<Transient>());
  Transient& slot = *transient_[position];
  slot.varied.clear();
  slot.moves.clear();
  slot.best.clear();
  std::set_intersection(source.differing.begin(), source.differing.end(), table_.timed().begin(), table_.timed().end(),
                        std::back_inserter(slot.varied));
  if (!slot.varied.empty()) {
    for (const Clocked& clocked : own.clocks) {
      for (const std::size_t c : slot.varied) {
        slot.moves.push_back(table_.look_up_timed(step_, c, clocked.starts[c], last, now));
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
void Sources::scale_up(Transient& slot, const Combination& own, Source& source) {
  const auto [touched, others] = model_.possible.divide(slot.varied);
  const auto common = [&](std::size_t c) { return moves_[c]->moves(); };
  shares_.assign(touched.empty() ? 1 : own.clocks.size(), possible_share(own.modes, common, others));
  for (const std::size_t cluster : touched) multiply_shares(slot, own.modes, cluster);
  slot.scales.clear();
  for (const PossibleShare::Share share : shares_) {
    source.slack = std::max(source.slack, slack_of(share));
    slot.scales.push_back(scale_by(share));
  }
  source.scales = slot.scales;
  source.weight = 0;
  for (std::size_t e = 0; e < own.clocks.size(); ++e) source.weight += source.weight_of(e);
}

/// Takes a cluster into the shares, clock by clock. Where one component of it varies, its moves are cases, and the
/// share is a sum over these.
void Sources::multiply_shares(const Transient& slot, const Modes& modes, std::size_t cluster) {
  const auto take = [&](std::size_t clock, PossibleShare::Share share) {
    shares_[clock] = {shares_[clock].value * share.value, shares_[clock].exact && share.exact};
  };
  std::vector<std::size_t> own;  // of those that vary
  for (std::size_t v = 0; v < slot.varied.size(); ++v) {
    if (model_.possible.has(cluster, slot.varied[v])) own.push_back(v);
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
PossibleShare::Share Sources::possible_share(const Modes& modes, PossibleShare::MovesOf moves,
                                             const PossibleShare::Clusters& clusters) {
  return model_.options.merge_trajectories ? model_.possible.of(modes, moves, clusters) : PossibleShare::Share{};
}

std::vector<Source> Sources::exact_on_blamed(const Combinations& belief, const ConflictSet& refuted,
                                             const StepInput& rest, Ticks last) {
  obligatory_.clear();
  obligatory_restarted_.clear();
  obligatory_restarted_.reserve(belief.size());  // sources refer to them
  const std::vector<bool> blamed = components_in(refuted.conflicts());
  std::vector<Source> result;
  std::size_t count = 0;
  for (const Combination& own : belief) {
    // Of all clocks.
    std::vector<std::vector<Move>> moves;
    for (const Clocked& clocked : own.clocks) {
      const auto& next = step_.moves({own.modes, clocked.starts}, rest.action, last, rest.now);
      moves.resize(next.size());
      for (std::size_t c = 0; c < next.size(); ++c) take_best(moves[c], next[c]);
    }
    if (model_.options.ranks) rank(moves);
    count += restrict_to(blamed, moves);
    if (count > exact_limit) return {};
    obligatory_.push_back(std::make_unique<Extensions>(evidence(rest.observation), moves));
    result.push_back({&own.modes, own.clocks, own.probability, obligatory_.back().get()});
    result.back().restarted = restarted(own.modes, rest.action, obligatory_restarted_.emplace_back());
  }
  return result;
}

/// The components that observations bring into conflict; conflicts that need none are left out.
std::vector<bool> Sources::components_in(const std::vector<Conflict>& conflicts) const {
  std::vector<bool> named(step_.plant().components.size());
  const std::vector<Conflict>& lasting = lasting_.conflicts();
  for (const Conflict& conflict : conflicts) {
    if (std::find(lasting.begin(), lasting.end(), conflict) != lasting.end()) continue;
    for (const Decision& decision : conflict) named[decision.variable] = true;
  }
  return named;
}

}  // namespace rmpl::runtime
