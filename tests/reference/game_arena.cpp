// The game without bounds. SPDX-License-Identifier: MIT
#include "tests/reference/game_arena.hpp"

#include <algorithm>
#include <set>

#include "tests/reference/models.hpp"

namespace rmpl::reference {

using automata::ModeId;
using automata::Modes;
using automata::Transition;

Window window_of(const automata::Timing& timing, std::int64_t cycle) {
  Window window;
  if (!timing.upper.is_infinite()) window.last = std::max<std::int64_t>(1, (timing.upper.count + cycle - 1) / cycle);
  window.first = std::max<std::int64_t>(1, std::min(timing.lower.count / cycle + 1, window.last));
  return window;
}

Node ModeArena::number(const Modes& modes) {
  const auto [at, fresh] = numbers_.try_emplace(modes, nodes_.size());
  if (fresh) nodes_.push_back(&at->first);
  return at->second;
}

std::optional<Turn> ModeArena::turn(Node node, GameStep::Action action) {
  const Modes from = modes(node);
  const auto& freedom = step().freedom(from, action);
  if (!freedom) return std::nullopt;
  Turn turn;
  turn.waits = true;
  for (std::size_t c = 0; c < from.size(); ++c) turn.waits = turn.waits && !(*freedom)[c].leaves_at_once(from[c]);

  using Choice = std::pair<ModeId, const Transition*>;
  std::vector<std::vector<Choice>> options;
  std::vector<std::size_t> sizes;
  std::int64_t last = Window::never;
  std::int64_t first = Window::never;
  bool any_due = false;
  for (std::size_t c = 0; c < from.size(); ++c) {
    const Freedom& own = (*freedom)[c];
    auto& choices = options.emplace_back();
    for (const ModeId to : own.at_once) choices.emplace_back(to, nullptr);
    // However old it is, it has left after the cycle by which a new one has to leave.
    const bool due = !own.dawdles && std::any_of(own.timed.begin(), own.timed.end(), [&](const Transition* t) {
      return window_of(*t->timing, cycle_).last <= 1;
    });
    any_due = any_due || (choices.empty() && due);
    if (choices.empty() && !due) choices.emplace_back(from[c], nullptr);
    for (const Transition* t : own.timed) {
      choices.emplace_back(t->to, t);
      const Window window = window_of(*t->timing, cycle_);
      first = std::min(first, window.first);
      if (!own.dawdles) last = std::min(last, window.last);
    }
    sizes.push_back(choices.size());
  }
  std::set<Nogood> contradicted;
  const bool bounded = last != Window::never;
  for (const auto& tuple : tuples(sizes)) {
    Modes next;
    for (std::size_t c = 0; c < tuple.size(); ++c) next.push_back(options[c][tuple[c]].first);
    const auto& nogoods = step().nogoods(next);
    contradicted.insert(nogoods.begin(), nogoods.end());
    if (!nogoods.empty() || (turn.waits && next == from)) continue;
    Result& result = turn.results.emplace_back();
    result.to = number(next);
    for (std::size_t c = 0; c < tuple.size() && !turn.waits; ++c)
      if (const Transition* t = options[c][tuple[c]].second) result.chosen.emplace_back(c, t->branch);
    result.soonest = (turn.waits ? first : 1) * cycle_;
    result.latest = {turn.waits && !bounded ? 1U : 0U, turn.waits && bounded ? last * cycle_ : result.soonest};
  }
  turn.ends = !turn.waits || bounded;
  turn.at_once = !turn.waits || any_due;
  turn.contradicted.assign(contradicted.begin(), contradicted.end());
  turn.dead = turn.results.empty() && turn.ends;
  return turn;
}

}  // namespace rmpl::reference
