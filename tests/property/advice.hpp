// What the reconfigurer says, in the terms of the twins.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/reference/closed_loop.hpp"
#include "tests/reference/executive.hpp"

namespace rmpl::property {

inline reference::Advice told(const runtime::Reconfiguration& answer) {
  const bool command = answer.outcome == runtime::Reconfiguration::Outcome::command;
  return {answer.outcome == runtime::Reconfiguration::Outcome::no_plan, answer.action,
          command && answer.why.purpose == runtime::Reason::Purpose::reward};
}

/// The reconfigurer as adviser; keeps a reference.
inline reference::Adviser adviser_of(runtime::Reconfigurer& reconfigurer) {
  using Position = reference::Adviser::Position;
  using Goal = std::vector<automata::Assignment>;
  struct Positions {
    std::vector<runtime::StrategyPosition> known{{}};
    std::map<runtime::StrategyPosition, Position> numbers{{{}, 0}};
  };
  const auto positions = std::make_shared<Positions>();
  const auto ask = [&reconfigurer, positions](const automata::Modes& modes, const Goal& goal, Position position) {
    return reconfigurer.go_on(modes, automata::conjunction_of(goal), positions->known[position]);
  };
  return {
      [ask](const automata::Modes& modes, const Goal& goal, Position position) {
        return told(ask(modes, goal, position));
      },
      [ask, positions](const automata::Modes& modes, const Goal& goal, Position position, const automata::Modes& then) {
        runtime::StrategyPosition next = position_after(ask(modes, goal, position), then);
        const auto [at, fresh] = positions->numbers.try_emplace(next, positions->known.size());
        if (fresh) positions->known.push_back(std::move(next));
        return at->second;
      }};
}

}  // namespace rmpl::property
