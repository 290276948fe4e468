// The executive's choices, by fixpoints over all nodes. SPDX-License-Identifier: MIT
#include "tests/reference/executive.hpp"

#include <algorithm>

namespace rmpl::reference {

namespace {

bool all_in(const std::vector<Result>& results, const std::set<Node>& nodes) {
  return std::all_of(results.begin(), results.end(), [&](const Result& r) { return nodes.contains(r.to); });
}

/// The controls that formulas connect with those of the goal, be it by way of others.
std::set<std::size_t> connected(const automata::Plant& plant, const automata::Formula& goal) {
  std::vector<std::vector<automata::VariableId>> together;
  for (const automata::Interconnection& rule : plant.interconnections)
    together.push_back(automata::variables_of(rule.constraint));
  for (const automata::Component& component : plant.components) {
    auto& own = together.emplace_back(1, component.mode);
    const auto add = [&](const automata::Formula& formula) {
      const auto variables = automata::variables_of(formula);
      own.insert(own.end(), variables.begin(), variables.end());
    };
    for (const automata::Mode& mode : component.modes) add(mode.constraint);
    for (const automata::Transition& t : component.transitions) add(t.guard);
  }
  const auto first = automata::variables_of(goal);
  std::set<automata::VariableId> found(first.begin(), first.end());
  for (std::size_t before = 0; before != found.size();) {
    before = found.size();
    for (const auto& variables : together) {
      const bool meets = std::any_of(variables.begin(), variables.end(), [&](auto v) { return found.contains(v); });
      if (meets) found.insert(variables.begin(), variables.end());
    }
  }
  std::set<std::size_t> result;
  for (std::size_t i = 0; i < plant.controls.size(); ++i)
    if (found.contains(plant.controls[i].variable)) result.insert(i);
  return result;
}

}  // namespace

Executive::Asked::Asked(GameStep& step, const automata::Formula& goal)
    : arena(step, automata::Ticks::per_second), board(arena, goal, {}, 4000), own(connected(step.plant(), goal)) {}

void Executive::Asked::explore(Node node) {
  if (!reached.insert(node).second) return;
  board.explore(node);
  for (const auto& [n, options] : board.nodes()) reached.insert(n);
  kept.clear();
  for (const Node n : reached)
    if (board.holds(n)) kept.insert(n);
  const auto stays = [&](const Option& option) {
    return std::all_of(option.ways.begin(), option.ways.end(),
                       [&](const Option::Way& w) { return kept.contains(w.to); });
  };
  for (std::size_t before = kept.size() + 1; before != kept.size();) {
    before = kept.size();
    std::erase_if(kept, [&](Node n) { return std::none_of(board.options(n).begin(), board.options(n).end(), stays); });
  }
  hopeful.clear();
  for (std::size_t before = 1; before != hopeful.size();) {
    before = hopeful.size();
    for (const Node n : reached) {
      const auto leads = [&](const Option& option) {
        const bool has_to_do = std::any_of(option.commands.begin(), option.commands.end(), [&](const Commands& all) {
          return std::all_of(all.begin(), all.end(), [&](const auto& command) { return own.contains(command.first); });
        });
        return has_to_do && std::any_of(option.ways.begin(), option.ways.end(),
                                        [&](const Option::Way& way) { return hopeful.contains(way.to); });
      };
      if (board.holds(n) || std::any_of(board.options(n).begin(), board.options(n).end(), leads)) hopeful.insert(n);
    }
    if (before == 0 && hopeful.empty()) break;
  }
}

GameStep::Action Executive::number(const automata::ControlAction& action) const {
  const auto& all = step_.actions();
  return static_cast<GameStep::Action>(std::find(all.begin(), all.end(), action) - all.begin());
}

Executive::Asked& Executive::asked(const automata::Formula& goal) {
  for (const auto& [known, asked] : asked_) {
    if (known == goal) return *asked;
  }
  return *asked_.emplace_back(goal, std::make_unique<Asked>(step_, goal)).second;
}

bool Executive::fits(const automata::Modes& modes, const automata::Formula& goal, const Advice& advice) {
  Asked& asked = this->asked(goal);
  const Node node = asked.arena.start(modes);
  const auto rest = asked.board.rest(node);
  // Of several actions where idling contradicts the model, any.
  const bool rests = !rest || *rest != step_.idle() || step_.actions()[*rest] == advice.action;
  if (goal.is_true()) return rests;
  const auto resting = rest ? asked.arena.turn(node, *rest) : std::nullopt;
  if (resting && resting->dead) return true;
  asked.explore(node);
  if (!asked.hopeful.contains(node)) return rests;
  if (advice.no_plan) return false;
  const auto turn = asked.arena.turn(node, number(advice.action));
  if (!turn || !asked.board.permits(node, *turn)) return false;
  return !asked.kept.contains(node) || all_in(turn->results, asked.kept);
}

std::vector<automata::Modes> Executive::outcomes(const automata::Modes& modes, const automata::Formula& goal,
                                                 const automata::ControlAction& action) {
  Asked& asked = this->asked(goal);
  std::vector<automata::Modes> result;
  const auto turn = asked.arena.turn(asked.arena.start(modes), number(action));
  if (!turn) return result;
  for (const Result& r : turn->results) result.push_back(asked.arena.modes(r.to));
  return result;
}

}  // namespace rmpl::reference
