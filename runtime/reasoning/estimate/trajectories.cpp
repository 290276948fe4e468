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

constexpr std::size_t least_index = 256;

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
  best_.clear();
  ways_.clear();
  explored_ = dropped_ = unexplored_ = 0;
  checked_ = 0;
  cut_ = false;
  enumerate(sources, now, k, deadline);
  for (const Source& source : obligatory) {
    for (std::size_t i = 0; source.extensions->bound(i) > 0;) {
      if (i == source.extensions->found().size()) {
        source.extensions->check_one();
        continue;
      }
      const Extension& extension = source.extensions->found()[i++];
      const auto [target, fresh] = reach(source, extension, now);
      if (fresh) weigh(*target, extension.factor, sources, now);
      target->obligatory = true;
    }
    checked_ += source.extensions->checked();
  }
  keep(k);
}

void TrajectorySearch::enumerate(std::span<const Source> sources, automata::Ticks now, std::size_t k,
                                 const Deadline& deadline) {
  cursors_.assign(sources.size(), 0);
  barriers_.assign(sources.size(), 0);
  line_up(sources);
  joint_known_ = false;
  next_look_ = 0;
  const bool may_tighten = options_.merge_trajectories && options_.observation_factor;
  tight_ = !may_tighten;
  if (may_tighten && long_) tighten(sources);

  while (!fronts_.empty()) {
    if (!tight_ && checked_ >= options_.patience) tighten(sources);
    if (deadline && count_ > 0 && std::chrono::steady_clock::now() >= *deadline) {
      cut_ = true;
      break;
    }
    if (best_.size() == k && enough_found(sources)) break;
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
        weigh(*target, extension.factor, sources, now);
        note(target->worth, k);
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
  long_ = may_tighten && tight_ && checked_ >= options_.patience / 2;
  unexplored_ = fronts_.empty() ? 0.0 : unexplored(sources);
}

/// Whether no state that was not found yet comes near the k-th best. That the bounds of several sources cannot be about
/// one state is looked into before a candidate is checked, now and then: it costs as much as some of these.
bool TrajectorySearch::enough_found(std::span<const Source> sources) {
  constexpr std::size_t pace = 2;
  const double enough = best_.front() * (1 - stop_margin);
  if (fronts_.front().bound >= enough) return false;
  if (!options_.merge_trajectories) return true;
  double sum = 0;
  for (const Front& front : fronts_) sum += front.bound;
  if (sum < enough) return true;
  const std::uint32_t next = fronts_.front().source;
  if (checked_ < next_look_ || cursors_[next] < sources[next].extensions->found().size()) return false;
  next_look_ = checked_ + pace;
  if (!joint_known_) joint_.look_at(sources);
  joint_known_ = true;
  left_.assign(sources.size(), 0);
  for (const Front& front : fronts_) left_[front.source] = front.bound;
  return !joint_.reaches(left_, enough);
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
  for (const Source& source : sources) mass += source.weight;
  if (!options_.merge_trajectories || !options_.observation_factor) {
    return std::max(0.0, mass - explored_) + rounding * mass;
  }
  const double found = std::accumulate(best_.begin(), best_.end(), 0.0);
  if (mass - explored_ <= noticeable * found) return std::max(0.0, mass - explored_) + rounding * mass;
  mass = 0;
  for (const Source& source : sources) mass += source.weight * source.extensions->mass();
  double explored = 0;
  for (const Way& way : ways_) {
    explored += sources[way.source].extensions->share(targets_[way.target].state.modes, way.probability);
  }
  return std::max(0.0, mass - explored) + rounding * mass;
}

/// The target of an extension, and whether it is new; then it has no worth yet. Valid until the next call.
std::pair<TrajectorySearch::Target*, bool> TrajectorySearch::reach(const Source& source, const Extension& extension,
                                                                   automata::Ticks now) {
  if (2 * (count_ + 1) > index_.size()) grow_index();
  if (count_ == targets_.size()) targets_.emplace_back();
  Target& fresh = targets_[count_];
  fresh.state.modes = extension.modes;
  fresh.state.clock_starts.resize(extension.modes.size());
  for (std::size_t c = 0; c < extension.modes.size(); ++c) {
    fresh.state.clock_starts[c] =
        clocks_.advance(c, source.state->modes[c], source.state->clock_starts[c], extension.modes[c], now);
  }
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = SystemStateHash{}(fresh.state) & mask;
  for (; index_[slot] != 0; slot = (slot + 1) & mask) {
    Target& known = targets_[index_[slot] - 1];
    if (known.state == fresh.state) return {&known, false};
  }
  index_[slot] = static_cast<std::uint32_t>(++count_);
  fresh.obligatory = false;
  return {&fresh, true};
}

/// Sums, or without merging takes the greatest of, the trajectories into a target.
void TrajectorySearch::weigh(Target& target, double factor, std::span<const Source> sources, automata::Ticks now) {
  const auto number = static_cast<std::uint32_t>(&target - targets_.data());
  double sum = 0;
  double greatest = 0;
  target.leading = 0;
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    const double probability = trajectory(s, sources[s], target, now);
    if (probability == 0) continue;
    ways_.push_back({number, s, probability});
    sum += probability;
    if (probability > greatest) {
      greatest = probability;
      target.leading = s;
    }
  }
  target.prior = options_.merge_trajectories ? sum : greatest;
  target.worth = target.prior * (options_.observation_factor ? factor : 1.0);
}

/// The probability of being in the source and going to exactly this target, clocks included.
double TrajectorySearch::trajectory(std::uint32_t number, const Source& source, const Target& target,
                                    automata::Ticks now) {
  const automata::SystemState& from = *source.state;
  const automata::SystemState& to = target.state;
  const auto move = [&](std::size_t c) {
    const double prior = source.extensions->prior(c, to.modes[c]);
    if (prior == 0) return 0.0;
    const bool meets = to.clock_starts[c] == clocks_.advance(c, from.modes[c], from.clock_starts[c], to.modes[c], now);
    return meets ? prior : 0.0;
  };
  if (barriers_[number] < to.modes.size() && move(barriers_[number]) == 0) return 0;
  double product = 1;
  for (std::size_t c = 0; c < to.modes.size(); ++c) {
    const double prior = move(c);
    if (prior == 0) {
      barriers_[number] = c;
      return 0;
    }
    product *= prior;
  }
  return source.weight * product;
}

void TrajectorySearch::note(double worth, std::size_t k) {
  if (best_.size() == k) {
    if (worth <= best_.front()) return;
    std::pop_heap(best_.begin(), best_.end(), std::greater<>{});
    best_.pop_back();
  }
  best_.push_back(worth);
  std::push_heap(best_.begin(), best_.end(), std::greater<>{});
}

void TrajectorySearch::keep(std::size_t k) {
  kept_.clear();
  double lost = dropped_;
  Belief obligatory;
  // Ties with the k-th best are told apart by state.
  const double least = best_.size() < k ? 0.0 : best_.front() * (1 - stop_margin);
  for (std::size_t i = 0; i < count_; ++i) {
    const Target& target = targets_[i];
    if (target.obligatory || target.worth >= least) {
      (target.obligatory ? obligatory : kept_).push_back({target.state, target.worth});
    } else {
      lost += target.worth;
    }
  }
  put_in_order(kept_);
  // Whole sets of equal rank are kept.
  for (; !options_.ranks && kept_.size() > k; kept_.pop_back()) lost += kept_.back().probability;
  if (!obligatory.empty()) {
    kept_.insert(kept_.end(), std::make_move_iterator(obligatory.begin()), std::make_move_iterator(obligatory.end()));
    put_in_order(kept_);
  }
  lost_ = lost + unexplored_;
}

void TrajectorySearch::grow_index() {
  index_.assign(index_.size() * 2, 0);
  const std::size_t mask = index_.size() - 1;
  for (std::size_t i = 0; i < count_; ++i) {
    std::size_t slot = SystemStateHash{}(targets_[i].state) & mask;
    while (index_[slot] != 0) slot = (slot + 1) & mask;
    index_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace rmpl::runtime
