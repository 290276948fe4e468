// The ways into a target: what it is worth by them, and the clocks that they lead to.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/reasoning/estimate/trajectories.hpp"

namespace rmpl::runtime {

/// The ways into a target that is new, and what it is worth by them.
void TrajectorySearch::find_ways(Target& target, std::span<const Source> sources, automata::Ticks now) {
  const auto number = static_cast<std::uint32_t>(&target - targets_.data());
  const auto before = static_cast<std::ptrdiff_t>(ways_.size());
  for (std::uint32_t s = 0; s < sources.size(); ++s) {
    const double way = chance(s, sources[s], target, now);
    if (way > 0) ways_.push_back({number, s, way});
  }
  weigh(target, {ways_.cbegin() + before, ways_.cend()}, sources);
}

/// Sums, or without merging takes the greatest of, the trajectories into a target.
void TrajectorySearch::weigh(Target& target, std::span<const Way> ways, std::span<const Source> sources) const {
  double sum = 0;
  double greatest = 0;
  target.leading = 0;
  for (const Way& way : ways) {
    const double probability = sources[way.source].weight * way.chance;
    sum += probability;
    if (probability > greatest) {
      greatest = probability;
      target.leading = way.source;
    }
  }
  target.prior = options_.merge_trajectories ? sum : greatest;
  target.worth = target.prior * target.factor;
}

/// The probability of going from the source to exactly this target; without merging clocks included.
double TrajectorySearch::chance(std::uint32_t number, const Source& source, const Target& target, automata::Ticks now) {
  const automata::Modes& from = *source.modes;
  const automata::SystemState& to = target.state;
  const auto move = [&](std::size_t c) {
    const double prior = source.extensions->prior(c, to.modes[c]);
    if (prior == 0 || options_.merge_trajectories) return prior;
    const automata::Ticks start = source.clocks.front().starts[c];
    return to.clock_starts[c] == clocks_.advance(c, from[c], start, to.modes[c], now, !source.goes_on(c)) ? prior : 0.0;
  };
  if (barriers_[number] < to.modes.size() && move(barriers_[number]) == 0) return 0;
  double product = 1;
  auto varied = source.varied.begin();
  for (std::size_t c = 0; c < to.modes.size(); ++c) {
    const double prior = move(c);
    if (prior == 0) {
      barriers_[number] = c;
      return 0;
    }
    if (varied != source.varied.end() && *varied == c) {
      ++varied;
    } else {
      product *= prior;
    }
  }
  if (source.varied.empty() || !(source.weight > 0)) return product;
  return product * (weights_.into(number, source, to.modes).sum / source.weight);
}

/// A target with the clocks that the ways into it lead to, in place of another.
void TrajectorySearch::tell(const Target& target, std::span<const Way> ways, std::span<const Source> sources,
                            Combination& result) {
  result.modes = target.state.modes;
  result.probability = target.worth;
  if (!options_.merge_trajectories) {
    result.clocks = {{target.state.clock_starts, target.worth}};
    return;
  }
  telling_.clear();
  for (std::size_t c = 0; c < result.modes.size(); ++c) {
    if (clocks_.live(c, result.modes[c])) telling_.push_back(c);
  }
  collected_.begin(result.clocks, telling_);
  for (const Way& way : ways) {
    const double worth = sources[way.source].weight * way.chance * target.factor;
    if (worth > 0) add_clocks(result.modes, way.source, sources[way.source], worth);
  }
  collected_.end();
}

/// What the clocks of a source become, with what all of them are worth together there. They stay apart where no clock
/// that tells them apart starts anew; where all of these do, they become one.
void TrajectorySearch::add_clocks(const automata::Modes& modes, std::uint32_t number, const Source& source,
                                  double worth) {
  entered_.clear();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::ModeId from = (*source.modes)[c], to = modes[c];
    if (from != to || !source.goes_on(c)) entered_.emplace_back(c, clocks_.advance(c, from, {}, to, now_, true));
  }
  const auto moved =
      static_cast<std::size_t>(std::count_if(source.differing.begin(), source.differing.end(), [&](std::size_t c) {
        return (*source.modes)[c] != modes[c] || !source.goes_on(c);
      }));
  const auto add = [&](std::size_t clock, std::size_t among, double probability) {
    std::vector<automata::Ticks>& starts = collected_.draft(source.clocks[clock].starts);
    for (const auto& [c, start] : entered_) starts[c] = start;
    collected_.add(among, probability);
  };
  const std::size_t before = collected_.size();
  if (moved == source.differing.size()) return add(0, before, worth);
  const ClockWeights::Weights& weights = weights_.into(number, source, modes);
  for (std::size_t e = 0; e < weights.by_clock.size(); ++e) {
    const double own = weights.by_clock[e];
    if (own > 0) add(e, moved == 0 ? before : collected_.size(), worth * own / weights.sum);
  }
}

}  // namespace rmpl::runtime
