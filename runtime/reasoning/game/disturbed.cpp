// What the strategy of a group touches, and what it disturbs outside (semantics 5).
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/strategist.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/reasoning/game/sorted_sets.hpp"
#include "runtime/reasoning/nominal/closures.hpp"
#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;

namespace {

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

/// Components whose modes may let a component leave its mode while all controls are idle. Nothing where that is not
/// known.
std::optional<std::vector<ComponentId>> releasing(const NominalGraph& graph, ComponentId component,
                                                  automata::ModeId mode) {
  std::vector<ComponentId> found;
  for (const NominalTransition& t : graph.transitions(component)) {
    if (t.from != mode || t.to == mode || !t.possible) continue;
    if (!t.all_preconditions) return std::nullopt;
    for (std::size_t p = 0; p < t.preconditions.size(); ++p) {
      for (const Requirement& r : t.preconditions[p]) {
        const auto other = graph.component_of(r);
        if (t.silent[p] && other && *other != component) insert(found, *other);
      }
    }
  }
  return found;
}

}  // namespace

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
  std::vector<ComponentId> read;
  for (const std::size_t p : group.parts) read = joined(read, goal_.read_by(p));
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
    // Where the goal is kept, a component keeps it whose modes may let those leave that the goal reads.
    const bool kept =
        group.solved && n != group.start() && group.solved->solution->at(n).purpose != GameDecision::Purpose::reach;
    const Position::Action* with = position.find(edge.action);
    const Position::Action& without = position.actions.front();
    for (std::size_t m = 0; m < arena.components().size(); ++m) {
      const bool commanded = with != nullptr && with->moves[m] != without.moves[m];
      if (commanded) insert(group.touched, arena.components()[m]);
      // What a first wait is for may come whatever else is done meanwhile: that is looked at apart.
      const bool goes_on = commanded || (n != group.start() && leaves(game, edge, n, m));
      const ComponentId c = arena.components()[m];
      const automata::ModeId mode = position.modes[c.index()];
      if (goes_on) part = joined(part, arena.deciding(c, mode).components);
      if (kept && std::binary_search(read.begin(), read.end(), c)) {
        const auto all = releasing(graph_, c, mode);
        part = joined(part, all ? *all : arena.deciding(c, mode).components);
      }
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
  // What a least group leaves out keeps its modes: the game knows what these exclude.
  if (!group.least.empty()) return disturbed;
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
    if (ours && common_->excludes(i)) found.insert(found.end(), together.begin(), together.end());
  }
  std::vector<ComponentId> result = graph_.upstream(found);
  std::sort(result.begin(), result.end());
  std::erase_if(result, [&](ComponentId c) { return std::binary_search(components.begin(), components.end(), c); });
  return result;
}

}  // namespace rmpl::runtime
