// Groups of a goal: solved apart for as long as their strategies do not touch each other.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/strategist.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "automata/store/totality.hpp"
#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/nominal/closures.hpp"
#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;

namespace {

constexpr std::size_t most_game_nodes = std::size_t{1} << 14;
constexpr std::size_t few_outcomes = std::size_t{1} << 13;        // beyond it only useful actions are looked at
constexpr std::size_t most_game_outcomes = std::size_t{1} << 21;  // solved in about two seconds, in 500 MiB
constexpr std::size_t many_outcomes = std::size_t{1} << 16;       // beyond it a game is large
constexpr std::size_t most_remembered = 3 * most_game_outcomes;   // beyond it large games are forgotten
constexpr std::size_t most_combinations = std::size_t{1} << 16;   // of modes; beyond it no game is begun
constexpr std::size_t games_remembered = 16;                      // of one group, in different contexts
constexpr std::size_t solutions_remembered = 64;                  // of one game

/// Components that leave their mode on some run on which the executive rests.
std::vector<ComponentId> moved_at_rest(const Game& game, std::uint32_t start) {
  std::vector<ComponentId> moved;
  std::vector<bool> seen(game.nodes().size());
  std::vector<std::uint32_t> open{start};
  seen[start] = true;
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const Game::Node& node = game.nodes()[n];
    if (node.count == 0) continue;
    const Game::Edge& rest = game.edges()[node.first];
    for (std::uint32_t o = rest.first; o < rest.first + rest.count; ++o) {
      const std::uint32_t then = game.outcomes()[o].node;
      for (const ComponentId c : game.arena().components()) {
        if (game.position(then).modes[c.index()] != game.position(n).modes[c.index()]) insert(moved, c);
      }
      if (!seen[then]) {
        seen[then] = true;
        open.push_back(then);
      }
    }
  }
  return moved;
}

}  // namespace

Strategist::Strategist(automata::PlantStep& step, const NominalGraph& graph, const automata::Formula& goal,
                       std::optional<automata::Ticks> cycle, Relevant relevant)
    : step_(step),
      graph_(graph),
      cycle_(cycle),
      counts_ages_(cycle.has_value()),
      holds_(relevant == Relevant::read),
      goal_(goal, step, graph),
      goal_text_(to_text(goal, step.plant().variables)),
      excludes_(step.locality().islands().size()) {
  for (std::size_t p = 0; p < goal_.parts(); ++p) {
    auto components = relevant == Relevant::read ? goal_.read_by(p) : graph.upstream(goal_.read_by(p));
    std::sort(components.begin(), components.end());
    relevant_.push_back(std::move(components));
  }
}

/// Whether the components outside are in the modes that the arena rests on.
bool Strategist::in_context(const Arena& arena, const Modes& modes) {
  const auto& context = arena.context();
  return std::all_of(context.begin(), context.end(),
                     [&](ComponentId c) { return arena.start_modes()[c.index()] == modes[c.index()]; });
}

/// Forgets the large games of all groups where they have become many.
void Strategist::forget_large() {
  std::size_t outcomes = 0;
  for (const auto& [key, games] : games_) {
    for (const Played& played : games) outcomes += played.game->outcomes().size();
  }
  if (outcomes <= most_remembered) return;
  for (auto& [key, games] : games_) {
    std::erase_if(games, [](const Played& played) { return played.game->outcomes().size() > many_outcomes; });
  }
}

Strategist::Played& Strategist::game_of(const Group& group, const Modes& modes) {
  auto& games = games_[{group.parts, group.components}];
  for (Played& played : games) {
    if (in_context(*played.arena, modes) && (played.game->too_large() || played.game->find(modes))) return played;
  }
  if (games.size() >= games_remembered) games.erase(games.begin());
  forget_large();
  Played& played = games.emplace_back();
  for (const bool best : {true, false}) {
    played.arena = std::make_shared<Arena>(step_, graph_, goal_, group.parts, group.components, modes,
                                           [this](std::size_t island) { return excludes(island); });
    if (!best) played.arena->restrict_to_useful();
    const Game::Limits limits{most_game_nodes, best ? few_outcomes : most_game_outcomes};
    played.game =
        kept_with(played.arena, new Game(*played.arena, Game::Memory::modes, automata::Ticks{0}, limits, modes));
    played.best = best;
    if (!played.game->too_large()) break;
  }
  return played;
}

SolvedGame Strategist::solved(Played& played, std::uint32_t start, const std::vector<std::size_t>& parts) {
  auto& known = played.solutions;
  const bool one = !known.empty() && known.begin()->second->is_of_all_nodes();
  if (!one && known.size() >= solutions_remembered) known.clear();
  auto& solution = one ? known.begin()->second : known[start];
  if (!solution) solution = std::make_shared<const Solution>(*played.game, start);
  return {played.game, solution, start, parts, played.best};
}

/// A game that is told keeps its arena.
std::shared_ptr<const Game> Strategist::kept_with(std::shared_ptr<Arena> arena, const Game* game) {
  return {game, [arena = std::move(arena)](const Game* told) { delete told; }};
}

/// Whether a game is begun at all.
bool Strategist::is_small(const Group& group, const Modes& modes) const {
  std::size_t combinations = 1;
  for (const ComponentId c : group.components) {
    std::size_t reached = 0;
    for (std::size_t m = 0; m < graph_.mode_count(c); ++m)
      reached += graph_.leads(c, modes[c.index()], automata::ModeId(m)) ? 1 : 0;
    combinations *= reached;
    if (combinations > most_combinations) return false;
  }
  return true;
}

/// Whether the group is small enough; then it is solved, with all that its strategy disturbs. Where that is too much to
/// solve, the strategy stands without what it disturbs, if no harm can come of that; it is not proved best then.
bool Strategist::solve_group(Group& group, const Modes& modes) {
  std::optional<Group> smaller;   // solved, without what it disturbs
  std::vector<ComponentId> more;  // what it disturbs
  for (;;) {
    Played* const played = is_small(group, modes) ? &game_of(group, modes) : nullptr;
    if (played == nullptr || played->game->too_large()) {
      if (!smaller || !(holds_ ? harmless_held(*smaller, modes) : harmless(more))) return false;
      group = *std::move(smaller);
      group.solved->best = false;
      return true;
    }
    group.solved = solved(*played, *played->game->find(modes), group.parts);
    if (counts_ages_) count_ages(group, *played, modes);
    more = follow(group, modes);
    // Where it could be better, what the model may exclude beside the group may have to give way.
    const GameDecision& decision = group.solved->decision();
    if (decision.rank != Rank::sure || !decision.lasts)
      more = joined(more, neighbours(group.components, group.game().arena().controls()));
    if (more.empty()) return true;
    smaller = group;
    group.components = joined(group.components, more);
  }
}

/// Whether these components, and all that may move because they do, can take no step that the goal would have to
/// license, and the model excludes none of their modes: what they do then is lost at worst, not ruined.
bool Strategist::harmless(std::vector<ComponentId> components) {
  std::vector<bool> seen(step_.plant().components.size());
  while (!components.empty()) {
    const ComponentId c = components.back();
    components.pop_back();
    if (seen[c.index()]) continue;
    seen[c.index()] = true;
    const auto& transitions = graph_.transitions(c);
    const bool safe = std::all_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
      return NominalGraph::harmless(t) || goal_.licenses(c, t.id);
    });
    if (!safe || !neighbours({c}, {}).empty()) return false;
    const auto& more = graph_.dependents(c);
    components.insert(components.end(), more.begin(), more.end());
  }
  return true;
}

/// Whether nothing comes of the group's strategy, others being held until then, that its goal would have to license and
/// that could not come at rest: no step that cannot be undone, of a component outside, neither with a command of the
/// strategy nor by itself afterwards. Each component is looked at by itself, so that no such step is overlooked.
bool Strategist::harmless_held(const Group& group, const Modes& modes) {
  const Game& game = group.game();
  Arena& arena = game.arena();
  const auto harms = [&](ComponentId c, const NominalTransition& t) {
    return t.irreversible && !goal_.licenses(c, t.id) &&
           !std::binary_search(group.components.begin(), group.components.end(), c);
  };
  Reached at_rest = only(graph_, modes);
  spread_at_rest(graph_, at_rest);
  Reached reached = at_rest;
  Modes joint = modes;
  const std::vector<ComponentId> readers = arena.readers(modes);
  for (const std::uint32_t n : group.nodes) {
    const std::uint32_t edge = group.edge(n);
    for (const ComponentId c : arena.components()) {
      joint[c.index()] = game.position(n).modes[c.index()];
      reached[c.index()][joint[c.index()].index()] = true;
    }
    if (edge == GameDecision::no_edge) continue;
    const ControlAction& action = arena.action(game.edges()[edge].action);
    for (const ComponentId c : readers) {
      for (const LocalMoves::Exit& exit : arena.moves_of(c, joint, action).exits) {
        const NominalTransition* const t = graph_.find(c, exit.transition);
        if (t != nullptr && harms(c, *t) && !comes_by_itself(graph_, c, *t, at_rest)) return false;
        reached[c.index()][exit.to.index()] = true;
      }
    }
  }
  spread_at_rest(graph_, reached);
  for (const ComponentId c : graph_.components()) {
    for (const NominalTransition& t : graph_.transitions(c)) {
      if (harms(c, t) && comes_by_itself(graph_, c, t, reached) && !comes_by_itself(graph_, c, t, at_rest))
        return false;
    }
  }
  return true;
}

/// Whether some outcome takes the member from its mode.
bool Strategist::leaves(const Game& game, const Game::Edge& edge, std::uint32_t node, std::size_t member) {
  const std::size_t c = game.arena().components()[member].index();
  for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
    if (game.position(game.outcomes()[o].node).modes[c] != game.position(node).modes[c]) return true;
  }
  return false;
}

/// Notes what the strategy moves and commands. Returns the components outside that may do on its runs what they may not
/// do if the executive rests where it is, or whose modes the model may exclude together with what it moves.
std::vector<ComponentId> Strategist::follow(Group& group, const Modes& modes) {
  const Game& game = group.game();
  Arena& arena = game.arena();
  group.touched.clear();
  group.commanded.clear();
  group.nodes.clear();
  std::vector<ComponentId> disturbed, part;
  Modes joint = modes;
  const ControlAction rest = resting_action(step_, modes);
  const std::vector<ComponentId> natural = moved_at_rest(game, group.start());
  std::vector<LocalMoves> undisturbed;
  const std::vector<ComponentId> readers = arena.readers(modes);
  undisturbed.reserve(readers.size());
  for (const ComponentId c : readers) undisturbed.push_back(arena.moves_of(c, modes, rest));
  std::vector<bool> seen(game.nodes().size());
  std::vector<std::uint32_t> open{group.start()};
  seen[group.start()] = true;
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    group.nodes.push_back(n);
    const std::uint32_t chosen = group.edge(n);
    if (chosen == GameDecision::no_edge) continue;
    const Game::Edge& edge = game.edges()[chosen];
    const Position& position = game.position(n);
    const ControlAction& action = arena.action(edge.action);
    const ControlAction& idle = arena.action(game.edges()[game.nodes()[n].first].action);
    for (const std::size_t i : arena.controls()) {
      if (action[i] != idle[i]) insert(group.commanded, i);
    }
    const Position::Action* with = position.find(edge.action);
    const Position::Action& without = position.actions.front();
    for (std::size_t m = 0; m < arena.components().size(); ++m) {
      const bool commanded = with != nullptr && with->moves[m] != without.moves[m];
      if (commanded) insert(group.touched, arena.components()[m]);
      // What a first wait is for may come whatever else is done meanwhile: that is looked at apart.
      const bool goes_on = commanded || (n != group.start() && leaves(game, edge, n, m));
      if (goes_on)
        part = joined(part,
                      arena.deciding(arena.components()[m], position.modes[arena.components()[m].index()]).components);
    }
    // The game may have been begun where components outside were in other modes.
    for (const ComponentId c : arena.components()) joint[c.index()] = position.modes[c.index()];
    for (std::size_t r = 0; r < readers.size(); ++r) {
      if (arena.moves_of(readers[r], joint, action) != undisturbed[r]) insert(disturbed, readers[r]);
    }
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const std::uint32_t then = game.outcomes()[o].node;
      for (const ComponentId c : arena.components()) {
        if (game.position(then).modes[c.index()] == position.modes[c.index()]) continue;
        insert(part, c);
        if (!std::binary_search(natural.begin(), natural.end(), c)) insert(group.touched, c);
      }
      if (!seen[then]) {
        seen[then] = true;
        open.push_back(then);
      }
    }
  }
  if (group.solved) {
    group.solved->part = std::move(part);
    group.solved->commanded = group.commanded;
  }
  for (const ComponentId c : neighbours(group.touched, {})) {
    if (!std::binary_search(group.components.begin(), group.components.end(), c)) insert(disturbed, c);
  }
  return disturbed;
}

/// Components, not among these, whose modes the model may exclude together with theirs or with values of the controls,
/// and what decides these.
std::vector<ComponentId> Strategist::neighbours(const std::vector<ComponentId>& components,
                                                const std::vector<std::size_t>& controls) {
  std::vector<ComponentId> found;
  const auto& islands = step_.locality().islands();
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const auto& together = islands[i].support.components;
    const bool ours = meet(components, together) || meet(controls, islands[i].support.controls);
    if (ours && excludes(i)) found.insert(found.end(), together.begin(), together.end());
  }
  std::vector<ComponentId> result = graph_.upstream(found);
  std::sort(result.begin(), result.end());
  std::erase_if(result, [&](ComponentId c) { return std::binary_search(components.begin(), components.end(), c); });
  return result;
}

bool Strategist::excludes(std::size_t island) {
  auto& known = excludes_[island];
  if (!known) known = !automata::is_total(step_.plant(), step_.locality().islands()[island]);
  return *known;
}

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
  const bool apart = !meet(a.touched, b.components) && !meet(a.commanded, b.game().arena().controls());
  return !apart && !agree(a, b);
}

/// Whether what the groups share depends on itself alone, and both strategies send it the same in each of its states:
/// then each comes to what it comes to by itself.
bool Strategist::agree(const Group& a, const Group& b) const {
  std::vector<ComponentId> shared;
  std::set_intersection(a.components.begin(), a.components.end(), b.components.begin(), b.components.end(),
                        std::back_inserter(shared));
  std::vector<std::size_t> controls;
  const auto& a_controls = a.game().arena().controls();
  const auto& b_controls = b.game().arena().controls();
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

Strategist::Answer Strategist::from(const Modes& modes, const StrategyPosition& position) {
  counts_ages_ = cycle_.has_value();
  Answer answer = this->answer(modes, position);
  // What ages make of groups may be too large where groups over modes are not.
  if (answer.solved || !counts_ages_) return answer;
  counts_ages_ = false;
  answer = this->answer(modes, {});
  answer.bounds_counted = false;
  return answer;
}

Strategist::Answer Strategist::answer(const Modes& modes, const StrategyPosition& position) {
  Answer answer;
  Apart apart, in_turn;
  std::vector<Group> groups = first_groups(modes, position);
  const ControlAction rest = resting_action(step_, modes);
  for (;;) {
    for (Group& group : groups) {
      if (!group.solved && !solve_group(group, modes)) return answer;
      if (group.solved->decision().rank != Rank::none) continue;
      answer.solved = true;
      answer.rank = Rank::none;
      answer.lasts = false;
      answer.action = rest;
      answer.best = group.solved->best;
      answer.bounds_counted = group.solved->bounds_counted;
      answer.groups = {*std::move(group.solved)};
      return answer;
    }
    if (merge_touching(groups, modes, in_turn) || merge_passing(groups, modes, apart)) continue;
    answer = {};
    if (!apart.empty() && !judge_together(groups, modes, apart, answer)) continue;
    set_turns(groups, in_turn);
    answer.action = rest;
    for (const Group& group : groups) {
      const GameDecision& choice = group.solved->decision();
      if (choice.edge == GameDecision::no_edge || group.later) continue;
      const Game& game = *group.solved->game;
      const ControlAction& action = game.arena().action(game.edges()[choice.edge].action);
      for (const std::size_t i : game.arena().controls()) {
        if (action[i] != rest[i]) answer.action[i] = action[i];
      }
    }
    // Commands that the model excludes together are those of one group.
    if (groups.size() == 1 || step_.consistent(modes, answer.action)) break;
    merge_all(groups);
  }
  answer.solved = true;
  for (Group& group : groups) {
    answer.rank = std::max(answer.rank, group.solved->decision().rank);
    answer.lasts = answer.lasts && group.solved->decision().lasts;
    answer.best = answer.best && group.solved->best && in_turn.empty();
    answer.bounds_counted = answer.bounds_counted && group.solved->bounds_counted;
    (group.later ? answer.later : answer.groups).push_back(*std::move(group.solved));
  }
  return answer;
}

}  // namespace rmpl::runtime
