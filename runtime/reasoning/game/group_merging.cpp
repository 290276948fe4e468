// Groups of a goal that have to do with each other, put together (semantics 5).
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/strategist.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "runtime/reasoning/game/sorted_sets.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

Strategist::Group Strategist::merged(const Group& a, const Group& b) {
  return {.parts = joined(a.parts, b.parts), .components = joined(a.components, b.components)};
}

void Strategist::merge_all(std::vector<Group>& groups) {
  while (groups.size() > 1) {
    groups.front() = merged(groups.front(), groups.back());
    groups.pop_back();
  }
}

/// Puts groups together whose parts of the goal read the same component.
void Strategist::merge_common(std::vector<Group>& groups) const {
  const auto common = [&](const Group& a, const Group& b) {
    return std::any_of(a.parts.begin(), a.parts.end(), [&](std::size_t p) {
      return std::any_of(b.parts.begin(), b.parts.end(),
                         [&](std::size_t q) { return meet(goal_.read_by(p), goal_.read_by(q)); });
    });
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size();) {
      if (!common(groups[i], groups[j])) {
        ++j;
        continue;
      }
      groups[i] = merged(groups[i], groups[j]);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
}

/// Whether the strategy of one moves or commands what the other rests on, and the other would not do the same.
bool Strategist::touches(const Group& a, const Group& b) const {
  const bool apart = !meet(a.touched, b.reads()) && !meet(a.commanded, b.read_controls());
  return !apart && !agree(a, b);
}

/// Whether what the groups share depends on itself alone, and both strategies send it the same in each of its states:
/// then each comes to what it comes to by itself.
bool Strategist::agree(const Group& a, const Group& b) const {
  std::vector<ComponentId> shared;
  std::set_intersection(a.reads().begin(), a.reads().end(), b.reads().begin(), b.reads().end(),
                        std::back_inserter(shared));
  std::vector<std::size_t> controls;
  const auto &a_controls = a.read_controls(), &b_controls = b.read_controls();
  std::set_intersection(a_controls.begin(), a_controls.end(), b_controls.begin(), b_controls.end(),
                        std::back_inserter(controls));
  for (const ComponentId c : shared) {
    for (std::size_t m = 0; m < graph_.mode_count(c); ++m) {
      const auto& deciding = graph_.deciding(c, automata::ModeId(m));
      if (!deciding ||
          !std::includes(shared.begin(), shared.end(), deciding->components.begin(), deciding->components.end()) ||
          !std::includes(controls.begin(), controls.end(), deciding->controls.begin(), deciding->controls.end()))
        return false;
    }
  }
  std::map<Modes, std::vector<automata::ValueId>> sent;  // by modes of what is shared
  for (const Group* group : {&a, &b}) {
    const Game& game = group->game();
    for (const std::uint32_t n : group->nodes) {
      const std::uint32_t edge = group->edge(n);
      if (edge == GameDecision::no_edge) continue;
      Modes modes;
      for (const ComponentId c : shared) modes.push_back(game.position(n).modes[c.index()]);
      std::vector<automata::ValueId> values;
      values.reserve(controls.size());
      for (const std::size_t i : controls) values.push_back(game.arena().action(game.edges()[edge].action)[i]);
      if (sent.try_emplace(std::move(modes), values).first->second != values) return false;
    }
  }
  return true;
}

/// Puts the first two groups together of which one touches what is the other's. Whether there were such. Pairs that are
/// too large together are noted: they take turns.
bool Strategist::merge_touching(std::vector<Group>& groups, const Modes& modes, Apart& in_turn) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      if (!touches(groups[i], groups[j]) && !touches(groups[j], groups[i])) continue;
      if (in_turn.contains({groups[i].parts, groups[j].parts})) continue;
      Group both = merged(groups[i], groups[j]);
      if (!solve_group(both, modes)) {
        in_turn.emplace(groups[i].parts, groups[j].parts);
        continue;
      }
      groups[i] = std::move(both);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

/// Puts the first two groups together of which one cannot keep what it reaches, if together they are as surely had as
/// apart, and no more is lost or neither lasts. Whether there were such. Pairs that are better apart are noted.
bool Strategist::merge_passing(std::vector<Group>& groups, const Modes& modes, Apart& apart) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      const GameDecision& one = groups[i].solved->decision();
      const GameDecision& other = groups[j].solved->decision();
      if (groups[i].ages && groups[j].ages) continue;
      if ((one.lasts && other.lasts) || apart.contains({groups[i].parts, groups[j].parts})) continue;
      Group both = merged(groups[i], groups[j]);
      const bool solved = solve_group(both, modes);
      const GameDecision* together = solved ? &both.solved->decision() : nullptr;
      // Where they have no plan together, nothing is done for some of them. Where neither lasts they would be had in
      // turn for ever, so that what is surely had together is had so.
      const auto better_apart = [&] {
        if (together->rank == Rank::none) return false;
        const bool in_turn = !one.lasts && !other.lasts && together->rank == Rank::sure;
        return together->rank > std::max(one.rank, other.rank) ||
               (!in_turn && together->cost.lost > one.cost.lost + other.cost.lost);
      };
      if (!solved || better_apart()) {
        apart.emplace(groups[i].parts, groups[j].parts);
        continue;
      }
      groups[i] = std::move(both);
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
      return true;
    }
  }
  return false;
}

/// How surely groups that are better apart have the goal together, in `answer`. That is worse than each by itself: what
/// one has may be lost before the other has its own. Groups that cannot be solved together are hoped for. Where they
/// have no plan together, they are one group in the end: then nothing is done for some of them.
bool Strategist::judge_together(std::vector<Group>& groups, const Modes& modes, const Apart& apart, Answer& answer) {
  std::vector<bool> judged(groups.size(), false);
  const auto are_apart = [&](std::size_t i, std::size_t j) {
    return apart.contains({groups[i].parts, groups[j].parts}) || apart.contains({groups[j].parts, groups[i].parts});
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (judged[i]) continue;
    std::vector<std::size_t> together{i};
    judged[i] = true;
    for (std::size_t at = 0; at < together.size(); ++at) {
      for (std::size_t j = 0; j < groups.size(); ++j) {
        if (judged[j] || !are_apart(together[at], j)) continue;
        judged[j] = true;
        together.push_back(j);
      }
    }
    if (together.size() < 2) continue;
    Group all = groups[i];
    for (std::size_t at = 1; at < together.size(); ++at) all = merged(all, groups[together[at]]);
    if (!solve_group(all, modes)) {
      answer.rank = std::max(answer.rank, Rank::hoped);
      answer.lasts = answer.best = false;
      continue;
    }
    const GameDecision& decision = all.solved->decision();
    answer.rank = std::max(answer.rank, decision.rank);
    answer.lasts = answer.lasts && decision.lasts;
    if (decision.rank != Rank::none) continue;
    groups = {std::move(all)};
    return false;
  }
  return true;
}

/// Sorts the groups by their turns, and tells those that have to wait for it.
void Strategist::set_turns(std::vector<Group>& groups, const Apart& in_turn) {
  std::vector<Group> ordered;
  for (const bool lasts : {true, false}) {
    for (Group& group : groups) {
      if (group.solved && group.solved->decision().lasts == lasts) ordered.push_back(std::exchange(group, {}));
    }
  }
  groups = std::move(ordered);
  for (std::size_t j = 0; j < groups.size(); ++j) {
    if (groups[j].solved->decision().purpose == GameDecision::Purpose::keep) continue;
    for (std::size_t i = 0; i < j && !groups[j].later; ++i) {
      const bool both =
          in_turn.contains({groups[i].parts, groups[j].parts}) || in_turn.contains({groups[j].parts, groups[i].parts});
      groups[j].later = both && groups[i].solved->decision().purpose != GameDecision::Purpose::keep;
    }
  }
}

}  // namespace rmpl::runtime
