// A layer of markings a step; within a layer the way with fewest commands stays.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/marking_planner.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "automata/step/model_commands.hpp"
#include "base/product.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Command;
using automata::Marking;
using automata::MarkingMoves;
using automata::MarkingOutcome;
using automata::ModelProgram;

constexpr std::size_t most_combinations = 256;

/// The idlest first; of those as idle, what is declared first. With how many values are off idle.
std::vector<std::pair<std::size_t, Command>> free_commands(const ModelProgram& program) {
  auto commands = automata::all_commands(program, most_combinations);
  if (!commands) commands = automata::single_commands(program);
  const Command idle = commands->front();
  std::vector<std::pair<std::size_t, Command>> result;
  result.reserve(commands->size());
  for (Command& command : *commands) {
    std::size_t busy = 0;
    for (std::size_t c = 0; c < command.size(); ++c) busy += command[c] != idle[c] ? 1 : 0;
    result.emplace_back(busy, std::move(command));
  }
  const auto idle_before = [&](const Command& command) {
    return std::mismatch(command.begin(), command.end(), idle.begin()).first - command.begin();
  };
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) {
    return std::pair(a.first, idle_before(a.second)) < std::pair(b.first, idle_before(b.second));
  });
  return result;
}

/// The outcomes of each part; with `likely` those that take no improbable draw.
std::vector<std::vector<const MarkingOutcome*>> outcomes_of(const MarkingMoves& moves, bool likely) {
  std::vector<std::vector<const MarkingOutcome*>> result;
  for (const auto& part : moves.parts) {
    auto& ways = result.emplace_back();
    for (const MarkingOutcome& outcome : part) {
      if (!likely || outcome.improbable == 0) ways.push_back(&outcome);
    }
  }
  return result;
}

}  // namespace

MarkingPlanner::MarkingPlanner(const ModelProgram& program) : step_(program), commands_(free_commands(program)) {}

/// Of ways that take as many steps.
bool MarkingPlanner::better(const Node& a, const Node& b) const {
  return a.busy != b.busy ? a.busy < b.busy : commands_[a.first].first > commands_[b.first].first;
}

void MarkingPlanner::add(const Node& node) {
  if (node.marking >= at_.size()) at_.resize(node.marking + 1);
  auto& known = at_[node.marking];
  if (!known) {
    known = nodes_.size();
    nodes_.push_back(node);
  } else if (*known >= layer_ && better(node, nodes_[*known])) {
    nodes_[*known] = node;
  }
}

template <class Visit>
void MarkingPlanner::each_way(Number from, const Command& command, Draws draws, const Visit& visit) {
  step_.command(command);
  if (!step_.permits(from)) return;
  const MarkingMoves& moves = step_.moves(from);
  base::for_each_combination(outcomes_of(moves, draws == Draws::likely),
                             [&](const std::vector<const MarkingOutcome*>& outcomes) {
                               const Number number = step_.number(united(moves, outcomes));
                               if (step_.possible(number)) visit(number);
                             });
}

void MarkingPlanner::expand(std::size_t node, bool start, Draws draws) {
  const Node from = nodes_[node];
  for (std::size_t c = 0; c < commands_.size(); ++c) {
    each_way(from.marking, commands_[c].second, draws, [&](Number number) {
      add({number, start ? c : from.first, from.busy + commands_[c].first});
    });
    ++steps_;
    if (given_up()) return;
  }
}

bool MarkingPlanner::lasts(std::span<const Assignment> goal) {
  constexpr std::size_t most_idle = 1000;
  const Command& idle = commands_.front().second;
  std::set<Number> seen{found_};
  std::vector<Number> open{found_};
  while (!open.empty()) {
    const Number marking = open.back();
    open.pop_back();
    bool kept = seen.size() <= most_idle;
    each_way(marking, idle, Draws::likely, [&](Number next) {
      kept = kept && step_.entails(next, goal);
      if (seen.insert(next).second) open.push_back(next);
    });
    if (!kept) return false;
  }
  return true;
}

std::optional<Command> MarkingPlanner::permitted(const Marking& from, const Command& command) {
  const Number marking = step_.number(from);
  const auto permits = [&](const Command& other) {
    step_.command(other);
    return step_.permits(marking);
  };
  if (permits(command)) return command;
  const Command& idle = commands_.front().second;
  for (const auto& free : commands_) {
    bool keeps = true;
    for (std::size_t c = 0; c < command.size(); ++c) {
      keeps = keeps && (command[c] == idle[c] || command[c] == free.second[c]);
    }
    if (keeps && permits(free.second)) return free.second;
  }
  return std::nullopt;
}

MarkingMove MarkingPlanner::next(const Marking& from, std::span<const Assignment> goal) {
  std::vector<std::uint64_t> question;
  for (const Assignment& wanted : goal) {
    question.push_back(std::uint64_t{wanted.variable.value} << 32 | wanted.value.value);
  }
  question.push_back(~std::uint64_t{0});
  for (const automata::LocationId location : from) question.push_back(location.value);
  nodes_.clear();
  at_.clear();
  step_.forget_but({});
  if (const Known* known = known_.find(question)) {
    found_ = step_.number(known->found);
    return known->move;
  }
  const Number start = step_.number(from);
  MarkingMove move = searched(start, goal, Draws::likely);
  if (move.kind == MarkingMove::Kind::nowhere) {
    const std::size_t looked_at = nodes_.size();
    if (searched(start, goal, Draws::any).kind == MarkingMove::Kind::step) move.kind = MarkingMove::Kind::failure;
    nodes_.resize(looked_at, {start, 0, 0});
  }
  return known_.add(std::move(question), {std::move(move), step_[found_]}).move;
}

MarkingMove MarkingPlanner::searched(Number start, std::span<const Assignment> goal, Draws draws) {
  nodes_.clear();
  at_.clear();
  layer_ = 0;
  steps_ = 0;
  add({start, 0, 0});
  found_ = start;
  if (step_.entails(start, goal)) return {MarkingMove::Kind::done, {}};
  for (std::size_t begin = 0; begin < nodes_.size();) {
    const std::size_t end = nodes_.size();
    layer_ = end;
    for (std::size_t n = begin; n < end; ++n) {
      expand(n, n == 0, draws);
      if (given_up()) return {MarkingMove::Kind::given_up, {}};
    }
    const Node* best = nullptr;
    for (std::size_t n = end; n < nodes_.size(); ++n) {
      if (best != nullptr && !better(nodes_[n], *best)) continue;
      if (step_.entails(nodes_[n].marking, goal)) best = &nodes_[n];
    }
    if (best != nullptr) {
      found_ = best->marking;
      return {MarkingMove::Kind::step, commands_[best->first].second};
    }
    begin = end;
  }
  return {MarkingMove::Kind::nowhere, {}};
}

}  // namespace rmpl::runtime
