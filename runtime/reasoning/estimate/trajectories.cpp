// The leading system states over the extensions of all tracked ones.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/trajectories.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>

#include "base/check.hpp"

namespace rmpl::runtime {
namespace {

/// The search goes on while an unseen state might come within this of the k-th best, so that ties are all seen, and
/// what was rounded in bounds and products does no harm.
constexpr double stop_margin = 1e-9;

constexpr std::size_t least_index = 32;

/// A search that is taken up again and again begins anew once it has so many times the targets that it needs.
constexpr std::size_t outgrown = 2;

/// What several sources can give to one target is looked into again after so many candidates, at least; the first time
/// for so many sums over the sources; and a candidate costs as much as so many terms of these for each component.
constexpr std::size_t pace = 2;
constexpr std::size_t first_look = 512;
constexpr std::size_t terms_of_check = 128;

/// A run whose unexplored mass is more than this share of what it found takes the observation factor into its bounds.
constexpr double noticeable = 0.01;

}  // namespace

void TrajectorySearch::run(std::span<const Source> sources, std::span<const Source> obligatory, automata::Ticks now,
                           std::size_t k, const Deadline& deadline) {
  CHECK(k > 0);
  // About as large as the last run wanted it.
  std::size_t slots = least_index;
  while (slots < 4 * count_) slots *= 2;
  index_.assign(slots, 0);
  count_ = 0;
  ways_.clear();
  cursors_.assign(sources.size(), 0);
  barriers_.assign(sources.size(), 0);
  begin(k, sources.size());
  now_ = now;
  line_up(sources);
  if (may_tighten() && long_) tighten(sources);
  enumerate(sources, now, deadline);
  needed_ = count_;
  only_weighed_ = false;
  repeatable_ =
      options_.merge_trajectories && !options_.ranks && obligatory.empty() && !cut_ && tight_ != may_tighten();
  for (const Source& source : obligatory) {
    for (std::size_t i = 0; source.extensions->bound(i) > 0;) {
      if (i == source.extensions->found().size()) {
        source.extensions->check_one();
        continue;
      }
      const Extension& extension = source.extensions->found()[i++];
      const auto [target, fresh] = reach(source, extension, now);
      if (fresh) find_ways(*target, sources, now);
      target->obligatory = true;
    }
    checked_ += source.extensions->checked();
  }
  keep(sources);
}

void TrajectorySearch::run_again(std::span<const Source> sources, automata::Ticks now, const Deadline& deadline) {
  CHECK(repeatable_ && sources.size() == cursors_.size() && now > now_);
  begin(k_, sources.size());
  take_up(sources, now);
  line_up(sources);
  enumerate(sources, now, deadline);
  repeatable_ = !cut_ && tight_ != may_tighten() && count_ <= outgrown * (needed_ + k_);
  only_weighed_ = repeatable_ && !looked_further_;
  keep(sources);
}

/// What every run begins with, whatever it knows of its targets.
void TrajectorySearch::begin(std::size_t k, std::size_t sources) {
  k_ = k;
  weights_.begin(sources);
  best_.clear();
  explored_ = dropped_ = unexplored_ = 0;
  checked_ = 0;
  cut_ = false;
  joint_known_ = false;
  next_look_ = 0;
  nodes_ = first_look;
  tight_ = !may_tighten();
}

/// Moves the known targets on to `now`, and weighs them.
void TrajectorySearch::take_up(std::span<const Source> sources, automata::Ticks now) {
  auto ways = ways_.cbegin();
  for (std::uint32_t t = 0; t < count_; ++t) {
    Target& target = targets_[t];
    auto end = ways;
    while (end != ways_.cend() && end->target == t) ++end;
    weigh(target, {ways, end}, sources);
    ways = end;
    note(target.worth);
    explored_ += target.prior;
  }
  now_ = now;
}

void TrajectorySearch::enumerate(std::span<const Source> sources, automata::Ticks now, const Deadline& deadline) {
  looked_further_ = false;
  while (!fronts_.empty()) {
    if (!tight_ && checked_ >= options_.patience) tighten(sources);
    if (deadline && count_ > 0 && std::chrono::steady_clock::now() >= *deadline) {
      cut_ = true;
      break;
    }
    if (best_.size() == k_ && enough_found(sources)) break;
    looked_further_ = true;
    std::pop_heap(fronts_.begin(), fronts_.end(), Front::ByBound{});
    const std::uint32_t s = fronts_.back().source;
    fronts_.pop_back();
    const Source& source = sources[s];
    if (cursors_[s] == source.extensions->found().size()) {
      if (checked_ == options_.candidates) {
        cut_ = true;
        fronts_.push_back({0, s});  // not exhausted
        break;
      }
      const std::size_t before = source.extensions->checked();
      source.extensions->check_one();
      checked_ += source.extensions->checked() - before;
    } else {
      const Extension& extension = source.extensions->found()[cursors_[s]++];
      const auto [target, fresh] = reach(source, extension, now);
      if (fresh) {
        find_ways(*target, sources, now);
        note(target->worth);
        if (options_.merge_trajectories) explored_ += target->prior;
      }
      if (!options_.merge_trajectories) {
        const double prior = source.weight * extension.prior;
        explored_ += prior;
        if (target->leading != s) dropped_ += prior * (options_.observation_factor ? extension.factor : 1.0);
      }
    }
    const double bound = source.weight * source.extensions->bound(cursors_[s]);
    if (bound > 0) {
      fronts_.push_back({bound, s});
      std::push_heap(fronts_.begin(), fronts_.end(), Front::ByBound{});
    }
  }
  long_ = may_tighten() && tight_ && checked_ >= options_.patience / 2;
  unexplored_ = fronts_.empty() ? 0.0 : unexplored(sources);
}

/// Whether no state that was not found yet comes near the k-th best. That the bounds of several sources cannot be about
/// one state is looked into before a candidate is checked, now and then: it costs as much as some of these. A look that
/// decides nothing is followed by a longer one, and each by candidates that cost as much.
bool TrajectorySearch::enough_found(std::span<const Source> sources) {
  const double enough = best_.front() * (1 - stop_margin);
  if (fronts_.front().bound >= enough) return false;
  if (!options_.merge_trajectories) return true;
  double sum = 0;
  for (const Front& front : fronts_) sum += front.bound;
  if (sum < enough) return true;
  const std::uint32_t next = fronts_.front().source;
  if (checked_ < next_look_ || cursors_[next] < sources[next].extensions->found().size()) return false;
  if (!joint_known_) joint_.look_at(sources);
  joint_known_ = true;
  left_.assign(sources.size(), 0);
  for (const Front& front : fronts_) left_[front.source] = front.bound;
  const bool reaches = joint_.reaches(left_, enough, nodes_);
  const std::size_t spent = (nodes_ - joint_.nodes_left()) * sources.size();
  next_look_ = checked_ + std::max(pace, spent / (terms_of_check * sources.front().modes->size()));
  if (joint_.undecided()) nodes_ *= 2;
  return !reaches;
}

/// Puts the sources into the queue, each with what it has left.
void TrajectorySearch::line_up(std::span<const Source> sources) {
  fronts_.clear();
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    const double bound = sources[s].weight * sources[s].extensions->bound(cursors_[s]);
    if (bound > 0) fronts_.push_back({bound, s});
  }
  std::make_heap(fronts_.begin(), fronts_.end(), Front::ByBound{});
}

/// From here on bounds know of the observation factor. What a source then finds again is known already.
void TrajectorySearch::tighten(std::span<const Source> sources) {
  tight_ = true;
  joint_known_ = false;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    if (sources[s].extensions->tighten()) cursors_[s] = 0;
  }
  line_up(sources);
}

/// An upper bound of the worth of what was not looked at. What was refuted counts as such.
double TrajectorySearch::unexplored(std::span<const Source> sources) {
  constexpr double rounding = 1e-14;
  double mass = 0;
  for (const Source& source : sources) mass += source.following();
  if (!options_.merge_trajectories || !options_.observation_factor) {
    return std::max(0.0, mass - explored_) + rounding * mass;
  }
  const double found = std::accumulate(best_.begin(), best_.end(), 0.0);
  if (mass - explored_ <= noticeable * found) return std::max(0.0, mass - explored_) + rounding * mass;
  // Of each source by its shares or by its priors. A share may be more than the prior, so that only like is taken from
  // like. Shares are known once the mass was asked for.
  std::vector<double> most, shares(sources.size()), priors(sources.size());
  for (const Source& source : sources) most.push_back(source.greatest_worth());
  for (const Way& way : ways_) {
    const Source& source = sources[way.source];
    const double prior = source.weight * way.chance;
    priors[way.source] += prior;
    shares[way.source] += source.extensions->share(targets_[way.target].state.modes, prior);
  }
  double left = 0;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const double all = sources[s].following();
    left += std::max(0.0, std::min(all - priors[s], most[s] - shares[s])) + rounding * std::min(all, most[s]);
  }
  return left;
}

/// The target of an extension, and whether it is new; then it has no worth yet. Valid until the next call.
std::pair<TrajectorySearch::Target*, bool> TrajectorySearch::reach(const Source& source, const Extension& extension,
                                                                   automata::Ticks now) {
  if (2 * (count_ + 1) > index_.size()) rebuild_index(2 * index_.size());
  if (count_ == targets_.size()) targets_.emplace_back();
  Target& fresh = targets_[count_];
  fresh.state.modes = extension.modes;
  fresh.state.clock_starts.resize(options_.merge_trajectories ? 0 : extension.modes.size());
  for (std::size_t c = 0; c < fresh.state.clock_starts.size(); ++c) {
    fresh.state.clock_starts[c] = clocks_.advance(c, (*source.modes)[c], source.clocks.front().starts[c],
                                                  extension.modes[c], now, !source.goes_on(c));
  }
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = SystemStateHash{}(fresh.state) & mask;
  for (; index_[slot] != 0; slot = (slot + 1) & mask) {
    Target& known = targets_[index_[slot] - 1];
    if (known.state == fresh.state) return {&known, false};
  }
  index_[slot] = static_cast<std::uint32_t>(++count_);
  fresh.obligatory = false;
  fresh.factor = options_.observation_factor ? extension.factor : 1.0;
  return {&fresh, true};
}

/// Clocks may each allow something else, so that a target of the best moves of all is not one of any.
void TrajectorySearch::note(double worth) {
  if (!(worth > 0)) return;
  if (best_.size() == k_) {
    if (worth <= best_.front()) return;
    std::pop_heap(best_.begin(), best_.end(), std::greater<>{});
    best_.pop_back();
  }
  best_.push_back(worth);
  std::push_heap(best_.begin(), best_.end(), std::greater<>{});
}

void TrajectorySearch::keep(std::span<const Source> sources) {
  std::size_t kept = 0;
  double lost = dropped_;
  Combinations obligatory;
  // Ties with the k-th best are told apart by state.
  const double least = best_.size() < k_ ? 0.0 : best_.front() * (1 - stop_margin);
  auto ways = ways_.cbegin();
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Target& target = targets_[i];
    auto end = ways;
    while (end != ways_.cend() && end->target == i) ++end;
    if (target.worth > 0 && (target.obligatory || target.worth >= least)) {
      if (!target.obligatory && kept == kept_.size()) kept_.emplace_back();
      tell(target, {ways, end}, sources, target.obligatory ? obligatory.emplace_back() : kept_[kept++]);
    } else {
      lost += target.worth;
    }
    ways = end;
  }
  kept_.resize(kept);
  put_in_order(kept_);
  // Whole sets of equal rank are kept.
  for (; !options_.ranks && kept_.size() > k_; kept_.pop_back()) lost += kept_.back().probability;
  if (!obligatory.empty()) {
    kept_.insert(kept_.end(), std::make_move_iterator(obligatory.begin()), std::make_move_iterator(obligatory.end()));
    put_in_order(kept_);
  }
  lost_ = lost + unexplored_;
}

void TrajectorySearch::rebuild_index(std::size_t slots) {
  index_.assign(slots, 0);
  const std::size_t mask = index_.size() - 1;
  for (std::size_t i = 0; i < count_; ++i) {
    std::size_t slot = SystemStateHash{}(targets_[i].state) & mask;
    while (index_[slot] != 0) slot = (slot + 1) & mask;
    index_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace rmpl::runtime
