// Episodes.
// SPDX-License-Identifier: MIT
#include "verifier/markov/episodes.hpp"

#include <algorithm>

namespace rmpl::verifier {

namespace {

/// An episode is followed for so many times what has come to its start, as more will come.
constexpr Real more_to_come = 256;

/// Runs that come to a start so many steps after others come there in one step after the other.
constexpr Units soon = 16;

const Episode::Stage no_stage;

}  // namespace

Episode::Episode(Process& process, RowMemory& rows, const Point& start, Units last, const Tolerance& tolerance,
                 Meter& meter)
    : process_(process),
      meter_(meter),
      front_(process, rows, last, tolerance.ignored, tolerance.part * process.prospect(start.state).within(last)) {
  front_.arrive(start, certain());
  front_.settle(0, [](const Point&, const Enclosure&) { return false; });
}

const Episode::Stage& Episode::after(Units steps) {
  const auto number = static_cast<std::size_t>(steps);
  while (stages_.size() < number && !front_.points().empty()) go_on();
  return number == 0 || number > stages_.size() ? no_stage : stages_[number - 1];
}

void Episode::go_on() {
  meter_.poll();
  const auto now = static_cast<Units>(stages_.size() + 1);
  Stage stage;
  front_.leave(now);
  front_.settle(now, [&](const Point& point, const Enclosure& mass) {
    const std::optional<Point> exit = process_.has_clocks(point) ? process_.as_begun(point, now) : point;
    if (exit) stage.ends.emplace_back(exits_.number(*exit), mass);
    return exit.has_value();
  });
  stage.wanted = front_.take_wanted();
  stage.unknown = front_.take_unknown();
  stages_.push_back(std::move(stage));
}

Real Episode::unknown_within(Units steps) {
  Real result = 0;
  for (Units step = 1; step <= steps; ++step) result = rounding::up(result + after(step).unknown, 1);
  return result;
}

bool Episodes::takes(const Point& point, const Enclosure& mass, Units now, Front& front) {
  const std::optional<Point> start = process_.as_begun(point, now);
  if (!start) return false;
  const std::uint32_t number = starts_.number(*start);
  const bool fresh = number == begun_.size();
  if (fresh) begun_.emplace_back();
  Begun& begun = begun_[number];
  const bool again = !fresh && now - begun.last <= soon;
  begun.last = now;
  if (!again) return false;
  begun.all = rounding::up(begun.all + mass.upper, 1);
  if (begun.all > begun.foreseen) follow_finer(*start, begun, now, front);
  begun.going_on.emplace_back(now, mass);
  ++going_on_;
  return true;
}

/// What the finer episode leaves out may be what the other one has followed until now: all of it counts as unknown.
void Episodes::follow_finer(const Point& start, Begun& begun, Units now, Front& front) {
  begun.foreseen = begun.all * more_to_come;
  const Units first = begun.going_on.empty() ? now : begun.going_on.front().first;
  const Tolerance own{tolerance_.ignored / begun.foreseen, 0, tolerance_.part};
  begun.episode = std::make_unique<Episode>(process_, rows_, start, last_ - first, own, meter_);
  for (const auto& [since, mass] : begun.going_on) {
    front.add_unknown(rounding::up(mass.upper * begun.episode->unknown_within(now - since), 1));
  }
}

void Episodes::leave(Units now, Front& front) {
  for (Begun& begun : begun_) {
    if (!begun.going_on.empty()) leave(begun, now, front);
  }
}

void Episodes::leave(Begun& begun, Units now, Front& front) {
  meter_.poll();
  Episode& episode = *begun.episode;
  sums_.clear();
  for (const auto& [since, mass] : begun.going_on) {
    const Units steps = now - since;
    const Episode::Stage& stage = episode.after(steps);
    if (stage.wanted.upper > 0) front.add_wanted(mass * stage.wanted);
    if (stage.unknown > 0) front.add_unknown(rounding::up(mass.upper * stage.unknown, 1));
    for (const auto& [exit, part] : stage.ends) {
      if (sums_.size() <= exit) sums_.resize(exit + std::size_t{1});
      sums_[exit] = sums_[exit] + mass * part;
    }
  }
  const std::size_t before = begun.going_on.size();
  std::erase_if(begun.going_on, [&](const auto& own) { return episode.is_over_by(now - own.first); });
  going_on_ -= before - begun.going_on.size();
  for (std::size_t exit = 0; exit < sums_.size(); ++exit) {
    if (sums_[exit].upper > 0) front.arrive(process_.later(episode.exits()[exit], now), sums_[exit]);
  }
}

}  // namespace rmpl::verifier
