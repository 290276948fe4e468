// The game as a graph. SPDX-License-Identifier: MIT
#include "tests/reference/game_board.hpp"

#include <algorithm>
#include <tuple>

namespace rmpl::reference {

using automata::ModeId;
using automata::Modes;

namespace {

/// Whether the goal reads a component: its mode, or an attribute that is named after it.
std::vector<bool> components_read(const automata::Plant& plant, const automata::Formula& goal) {
  std::vector<bool> result;
  const auto variables = automata::variables_of(goal);
  for (const automata::Component& component : plant.components) {
    result.push_back(std::any_of(variables.begin(), variables.end(), [&](automata::VariableId v) {
      return v == component.mode || plant.variables.name(v).starts_with(component.name + ".");
    }));
  }
  return result;
}

bool includes(const Harms& all, const Harms& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

}  // namespace

Board::Board(Arena& arena, const automata::Formula& goal, const std::set<std::size_t>& progress, std::size_t most_nodes)
    : arena_(arena),
      goal_(automata::conjuncts_of(goal)),
      irreversible_(arena.step(), goal, progress),
      read_(components_read(arena.step().plant(), goal)),
      most_nodes_(most_nodes) {}

const std::vector<bool>& Board::parts(Node node) {
  const auto [at, fresh] = parts_.try_emplace(arena_.modes(node));
  if (fresh)
    for (const automata::Formula& part : goal_) at->second.push_back(step().entails(arena_.modes(node), part));
  return at->second;
}

bool Board::holds(Node node) {
  const auto& parts = this->parts(node);
  return std::all_of(parts.begin(), parts.end(), [](bool part) { return part; });
}

double Board::reward(Node node, std::size_t component) const {
  return step().plant().components[component].modes[arena_.modes(node)[component].index()].reward;
}

const std::optional<Turn>& Board::turn(Node node, GameStep::Action action) {
  const auto at = turns_.find({node, action});
  if (at != turns_.end()) return at->second;
  return turns_.emplace(std::pair{node, action}, arena_.turn(node, action)).first->second;
}

std::optional<GameStep::Action> Board::rest(Node node) {
  const auto [at, fresh] = rest_.try_emplace(node);
  if (!fresh) return at->second;
  std::optional<GameStep::Action>& best = at->second;
  if (turn(node, step().idle())) {
    best = step().idle();
    return best;
  }
  const Modes modes = arena_.modes(node);
  const auto leavers = [&](GameStep::Action a) {
    const std::vector<Freedom>& freedom = *step().freedom(modes, a);
    std::size_t result = 0;
    for (std::size_t c = 0; c < modes.size(); ++c) result += freedom[c].leaves_at_once(modes[c]) ? 1 : 0;
    return result;
  };
  const auto cost = [&](GameStep::Action a) { return std::tuple(step().off_idle(a), leavers(a), a); };
  for (GameStep::Action a = 0; a < step().actions().size(); ++a)
    if (turn(node, a) && (!best || cost(a) < cost(*best))) best = a;
  return best;
}

/// What the outcomes of one action take or contradict.
Harms Board::harms_of(Node node, const Turn& turn) {
  Harms result;
  for (const Nogood& modes : turn.contradicted) result.insert({modes, std::nullopt});
  const Modes& from = arena_.modes(node);
  for (const Result& r : turn.results) {
    const Modes& to = arena_.modes(r.to);
    for (std::size_t c = 0; c < from.size(); ++c)
      if (irreversible_.is_irreversible(c, from[c], to[c]) && !irreversible_.is_licensed(c, to[c]))
        result.insert({{{c, from[c]}}, to[c]});
  }
  return result;
}

const Harms& Board::harms(Node node) {
  const auto at = harms_.find(node);
  if (at != harms_.end()) return at->second;
  Harms result;
  std::set<Node> seen{node};
  std::vector<Node> open{node};
  while (!open.empty()) {
    const Node from = open.back();
    open.pop_back();
    const auto action = rest(from);
    if (!action) continue;
    const Turn& idle = *turn(from, *action);
    result.merge(harms_of(from, idle));
    for (const Result& r : idle.results)
      if (seen.insert(r.to).second) open.push_back(r.to);
    if (seen.size() > most_nodes_) throw GameTooLarge();
  }
  return harms_.emplace(node, std::move(result)).first->second;
}

std::vector<GameStep::Action> Board::different_actions(Node node) {
  std::vector<GameStep::Action> result;
  const Modes modes = arena_.modes(node);
  for (GameStep::Action a = 0; a < step().actions().size(); ++a) {
    const auto& freedom = step().freedom(modes, a);
    if (!freedom) continue;
    const auto same = std::find_if(result.begin(), result.end(),
                                   [&](GameStep::Action other) { return step().freedom(modes, other) == freedom; });
    if (same == result.end())
      result.push_back(a);
    else if (step().off_idle(a) < step().off_idle(*same))
      *same = a;
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool Board::permits(Node node, const Turn& turn) {
  const Harms& anyway = harms(node);
  return includes(anyway, harms_of(node, turn)) &&
         std::all_of(turn.results.begin(), turn.results.end(),
                     [&](const Result& r) { return includes(anyway, harms(r.to)); });
}

std::vector<Commands> Board::commands_of(Node node, GameStep::Action action) {
  std::vector<Commands> all;
  const Modes modes = arena_.modes(node);
  const auto& actions = step().actions();
  const auto rest = this->rest(node);
  const auto& own = step().freedom(modes, action);
  for (GameStep::Action a = 0; a < actions.size(); ++a) {
    if (step().freedom(modes, a) != own) continue;
    Commands& commands = all.emplace_back();
    for (std::size_t i = 0; i < actions[a].size(); ++i)
      if (actions[a][i] != actions[*rest][i]) commands.emplace(i, actions[a][i]);
  }
  std::vector<Commands> least;
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.size() < y.size(); });
  for (const Commands& commands : all)
    if (std::none_of(least.begin(), least.end(), [&](const Commands& fewer) {
          return std::includes(commands.begin(), commands.end(), fewer.begin(), fewer.end());
        }))
      least.push_back(commands);
  return least;
}

Option Board::option(Node node, GameStep::Action action, const Turn& turn) {
  Option option{action, turn.waits, turn.ends, turn.at_once, {}, {}};
  option.commands = commands_of(node, action);
  std::map<std::vector<std::pair<std::size_t, std::uint32_t>>, std::size_t> choices;
  for (const Result& r : turn.results) {
    const Modes& from = arena_.modes(node);
    const Modes& to = arena_.modes(r.to);
    GameCost cost;
    cost.time = r.latest;
    cost.commands = step().off_idle(action);
    cost.waits = cost.commands == 0 ? 1 : 0;
    cost.moves = turn.waits && cost.commands == 0 ? 0 : 1;
    bool irreversible = false;
    for (std::size_t c = 0; c < from.size(); ++c) {
      cost.disturbed += from[c] != to[c] && !reads(c) ? 1 : 0;
      const bool taken = irreversible_.is_irreversible(c, from[c], to[c]);
      cost.irreversible += taken && irreversible_.is_licensed(c, to[c]) ? 1 : 0;
      irreversible = irreversible || taken;
    }
    const std::vector<bool> before = parts(node);
    const std::vector<bool>& after = parts(r.to);
    for (std::size_t i = 0; i < before.size(); ++i) cost.lost += before[i] && !after[i] ? 1 : 0;
    option.ways.push_back({r.to, cost, r.soonest, choices.try_emplace(r.chosen, choices.size()).first->second,
                           irreversible, !turn.waits && !r.chosen.empty()});
  }
  return option;
}

void Board::explore(Node start) {
  std::vector<Node> open{start};
  std::set<Node> met{start};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (options_.contains(node)) continue;
    std::vector<Option> permitted;
    for (const GameStep::Action a : different_actions(node)) {
      const std::optional<Turn>& t = turn(node, a);
      if (!t || t->dead || !permits(node, *t)) continue;
      permitted.push_back(option(node, a, *t));
      for (const Result& r : t->results)
        if (met.insert(r.to).second) open.push_back(r.to);
    }
    options_.emplace(node, std::move(permitted));
    if (options_.size() > most_nodes_) throw GameTooLarge();
  }
}

}  // namespace rmpl::reference
