// What may still come of a state.
// SPDX-License-Identifier: MIT
#include "verifier/markov/outlook.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::verifier {

using automata::LocationId;
using automata::Modes;

namespace {

/// The bounds of a step may be apart by so large a part of what the bounds of the answer may be apart.
constexpr Real part_of_precision = 0.125L;

}  // namespace

bool Outlook::set_reach(const Key& key, std::size_t part, Future& future) {
  const Commands commands = future.commanded[part] ? Commands::any : Commands::none;
  const PartMoves::Reach*& reach = future.reaches[part];
  reach = parts_[part]->reach(key.numbers[part], commands, meter_);
  const bool undecided = reach != nullptr && ends_ == std::vector<std::size_t>{part};
  future.open[part] = undecided ? parts_[part]->undecided(*reach, meter_) : reach;
  return future.open[part] != nullptr;
}

/// Adds what may come to be marked next; false where that is nothing more.
bool Outlook::grow(Future& future) {
  bool grown = false;
  const auto add = [&](LocationId location) {
    if (!future.locations[location.index()]) grown = true;
    future.locations[location.index()] = true;
  };
  for (std::size_t l = 0; l < locations_.size(); ++l) {
    if (!future.locations[l]) continue;
    const Location& own = locations_[l];
    if (!program_.locations[l].composite && program_.locations[l].has_goal()) {
      const bool awaits = !chances(own.maintenance, future).fails && !chances(own.goal, future).holds;
      if (awaits) continue;
    }
    for (std::size_t a = 0; a < own.guards.size(); ++a) {
      if (!chances(own.guards[a], future).holds) continue;
      for (const LocationId target : own.targets[a]) add(target);
    }
  }
  return grown;
}

/// `at_rest`: with all controls idle. Nothing where it is not known.
std::optional<Outlook::Future> Outlook::future(const Key& key, bool at_rest) {
  Future result{std::vector<bool>(locations_.size(), false), std::vector<bool>(parts_.size(), false),
                std::vector<const PartMoves::Reach*>(parts_.size(), nullptr),
                std::vector<const PartMoves::Reach*>(parts_.size(), nullptr)};
  for (const LocationId l : key.marking) result.locations[l.index()] = true;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (!set_reach(key, p, result)) return std::nullopt;
  }
  for (bool grown = true; grown;) {
    grown = grow(result);
    if (at_rest) continue;
    std::vector<bool> commanded = result.commanded;
    for (std::size_t l = 0; l < locations_.size(); ++l) {
      if (!result.locations[l]) continue;
      for (const std::size_t p : locations_[l].goal_parts) commanded[p] = true;
    }
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      commanded[p] = commanded[p] || parts_[p]->gains(*result.reaches[p], meter_);
      if (commanded[p] == result.commanded[p]) continue;
      grown = true;
      result.commanded[p] = true;
      if (!set_reach(key, p, result)) return std::nullopt;
    }
  }
  return result;
}

/// No composite around the location is left.
bool Outlook::stays_inside(std::size_t location, const Future& future) {
  for (auto parent = program_.locations[location].parent; parent; parent = program_.locations[parent->index()].parent) {
    if (chances(locations_[parent->index()].maintenance, future).fails) return false;
  }
  return true;
}

/// Whether some location that lasts follows for certain, if this one is marked.
bool Outlook::goes_on(std::size_t location, const std::vector<bool>& lasting, const Future& future) {
  const Location& own = locations_[location];
  if (!own.goal.empty() && !chances(own.maintenance, future).fails && !chances(own.goal, future).holds) return true;
  std::vector<std::size_t> arcs;
  for (std::size_t a = 0; a < own.guards.size(); ++a) {
    const bool lasts = std::any_of(own.targets[a].begin(), own.targets[a].end(), [&](LocationId target) {
      return lasting[target.index()] && !program_.locations[target.index()].composite;
    });
    if (lasts) arcs.push_back(a);
  }
  return std::any_of(arcs.begin(), arcs.end(), [&](std::size_t a) {
    const Condition& guard = own.guards[a];
    if (!chances(guard, future).fails) return true;
    return std::any_of(arcs.begin(), arcs.end(), [&](std::size_t b) {
      return own.guards[b].entailed != guard.entailed && *own.guards[b].formula == *guard.formula;
    });
  });
}

/// The locations from which on some location is marked for ever.
std::vector<bool> Outlook::lasting(const Future& future) {
  std::vector<bool> result(locations_.size(), false);
  for (std::size_t l = 0; l < locations_.size(); ++l) {
    result[l] = future.locations[l] && !program_.locations[l].composite && stays_inside(l, future);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t l = 0; l < locations_.size(); ++l) {
      if (!result[l] || goes_on(l, result, future)) continue;
      result[l] = false;
      changed = true;
    }
  }
  return result;
}

bool Outlook::goes_on_for_ever(const Key& key, const Future& future) {
  const std::vector<bool> lasting = this->lasting(future);
  return std::any_of(key.marking.begin(), key.marking.end(), [&](LocationId l) { return lasting[l.index()]; });
}

/// Whether with all controls idle a goal stays asserted that commands of any kind could not bring about either: then
/// they stay idle. Goals of which some are asked for by themselves may be left out one by one; they tell nothing here.
bool Outlook::lacks_a_plan_for_ever(const Key& key, const Future& at_rest) {
  const auto& locations = program_.locations;
  if (std::any_of(locations.begin(), locations.end(), [](const auto& location) { return location.apart; }))
    return false;
  Future commanded = at_rest;
  return std::any_of(key.marking.begin(), key.marking.end(), [&](LocationId l) {
    const Location& own = locations_[l.index()];
    if (own.goal.empty() || chances(own.maintenance, at_rest).fails || !stays_inside(l.index(), at_rest)) return false;
    return std::any_of(own.goal.begin(), own.goal.end(), [&](std::size_t c) {
      Conjunct& conjunct = conjuncts_[c];
      if (!conjunct.handle) return false;
      for (const std::size_t p : conjunct.parts) {
        commanded.open[p] = parts_[p]->reach_past_end(key.numbers[p], meter_);
        if (commanded.open[p] == nullptr) return false;
      }
      return !chances(conjunct, commanded).holds;
    });
  });
}

bool Outlook::is_end(const Key& key) const {
  return std::any_of(ends_.begin(), ends_.end(), [&](std::size_t p) { return parts_[p]->is_end(key.numbers[p]); });
}

/// Whether some conjunct of the target can hold no more.
bool Outlook::is_hopeless(Future future) {
  future.open = future.reaches;
  return std::any_of(target_.begin(), target_.end(), [&](std::size_t c) {
    const Chances chances = this->chances(conjuncts_[c], future);
    return question_.entailed ? !chances.holds : !chances.fails;
  });
}

std::optional<Enclosure> Outlook::hazard(const Future& future) const {
  if (ends_.empty()) return std::nullopt;
  Enclosure none = certain();  // of coming to no end
  Enclosure one;
  for (const std::size_t p : ends_) {
    const Enclosure own = parts_[p]->hazard(*future.reaches[p], future.commanded[p] ? Commands::any : Commands::none);
    none = none * outward({1 - own.upper, 1 - own.lower}, 1);
    one = own;
  }
  const Enclosure found = ends_.size() == 1 ? one : as_probability(outward({1 - none.upper, 1 - none.lower}, 1));
  if (!is_within(found, question_.precision * part_of_precision)) return std::nullopt;
  return found;
}

/// By component: whether it matters.
std::vector<bool> Outlook::matter(const Future& future) {
  std::vector<bool> result(base_.size(), false);
  const auto add = [&](const Cone& cone) {
    for (const automata::ComponentId c : cone) result[c.index()] = true;
  };
  const auto add_read = [&](const Asked& asked) {
    for (const std::size_t c : asked) {
      const Chances chances = this->chances(conjuncts_[c], future);
      if (chances.holds && chances.fails) add(conjuncts_[c].cone);
    }
  };
  for (const std::size_t c : target_) {
    for (const std::size_t p : conjuncts_[c].parts) add(parts_[p]->cone());
  }
  for (std::size_t l = 0; l < locations_.size(); ++l) {
    if (!future.locations[l]) continue;
    const Location& own = locations_[l];
    for (const std::size_t p : own.goal_parts) add(parts_[p]->cone());
    add_read(own.maintenance.asked);
    for (const Condition& guard : own.guards) add_read(guard.asked);
  }
  // Commands for reward may move those that matter, too.
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Cone& cone = parts_[p]->cone();
    const bool some = std::any_of(cone.begin(), cone.end(), [&](automata::ComponentId c) { return result[c.index()]; });
    if (some && future.commanded[p]) add(cone);
  }
  return result;
}

/// Modes of the part that are as good as those it is in, with those that matter kept.
std::optional<PartMoves::Number> Outlook::settled(const Key& key, std::size_t part, const std::vector<bool>& matters,
                                                  const Future& future) {
  PartMoves& moves = *parts_[part];
  const Modes& here = moves.modes(key.numbers[part]);
  std::vector<std::uint32_t> kept;  // a mode, or nobody's
  for (std::size_t i = 0; i < here.size(); ++i) {
    kept.push_back(matters[moves.cone()[i].index()] ? here[i].value : ~std::uint32_t{0});
  }
  auto [known, fresh] = settled_.try_emplace({part, future.reaches[part], future.commanded[part], kept});
  if (!fresh) return known->second;
  const Commands commands = future.commanded[part] ? Commands::any : Commands::none;
  const auto alike = [&](const Modes& modes) {
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const bool matters_here = kept[i] != ~std::uint32_t{0};
      if (matters_here ? modes[i].value != kept[i] : slices_.plant().has_timed_exit(moves.cone()[i], modes[i])) {
        return false;
      }
    }
    return true;
  };
  known->second = moves.most_settled(*future.reaches[part], commands, meter_, alike);
  return known->second;
}

void Outlook::find_idle(const Key& key, const Future& future, Told& told) {
  const std::vector<bool> matters = matter(future);
  if (std::find(matters.begin(), matters.end(), false) == matters.end()) return;
  told.modes = base_;
  told.idle.assign(base_.size(), false);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Cone& cone = parts_[p]->cone();
    const bool all = std::all_of(cone.begin(), cone.end(), [&](automata::ComponentId c) { return matters[c.index()]; });
    const auto settled = all ? std::nullopt : this->settled(key, p, matters, future);
    parts_[p]->assign(settled.value_or(key.numbers[p]), told.modes);
    for (const automata::ComponentId c : cone) told.idle[c.index()] = settled && !matters[c.index()];
  }
}

Outlook::Told Outlook::work_out(const Key& key) {
  if (is_end(key)) return {};
  if (const auto at_rest = future(key, true); at_rest && lacks_a_plan_for_ever(key, *at_rest)) {
    if (const auto found = hazard(*at_rest)) return {found, {}, {}};
  }
  const auto any = future(key, false);
  if (!any) return {};
  if (is_hopeless(*any)) return {Enclosure{}, {}, {}};
  if (const auto found = hazard(*any); found && goes_on_for_ever(key, *any)) return {found, {}, {}};
  Told result;
  find_idle(key, *any, result);
  return result;
}

const Outlook::Told& Outlook::tell(const automata::Marking& marking, const Modes& modes) {
  if (!known_ || marking.empty()) return nothing_;
  Key key{marking, {}};
  key.numbers.reserve(parts_.size());
  for (const auto& part : parts_) key.numbers.push_back(part->number(modes));
  const auto known = worked_out_.find(key);
  if (known != worked_out_.end()) return known->second;
  Told found = work_out(key);
  return worked_out_.emplace(std::move(key), std::move(found)).first->second;
}

}  // namespace rmpl::verifier
