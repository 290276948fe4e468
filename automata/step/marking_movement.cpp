// Effects are united; what all ways of a draw have in common is certain; draws that touch each other form a part.
// SPDX-License-Identifier: MIT
#include "automata/step/marking_movement.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/partition.hpp"

namespace rmpl::automata {
namespace {

constexpr std::size_t most_outcomes = std::size_t{1} << 16;

bool contains(const Marking& sorted, LocationId location) {
  return std::binary_search(sorted.begin(), sorted.end(), location);
}

void insert(Marking& sorted, LocationId location) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), location);
  if (place == sorted.end() || *place != location) sorted.insert(place, location);
}

Marking common(const Marking& a, const Marking& b) {
  Marking result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

MarkingMovement::MarkingMovement(const MarkingRules& rules, MarkingRules::Holds holds)
    : rules_(rules), holds_(holds), known_(rules.conditions_.size(), -1), matters_(rules.arcs_.size(), -1) {}

void MarkingMovement::unite(Marking& into, const Marking& other) {
  if (other.empty()) return;
  Marking both;
  both.reserve(into.size() + other.size());
  std::set_union(into.begin(), into.end(), other.begin(), other.end(), std::back_inserter(both));
  into.swap(both);
}

Marking MarkingMovement::without(const Marking& from, const Marking& other) {
  Marking result;
  std::set_difference(from.begin(), from.end(), other.begin(), other.end(), std::back_inserter(result));
  return result;
}

void MarkingMovement::unite(Effect& into, const Effect& other) {
  unite(into.marked, other.marked);
  unite(into.kept, other.kept);
  unite(into.active, other.active);
}

void MarkingMovement::add(Ways& ways, Effect effect, Chance chance) {
  const auto [known, fresh] = ways.try_emplace(std::move(effect), chance);
  if (fresh) return;
  known->second.probability += chance.probability;
  known->second.improbable = std::min(known->second.improbable, chance.improbable);
}

bool MarkingMovement::holds(std::size_t condition) {
  signed char& known = known_[condition];
  if (known < 0) known = holds_(condition) ? 1 : 0;
  return known == 1;
}

bool MarkingMovement::hold(const std::vector<std::size_t>& guard) {
  return std::all_of(guard.begin(), guard.end(), [&](std::size_t condition) { return holds(condition); });
}

bool MarkingMovement::left(LocationId location) {
  const Marking& holders = rules_.holders_[location.index()];
  return std::any_of(holders.begin(), holders.end(), [&](LocationId holder) {
    const auto& maintenance = rules_.maintenance_[holder.index()];
    return maintenance && !holds(*maintenance);
  });
}

bool MarkingMovement::matters(LocationId composite) {
  signed char& known = matters_[composite.index()];
  if (known < 0) {
    const auto& arcs = rules_.arcs_[composite.index()];
    const auto taken = [&](const RuledArc& arc) { return hold(arc.guard); };
    known = !left(composite) && std::any_of(arcs.begin(), arcs.end(), taken) ? 1 : 0;
  }
  return known == 1;
}

void MarkingMovement::take(const RuledArc& arc, Effect& effect) {
  unite(effect.marked, rules_.started_[arc.target.index()]);
  const Marking& around = rules_.holders_[arc.target.index()];
  for (const LocationId holder : rules_.holders_[arc.source.index()]) {
    const bool into = holder == arc.target || std::find(around.begin(), around.end(), holder) != around.end();
    if (into && matters(holder)) insert(effect.kept, holder);
  }
}

void MarkingMovement::add_arcs(const std::vector<RuledArc>& arcs, Effect& effect) {
  for (const RuledArc& arc : arcs) {
    if (hold(arc.guard)) take(arc, effect);
  }
}

void MarkingMovement::activate(LocationId location, Effect& effect) {
  for (const LocationId holder : rules_.holders_[location.index()]) {
    if (matters(holder)) insert(effect.active, holder);
  }
}

MarkingMovement::Effect MarkingMovement::ending(LocationId composite) {
  Effect effect;
  add_arcs(rules_.arcs_[composite.index()], effect);
  return effect;
}

void MarkingMovement::add_draw(Ways ways) {
  if (ways.size() == 1) {
    unite(certain_, ways.begin()->first);
  } else if (!ways.empty()) {
    draws_.push_back(std::move(ways));
  }
}

void MarkingMovement::start() {
  if (rules_.program_.locations.empty()) return;
  certain_.marked = rules_.started_.front();
  for (const InitialDraw& draw : rules_.program_.initial) {
    Ways ways;
    for (const InitialBranch& branch : draw.branches) {
      Effect effect;
      for (const LocationId l : branch.started) unite(effect.marked, rules_.started_[l.index()]);
      if (!(branch.probability > 0)) continue;
      add(ways, std::move(effect), {branch.probability, is_improbable(branch, draw.branches) ? 1u : 0u});
    }
    add_draw(std::move(ways));
  }
}

void MarkingMovement::leave(LocationId location) {
  activate(location, certain_);
  if (left(location)) return;
  Ways ways;
  for (const auto& function : rules_.functions_[location.index()]) {
    if (!(function.probability > 0)) continue;
    Effect effect;
    add_arcs(function.arcs, effect);
    for (const LocationId started : function.started) {
      activate(started, effect);
      if (!left(started)) add_arcs(rules_.functions_[started.index()].front().arcs, effect);
    }
    add(ways, std::move(effect), {function.probability, function.improbable ? 1u : 0u});
  }
  add_draw(std::move(ways));
}

/// What all ways have in common is certain, and what is certain anyway makes no difference between them.
void MarkingMovement::settle_common(Ways& ways) {
  Effect shared = ways.begin()->first;
  for (const auto& [effect, chance] : ways) {
    shared.marked = common(shared.marked, effect.marked);
    shared.kept = common(shared.kept, effect.kept);
    shared.active = common(shared.active, effect.active);
  }
  unite(certain_, shared);
}

/// From the inside out: composites that end, or go on, whatever is drawn; and those for which that is open.
void MarkingMovement::settle_composites() {
  Marking candidates = certain_.active;
  for (const Ways& ways : draws_) {
    for (const auto& [effect, chance] : ways) unite(candidates, effect.active);
  }
  for (auto c = candidates.rbegin(); c != candidates.rend(); ++c) {
    if (contains(certain_.kept, *c)) continue;
    const auto touches = [&](const auto& way) {
      return contains(way.first.kept, *c) || (contains(way.first.active, *c) && !contains(certain_.active, *c));
    };
    const bool open =
        std::any_of(draws_.begin(), draws_.end(),
                    [&](const Ways& ways) { return std::any_of(ways.begin(), ways.end(), touches); }) ||
        std::any_of(endings_.begin(), endings_.end(), [&](const Effect& effect) { return contains(effect.kept, *c); });
    if (open) {
      undecided_.push_back(*c);
      endings_.push_back(ending(*c));
    } else {
      unite(certain_, ending(*c));
    }
  }
}

/// Draws and undecided composites that may mark the same, or on which the same composite's end depends.
void MarkingMovement::join_overlapping() {
  base::Partition partition(draws_.size() + undecided_.size());
  std::map<LocationId, std::size_t> marks;
  const auto mark = [&](const Marking& marked, std::size_t member) {
    for (const LocationId l : marked) {
      if (!contains(certain_.marked, l)) partition.join(member, marks.try_emplace(l, member).first->second);
    }
  };
  const auto depend = [&](const Effect& effect, std::size_t member) {
    for (std::size_t u = 0; u < undecided_.size(); ++u) {
      if (contains(effect.kept, undecided_[u]) || contains(effect.active, undecided_[u])) {
        partition.join(member, draws_.size() + u);
      }
    }
  };
  for (std::size_t d = 0; d < draws_.size(); ++d) {
    for (const auto& [effect, chance] : draws_[d]) {
      mark(effect.marked, d);
      depend(effect, d);
    }
  }
  for (std::size_t u = 0; u < undecided_.size(); ++u) {
    mark(endings_[u].marked, draws_.size() + u);
    depend(endings_[u], draws_.size() + u);
  }
  for (std::size_t m = 0; m < draws_.size() + undecided_.size(); ++m) part_.push_back(partition.root(m));
}

std::vector<MarkingOutcome> MarkingMovement::turn_out(const std::vector<std::size_t>& draws,
                                                      const Marking& composites) {
  Ways all{{Effect{}, {1.0, 0}}};
  for (const std::size_t d : draws) {
    Ways longer;
    for (const auto& [before, p] : all) {
      for (const auto& [effect, q] : draws_[d]) {
        Effect both = before;
        unite(both, effect);
        both.marked = without(both.marked, certain_.marked);
        add(longer, std::move(both), {p.probability * q.probability, p.improbable + q.improbable});
      }
    }
    all = std::move(longer);
    if (all.size() > most_outcomes) {
      throw TooManyOutcomes("draws of " + std::to_string(draws.size()) +
                            " threads that have to do with each other may turn out in more than " +
                            std::to_string(most_outcomes) + " ways");
    }
  }
  std::map<Marking, Chance> outcomes;
  for (const auto& [way, chance] : all) {
    Effect effect = way;
    for (const LocationId composite : composites) {
      if (contains(effect.kept, composite)) continue;
      if (!contains(effect.active, composite) && !contains(certain_.active, composite)) continue;
      unite(effect, ending(composite));
    }
    const auto [known, fresh] = outcomes.try_emplace(without(effect.marked, certain_.marked), chance);
    if (fresh) continue;
    known->second.probability += chance.probability;
    known->second.improbable = std::min(known->second.improbable, chance.improbable);
  }
  std::vector<MarkingOutcome> result;
  for (const auto& [marked, chance] : outcomes) result.push_back({chance.probability, marked, chance.improbable});
  return result;
}

MarkingMoves MarkingMovement::moves() {
  for (Ways& ways : draws_) settle_common(ways);
  settle_composites();
  join_overlapping();
  std::map<std::size_t, std::pair<std::vector<std::size_t>, Marking>> parts;
  for (std::size_t d = 0; d < draws_.size(); ++d) parts[part_[d]].first.push_back(d);
  for (std::size_t u = 0; u < undecided_.size(); ++u) parts[part_[draws_.size() + u]].second.push_back(undecided_[u]);
  MarkingMoves result;
  result.certain = certain_.marked;
  for (const auto& [root, members] : parts) {
    auto outcomes = turn_out(members.first, members.second);
    if (outcomes.size() == 1) {
      unite(result.certain, outcomes.front().marked);
    } else {
      result.parts.push_back(std::move(outcomes));
    }
  }
  return result;
}

}  // namespace rmpl::automata
