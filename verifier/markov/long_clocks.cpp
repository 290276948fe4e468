// Long clocks.
// SPDX-License-Identifier: MIT
#include "verifier/markov/long_clocks.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "verifier/markov/markov.hpp"

namespace rmpl::verifier {

using automata::ModeId;

namespace {

/// The last reading up to which no time bound of an exit of the mode is near.
Units quiet_until(const automata::Component& component, ModeId mode, automata::Ticks period) {
  Units result = unbounded;
  for (const automata::Transition& t : component.transitions) {
    if (t.from == mode && t.timing) result = std::min(result, t.timing->lower.count / period.count - 2);
  }
  return result == unbounded ? 0 : result;
}

}  // namespace

Ages::Ages(const automata::Plant& plant, automata::Ticks period, std::optional<Units> longest_in_state, bool for_ever)
    : longest_in_state_(longest_in_state.value_or(unbounded)) {
  for (const automata::Component& component : plant.components) {
    auto& settled = settled_.emplace_back();
    auto& quiet = quiet_.emplace_back();
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const auto own = settled_reading(component, ModeId(m), period);
      if (!own && for_ever) {
        throw base::InputError("the density of a transition of " + component.name +
                               " is not exponential and has no upper bound, and the probability of leaving the mode "
                               "changes for ever: expected "
                               "a time in --within");
      }
      settled.push_back(own.value_or(unbounded));
      quiet.push_back(quiet_until(component, ModeId(m), period));
    }
  }
}

Units Ages::after(std::size_t component, ModeId from, Units age, ModeId to, bool restarted) const {
  if (from != to || restarted) return entered(component, to);
  return age == kept_apart ? kept_apart : std::min(age + 1, settled_[component][to.index()]);
}

LongClocks::LongClocks(Units longest_in_state) : longest_in_state_(longest_in_state) {
  number_of({});
  passages_.push_back(nullptr);  // 0: all long clocks go on
}

std::uint32_t LongClocks::number_of(const Starts& starts) {
  const auto [at, fresh] = start_numbers_.try_emplace(starts, static_cast<std::uint32_t>(starts_.size()));
  if (fresh) starts_.push_back(&at->first);
  return at->second;
}

std::uint32_t LongClocks::number(const Passage& passage, std::size_t before) {
  bool same = passage.size() == before;
  for (std::size_t i = 0; same && i < passage.size(); ++i) same = passage[i].clock == i;
  if (same) return 0;
  const auto [at, fresh] = passage_numbers_.try_emplace(passage, static_cast<std::uint32_t>(passages_.size()));
  if (fresh) passages_.push_back(&at->first);
  return at->second;
}

Point LongClocks::at_start(const Settled& settled) {
  Starts starts;
  for (const Units reading : settled.readings) starts.push_back(-reading);
  return {settled.state, number_of(starts)};
}

Point LongClocks::follow(const Point& from, const Branch& edge, Units now) {
  Point result{edge.to, from.starts};
  if (edge.passage != 0) {
    const Starts& before = *starts_[from.starts];
    Starts after;
    for (const Source& source : *passages_[edge.passage]) {
      after.push_back(source.clock ? before[*source.clock] : now - source.reading);
    }
    result.starts = number_of(after);
  }
  if (now <= lasts_until(result)) return result;
  std::vector<Units> readings;
  for (const Units start : *starts_[result.starts]) readings.push_back(now - start);
  const Settled settled = settle(result.state, readings);
  Starts starts;
  for (const Units reading : settled.readings) starts.push_back(now - reading);
  return {settled.state, number_of(starts)};
}

Units LongClocks::lasts_until(const Point& at) {
  const std::vector<Units>& most = longest(at.state);
  Units result = unbounded;
  if (most.empty()) return result;
  const Starts& starts = *starts_[at.starts];
  for (std::size_t i = 0; i < most.size(); ++i) result = std::min(result, starts[i] + most[i]);
  return result;
}

bool LongClocks::has_clocks(const Point& at) {
  return in_state(at.state).youngest != unbounded || !starts_[at.starts]->empty();
}

std::optional<Point> LongClocks::as_begun(const Point& at, Units now) {
  const InState& others = in_state(at.state);
  const Starts& starts = *starts_[at.starts];
  if (starts.empty() && others.most_left <= longest_in_state_) return std::nullopt;
  Units youngest = others.youngest;
  Units oldest = others.oldest;
  for (const Units start : starts) {
    youngest = std::min(youngest, now - start);
    oldest = std::max(oldest, now - start);
  }
  // A clock of a program that starts in a step reads 1 at its end. Those that have run for a few steps are as good as
  // new.
  if (youngest > 1 || oldest > std::max<Units>(longest_in_state_ / 4, 1)) return std::nullopt;
  return later(at, -now);
}

Point LongClocks::later(const Point& at, Units steps) {
  if (at.starts == 0) return at;
  Starts starts = *starts_[at.starts];
  for (Units& start : starts) start += steps;
  return {at.state, number_of(starts)};
}

}  // namespace rmpl::verifier
