// game PLANT --goal 'constraint' [--from 'modes'] [--cycle seconds] [--bounds] [--whole]: the game of plans solved by
// looking at every node (tests/reference/game.hpp), for a model in a file. SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "automata/assignment_text.hpp"
#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"
#include "tests/reference/game.hpp"
#include "tests/reference/game_ages.hpp"
#include "tests/reference/game_text.hpp"

namespace {

using namespace rmpl;

int refuse(const std::string& why) {
  std::cerr << why << "\n";
  return 2;
}

/// The most likely initial modes, ties to the first.
automata::Modes usual_start(const automata::Plant& plant) {
  automata::Modes modes;
  for (const automata::Component& component : plant.components) {
    const auto best = std::max_element(component.initial.begin(), component.initial.end());
    modes.emplace_back(static_cast<std::size_t>(best - component.initial.begin()));
  }
  return modes;
}

int play(const automata::Plant& plant, std::map<std::string, std::string>& options) {
  const auto goal = compiler::compile_formula(options["--goal"], plant, "--goal");
  if (!goal.formula) return refuse(grammar::render_text(goal.findings, false));
  automata::Modes modes = usual_start(plant);
  if (!options["--from"].empty()) {
    const auto from = compiler::compile_assignments(options["--from"], plant, "--from");
    if (!from.assignments) return refuse(grammar::render_text(from.findings, false));
    for (const automata::Assignment& a : *from.assignments)
      if (const auto c = plant.component_of(a.variable)) modes[c->index()] = automata::ModeId(a.value.index());
  }
  std::set<std::size_t> progress;
  for (std::size_t c = 0; c < plant.components.size(); ++c)
    if (("," + options["--progress"] + ",").find("," + plant.components[c].name + ",") != std::string::npos)
      progress.insert(c);
  const auto cycle = automata::parse_duration(options.contains("--cycle") ? options["--cycle"] : "1");
  if (!cycle || cycle->count == 0) return refuse("--cycle: expected a duration above 0");

  reference::GameStep step(plant);
  if (!step.possible(modes)) return refuse("the plant cannot be there");
  std::unique_ptr<reference::Arena> arena;
  if (options.contains("--bounds"))
    arena = std::make_unique<reference::AgedArena>(step, cycle->count);
  else
    arena = std::make_unique<reference::ModeArena>(step, cycle->count);
  reference::Board board(*arena, *goal.formula, progress);
  const reference::Node start = arena->start(modes);
  const reference::Game game(board, start);
  std::cout << to_text(game.solution().level) << "; " << to_text(game.solution().cost) << "; " << board.nodes().size()
            << " nodes\n"
            << (options.contains("--whole") ? whole(board, game, start) : main_line(board, game, start));
  for (const reference::Harm& harm : board.harms(start)) {
    std::cout << "harm:";
    for (const auto& [c, mode] : harm.modes)
      std::cout << " " << plant.components[c].name << "=" << plant.components[c].modes[mode.index()].name;
    if (harm.to) std::cout << " -> " << plant.components[harm.modes.front().first].modes[harm.to->index()].name;
    std::cout << "\n";
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  std::map<std::string, std::string> options;
  std::string path;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    if (word == "--whole" || word == "--bounds") {
      options[word] = "yes";
    } else if (word.starts_with("--") && i + 1 < count) {
      options[word] = arguments[++i];
    } else {
      path = word;
    }
  }
  if (path.empty() || options["--goal"].empty()) return refuse("usage: game PLANT --goal CONSTRAINT [--from MODES]");
  const compiler::Compilation compilation = compiler::compile({&path, 1});
  if (!compilation.ok()) return refuse(grammar::render_text(compilation.findings(), false));
  if (compilation.document().plants.size() != 1) return refuse("expected one plant");
  try {
    return play(compilation.document().plants.front(), options);
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
