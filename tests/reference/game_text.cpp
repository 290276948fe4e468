// The answer of the game of plans in words. SPDX-License-Identifier: MIT
#include "tests/reference/game_text.hpp"

#include "automata/assignment_text.hpp"
#include "automata/time/time.hpp"
#include "tests/reference/game_pursuit.hpp"

namespace rmpl::reference {

namespace {

const char* name_of(Rank rank) {
  switch (rank) {
    case Rank::sure:
      return "sure";
    case Rank::fair:
      return "fair";
    case Rank::hoped:
      return "hoped";
    case Rank::none:
      return "none";
  }
  return "";
}

const char* name_of(Decision::Purpose purpose) {
  switch (purpose) {
    case Decision::Purpose::reach:
      return "reach";
    case Decision::Purpose::keep:
      return "keep";
    case Decision::Purpose::hold:
      return "hold";
    case Decision::Purpose::none:
      return "no plan";
  }
  return "";
}

std::string number_text(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string modes_text(Board& board, Node node) {
  const auto& plant = board.step().plant();
  return automata::to_text(plant.variables, automata::assignments_of(plant, board.arena().modes(node)));
}

std::string action_text(Board& board, const Decision& decision) {
  if (decision.option == nullptr) return "stuck";
  const auto& plant = board.step().plant();
  const std::string commands =
      automata::to_text(plant.variables, automata::commanded(plant, board.step().actions()[decision.option->action]));
  if (commands.empty()) return "wait";
  return decision.option->waits ? "hold " + commands : commands;
}

}  // namespace

std::string to_text(const Level& level) { return std::string(name_of(level.rank)) + (level.lasts ? ", lasts" : ""); }

std::string to_text(const GameCost& cost) {
  std::string text;
  const auto add = [&](const char* name, double value) {
    if (value == 0) return;
    text += (text.empty() ? "" : ", ") + std::string(name) + " " + number_text(value);
  };
  add("irreversible", static_cast<double>(cost.irreversible));
  add("lost", static_cast<double>(cost.lost));
  add("worth", cost.worth);
  add("unbounded", static_cast<double>(cost.time.unbounded));
  if (cost.time.ticks != 0)
    text += (text.empty() ? "" : ", ") + std::string("time ") + automata::format_seconds({cost.time.ticks});
  add("moves", static_cast<double>(cost.moves));
  add("disturbed", static_cast<double>(cost.disturbed));
  add("commands", static_cast<double>(cost.commands));
  add("waits", static_cast<double>(cost.waits));
  add("reward", cost.reward);
  return text;
}

std::string main_line(Board& board, const Game& game, Node start) {
  const auto& strategy = game.solution().strategy;
  std::string text;
  std::set<std::pair<Node, bool>> met;
  bool reached = false;
  for (Node node = start;;) {
    reached = reached || strategy.contains({node, true});
    if (!met.emplace(node, reached).second) {
      text += "  … again\n";
      break;
    }
    const Decision& decision = strategy.at({node, reached});
    text += "  " + std::to_string(met.size()) + ". " + action_text(board, decision) + "  [" +
            name_of(decision.purpose) + "]\n";
    if (decision.purpose == Decision::Purpose::keep) text += pursuit_line(board, game, node);
    if (decision.option == nullptr || decision.option->ways.empty()) break;
    // What nature chooses soonest, and of that what moves most.
    const Option::Way* best = nullptr;
    for (const Option::Way& way : decision.option->ways) {
      if (way.to == node) continue;
      const auto cost = [&](const Option::Way& w) {
        const Level level = game.level(w.to);
        return std::pair(game.kept().contains(w.to) ? Rank::sure : level.rank, w.soonest);
      };
      if (best == nullptr || cost(way) < cost(*best)) best = &way;
    }
    if (best == nullptr) break;
    node = best->to;
    text += "       -> " + modes_text(board, node) + "\n";
    if (met.size() > 40) break;
  }
  return text;
}

std::string pursuit_line(Board& board, const Game& game, Node node) {
  const Pursuit pursuit(board, game.kept(), node);
  if (!pursuit.reward()) return "";
  std::string text = "  for a reward of " + number_text(*pursuit.reward()) + ", not " + number_text(pursuit.idle()) +
                     ": " + to_text(pursuit.cost()) + "\n";
  while (const Option* option = pursuit.option(node)) {
    text += "    " + action_text(board, {Decision::Purpose::keep, option}) + "\n";
    node = option->ways.front().to;
    text += "       -> " + modes_text(board, node) + "\n";
  }
  return text;
}

std::string whole(Board& board, const Game& game, Node start) {
  std::string text = "start " + std::to_string(start) + "\n";
  for (const auto& [at, decision] : game.solution().strategy) {
    text += std::to_string(at.first) + (at.second ? "'" : "") + ": " + modes_text(board, at.first) + "\n    " +
            action_text(board, decision) + " [" + name_of(decision.purpose) + "] ->";
    if (decision.option != nullptr)
      for (const Option::Way& way : decision.option->ways) text += " " + std::to_string(way.to);
    text += "\n";
  }
  return text;
}

}  // namespace rmpl::reference
