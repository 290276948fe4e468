// Locations, arcs and draws become a PHCA.
// SPDX-License-Identifier: MIT
#include "compiler/lower/model.hpp"

#include <set>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/draws.hpp"

namespace rmpl::compiler {

using automata::GuardedArc;
using automata::Location;
using automata::LocationId;
using automata::ModelLocation;
using grammar::Code;

namespace {

/// What is told now must not depend on what is drawn now (ijcai01, "choose").
void check_branches(const LoweredProgram& lowered, const Draws& draws, grammar::Diagnostics& diagnostics) {
  std::set<LocationId> reported;
  for (const auto& [choice, functions] : draws.functions) {
    for (const automata::TransitionFunction& function : functions) {
      for (const LocationId start : function.started) {
        const auto told = lowered.model.told.find(start);
        if (told == lowered.model.told.end() || told->second.is_true() || !reported.insert(start).second) continue;
        const std::string& text = lowered.program.locations[start.index()].label;
        auto& error =
            diagnostics.error(Code::told_at_once, lowered.places.locations[start.index()],
                              "this branch tells " + backquoted(text) +
                                  " in the instant of its `choose`, which is drawn only at the end of that instant");
        error.notes.push_back({lowered.places.locations[choice.index()], "the `choose` is here"});
        error.suggestion = "tell it in the next instant: `next " + text + "`";
      }
    }
  }
}

std::vector<GuardedArc> guarded(const std::vector<automata::Arc>& arcs) {
  std::vector<GuardedArc> result;
  for (const automata::Arc& arc : arcs) {
    GuardedArc& made = result.emplace_back(GuardedArc{{}, arc.target});
    if (!arc.guard.is_trivial()) made.guard.push_back(arc.guard);
  }
  return result;
}

ModelLocation location_of(LocationId id, const LoweredProgram& lowered, Draws& draws) {
  const Location& from = lowered.program.locations[id.index()];
  ModelLocation made;
  made.composite = from.composite;
  made.parent = from.parent;
  made.start = from.start && !draws.first[id.index()];
  made.maintenance = from.maintenance;
  made.label = from.label;
  made.origin = from.origin;
  if (const auto told = lowered.model.told.find(id); told != lowered.model.told.end()) made.told = told->second;
  if (from.composite) {
    made.arcs = guarded(from.arcs);
  } else if (const auto functions = draws.functions.find(id); functions != draws.functions.end()) {
    made.functions = std::move(functions->second);
  } else {
    made.functions.push_back({1, {}, guarded(from.arcs)});
  }
  return made;
}

}  // namespace

automata::ModelProgram model_program(const LoweredProgram& lowered, const ModelDeclarations& declared,
                                     grammar::Diagnostics& diagnostics) {
  Draws draws = draws_of(lowered.program, lowered.model);
  if (draws.too_large) {
    auto& error =
        diagnostics.error(Code::too_large, lowered.places.locations[draws.too_large->index()],
                          "the `choose` steps that are drawn together here have more than a million combinations");
    error.suggestion = "put them in sequence, or put `next` before each `choose` inside a branch";
    return {};
  }
  check_branches(lowered, draws, diagnostics);
  automata::ModelProgram made;
  made.name = lowered.program.name;
  made.variables = declared.part.plant.variables;
  made.controls = declared.controls;
  made.observables = declared.observables;
  made.constraints = declared.constraints;
  for (std::size_t l = 0; l < lowered.program.locations.size(); ++l)
    made.locations.push_back(location_of(LocationId(l), lowered, draws));
  made.initial = std::move(draws.initial);
  made.origin = made.locations.front().origin;
  return made;
}

}  // namespace rmpl::compiler
