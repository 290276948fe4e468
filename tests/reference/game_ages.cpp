// The game with bounds. SPDX-License-Identifier: MIT
#include "tests/reference/game_ages.hpp"

#include <algorithm>
#include <set>

#include "tests/reference/models.hpp"

namespace rmpl::reference {

using automata::ModeId;
using automata::Modes;
using automata::Transition;

namespace {

/// In cycles, or in ticks of dense time.
Window bounds_of(const automata::Timing& timing, std::int64_t cycle) {
  if (cycle > 0) return window_of(timing, cycle);
  return {timing.lower.count, timing.upper.is_infinite() ? Window::never : timing.upper.count};
}

}  // namespace

std::int64_t first_due(const Freedom& freedom, std::int64_t cycle) {
  std::int64_t result = Window::never;
  for (const Transition* t : freedom.timed)
    if (!freedom.dawdles) result = std::min(result, bounds_of(*t->timing, cycle).last);
  return result;
}

std::int64_t age_that_matters(const automata::Component& component, ModeId mode, std::int64_t cycle) {
  std::int64_t result = 0;
  for (const Transition& t : component.transitions) {
    if (t.from != mode || !t.timing || component.is_fault(t)) continue;
    const Window window = bounds_of(*t.timing, cycle);
    result = std::max(result, window.first);
    if (window.last != Window::never) result = std::max(result, window.last + (cycle > 0 ? 0 : 1));
  }
  return result;
}

namespace {

/// Numbers of cycles of a wait, from `first` to `last`; none where `last` is less.
struct Cycles {
  std::int64_t first = 1;
  std::int64_t last = Window::never;
  [[nodiscard]] bool empty() const { return last < first; }
};

Cycles both(Cycles a, Cycles b) { return {std::max(a.first, b.first), std::min(a.last, b.last)}; }

/// After how many cycles a component may still be there.
Cycles staying(Age age, std::int64_t due) { return {1, due == Window::never ? Window::never : due - 1 - age.least}; }

/// After how many cycles, and not before, it may take an exit. In the cycle in which the first exit is due only those
/// that are due are taken.
Cycles leaving(Age age, Window exit, std::int64_t due) {
  const std::int64_t last = exit.last <= due ? due : due - 1;
  Cycles result{std::max<std::int64_t>(2, exit.first - age.most), last == Window::never ? last : last - age.least};
  if (exit.first > last) result.last = 0;
  const bool in_time = std::max(age.least + 1, exit.first) <= std::min(age.most + 1, due - 1);
  const bool overdue = age.most + 1 >= std::max(due, exit.last);
  if (in_time || overdue) result = {1, std::max<std::int64_t>(1, result.empty() ? 1 : result.last)};
  return result;
}

/// The same in dense time, where a component may stay until its exit is due, that instant included.
Cycles staying_dense(Age age, std::int64_t due) { return {0, due == Window::never ? Window::never : due - age.least}; }
Cycles leaving_dense(Age age, Window exit, std::int64_t due) {
  const bool overdue = age.most > due && exit.first <= age.most;
  if (exit.first > due) return {0, overdue ? 0 : -1};
  const Cycles in_time{std::max<std::int64_t>(0, exit.first - age.most),
                       due == Window::never ? Window::never : due - age.least};
  if (!overdue) return in_time;
  return {0, std::max<std::int64_t>(0, in_time.last)};
}

std::int64_t sum(std::int64_t a, std::int64_t b) { return std::min(a + b, Window::never); }

}  // namespace

Node AgedArena::number(Key key) {
  for (std::size_t c = 0; c < key.first.size(); ++c) {
    const std::int64_t most = age_that_matters(step().plant().components[c], key.first[c], cycle_);
    Age& age = key.second[c];
    age = {std::min(age.least, most), std::min(age.most, most), std::min(age.charged, most)};
  }
  const auto [at, fresh] = numbers_.try_emplace(std::move(key), nodes_.size());
  if (fresh) nodes_.push_back(&at->first);
  return at->second;
}

Node AgedArena::fresh(const Modes& modes) { return number({modes, std::vector<Age>(modes.size())}); }

Node AgedArena::start(const Modes& modes) {
  std::vector<Age> ages(modes.size(), Age{0, Window::never, 0});
  if (const auto& freedom = step().freedom(modes, step().idle()))
    for (std::size_t c = 0; c < modes.size(); ++c)
      ages[c].most = first_due((*freedom)[c], cycle_) - (cycle_ > 0 ? 1 : 0);
  return number({modes, std::move(ages)});
}

std::optional<Turn> AgedArena::turn(Node node, GameStep::Action action) {
  const Key from = *nodes_[node];
  const auto& freedom = step().freedom(from.first, action);
  if (!freedom) return std::nullopt;
  Turn turn;
  turn.waits = true;
  for (std::size_t c = 0; c < from.first.size(); ++c)
    turn.waits = turn.waits && !(*freedom)[c].leaves_at_once(from.first[c]) &&
                 !((*freedom)[c].restarts && (from.second[c].least != 0 || from.second[c].most != 0));

  struct Choice {
    ModeId to;
    const Transition* timed;
    Cycles cycles;
  };
  std::vector<std::vector<Choice>> options;
  std::vector<std::size_t> sizes;
  std::vector<std::int64_t> dues;
  for (std::size_t c = 0; c < from.first.size(); ++c) {
    const Freedom& own = (*freedom)[c];
    const Age age = from.second[c];
    const std::int64_t last = dues.emplace_back(first_due(own, cycle_));
    auto& choices = options.emplace_back();
    for (const ModeId to : own.at_once) choices.push_back({to, nullptr, {0, Window::never}});
    const Cycles stay = cycle_ > 0 ? staying(age, last) : staying_dense(age, last);
    if (choices.empty() && !stay.empty()) choices.push_back({from.first[c], nullptr, stay});
    for (const Transition* t : own.timed) {
      const Window bounds = bounds_of(*t->timing, cycle_);
      const Cycles cycles = cycle_ > 0 ? leaving(age, bounds, last) : leaving_dense(age, bounds, last);
      if (!cycles.empty()) choices.push_back({t->to, t, cycles});
    }
    sizes.push_back(choices.size());
  }
  turn.at_once = !turn.waits || std::any_of(options.begin(), options.end(), [&](const auto& choices) {
    return std::none_of(choices.begin(), choices.end(), [](const Choice& choice) { return choice.timed == nullptr; }) &&
           !choices.empty();
  });
  turn.ends = !turn.waits || std::any_of(dues.begin(), dues.end(), [](auto d) { return d != Window::never; });

  std::set<Nogood> contradicted;
  for (const auto& tuple : tuples(sizes)) {
    const std::int64_t shortest = cycle_ > 0 ? 1 : 0;
    Cycles cycles{shortest, turn.waits ? Window::never : shortest};
    Key next = from;
    Result result{};
    for (std::size_t c = 0; c < tuple.size(); ++c) {
      const Choice& choice = options[c][tuple[c]];
      cycles = both(cycles, choice.cycles);
      next.first[c] = choice.to;
      if (choice.timed != nullptr) result.chosen.emplace_back(c, choice.timed->branch);
    }
    if (cycles.empty() || (turn.waits && result.chosen.empty())) continue;
    const auto& nogoods = step().nogoods(next.first);
    contradicted.insert(nogoods.begin(), nogoods.end());
    if (!nogoods.empty()) continue;
    const bool bounded = cycles.last != Window::never;
    std::int64_t charge = bounded ? cycles.last : cycles.first;
    for (std::size_t c = 0; c < tuple.size() && turn.waits; ++c)
      if (dues[c] != Window::never)
        charge = std::min(charge, std::max(from.second[c].most <= dues[c] - shortest ? 0 : shortest,
                                           dues[c] - from.second[c].charged));
    for (std::size_t c = 0; c < tuple.size(); ++c) {
      Age& age = next.second[c];
      if (next.first[c] != from.first[c] || (*freedom)[c].restarts)
        age = {};
      else
        age = {age.least + cycles.first, std::min(sum(age.most, cycles.last), dues[c] - shortest),
               age.charged + charge};
    }
    result.to = number(std::move(next));
    const std::int64_t unit = std::max<std::int64_t>(1, cycle_);
    result.soonest = cycles.first * unit;
    result.latest = {bounded ? 0U : 1U, charge * unit};
    turn.results.push_back(std::move(result));
  }
  turn.contradicted.assign(contradicted.begin(), contradicted.end());
  turn.dead = turn.results.empty() && turn.ends;
  return turn;
}

}  // namespace rmpl::reference
