// Functions to dots, and the rest as every program.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/model_diagram.hpp"

#include <algorithm>
#include <utility>

#include "compiler/check/probabilities.hpp"
#include "compiler/diagram/program_diagram.hpp"

namespace rmpl::compiler {
namespace {

using automata::GuardedArc;
using automata::LocationId;
using automata::ModelLocation;
using automata::ModelProgram;

/// One condition for all of them. A source gives an arc one at most; where a document has several, those of the kind of
/// the first are drawn.
automata::Condition joined(const std::vector<automata::Condition>& conditions) {
  if (conditions.empty()) return {};
  if (!conditions.front().entailed) return conditions.front();
  std::vector<automata::Formula> all;
  for (const automata::Condition& one : conditions) {
    if (one.entailed) all.push_back(one.constraint);
  }
  return {true, automata::conjunction(std::move(all))};
}

class Looking {
 public:
  explicit Looking(const ModelProgram& model) : model_(model), count_(model.locations.size()) {
    look_.told.resize(count_);
    look_.hidden.assign(count_, false);
  }

  Look run() {
    hide();
    for (std::size_t l = 0; l < count_; ++l) {
      const ModelLocation& location = model_.locations[l];
      if (!location.told.is_true()) look_.told[l] = to_text(location.told, model_.variables);
      if (draws(location)) add_functions(LocationId(l));
    }
    for (const automata::InitialDraw& draw : model_.initial) {
      auto& functions = look_.choices[draw.choice];
      functions.clear();
      for (const automata::InitialBranch& branch : draw.branches)
        functions.push_back({decimal(branch.probability), {}, branch.started, true});
    }
    return std::move(look_);
  }

 private:
  static bool draws(const ModelLocation& location) {
    return location.functions.size() > 1 ||
           (!location.functions.empty() && !location.functions.front().started.empty());
  }

  /// What is never marked and stands beside its choice need not be seen: the choice has its arcs.
  void hide() {
    std::vector<bool> marked(count_, false);
    for (std::size_t l = 0; l < count_; ++l) {
      const ModelLocation& location = model_.locations[l];
      if (location.start) marked[l] = true;
      for (const GuardedArc& arc : location.arcs) marked[arc.target.index()] = true;
      for (const auto& function : location.functions) {
        for (const GuardedArc& arc : function.arcs) marked[arc.target.index()] = true;
      }
    }
    for (const automata::InitialDraw& draw : model_.initial) {
      for (const automata::InitialBranch& branch : draw.branches) {
        for (const LocationId started : branch.started) marked[started.index()] = true;
      }
    }
    for (std::size_t l = 0; l < count_; ++l) {
      for (const auto& function : model_.locations[l].functions) {
        for (const LocationId started : function.started) {
          const bool beside = model_.locations[started.index()].parent == model_.locations[l].parent;
          if (beside && !marked[started.index()]) look_.hidden[started.index()] = true;
        }
      }
    }
    // A choice that is only multiplied into others.
    for (std::size_t l = 0; l < count_; ++l) {
      const bool first = std::any_of(model_.initial.begin(), model_.initial.end(),
                                     [&](const automata::InitialDraw& draw) { return draw.choice == LocationId(l); });
      if (!marked[l] && !first && draws(model_.locations[l])) look_.hidden[l] = true;
    }
  }

  void add_functions(LocationId choice) {
    if (look_.hidden[choice.index()]) return;
    for (const auto& function : model_.locations[choice.index()].functions) {
      DrawnFunction drawn{decimal(function.probability), function.arcs, {}, false};
      for (const LocationId started : function.started) {
        if (!look_.hidden[started.index()]) {
          drawn.beginning.push_back(started);
          continue;
        }
        const auto& arcs = model_.locations[started.index()].functions.front().arcs;
        drawn.arcs.insert(drawn.arcs.end(), arcs.begin(), arcs.end());
      }
      look_.choices[choice].push_back(std::move(drawn));
    }
  }

  const ModelProgram& model_;
  const std::size_t count_;
  Look look_;
};

/// The locations and arcs, for the layout; those of a choice stand for what its functions lead to.
automata::Program outline(const ModelProgram& model, const Look& look) {
  automata::Program program;
  program.name = model.name;
  program.variables = model.variables;
  for (std::size_t l = 0; l < model.locations.size(); ++l) {
    const ModelLocation& from = model.locations[l];
    automata::Location made;
    made.composite = from.composite;
    made.parent = from.parent;
    made.start = from.start;
    made.maintenance = from.maintenance;
    made.label = from.label;
    made.origin = from.origin;
    const auto add = [&](const GuardedArc& arc) { made.arcs.push_back({joined(arc.guard), arc.target}); };
    if (const auto choice = look.choices.find(LocationId(l)); choice != look.choices.end()) {
      for (const DrawnFunction& function : choice->second) {
        for (const GuardedArc& arc : function.arcs) add(arc);
        for (const LocationId begun : function.beginning) made.arcs.push_back({{}, begun});
      }
    } else if (!look.hidden[l]) {
      const auto& arcs = from.composite || from.functions.empty() ? from.arcs : from.functions.front().arcs;
      for (const GuardedArc& arc : arcs) add(arc);
    }
    program.locations.push_back(std::move(made));
  }
  return program;
}

}  // namespace

std::string model_diagram(const ModelProgram& model, std::optional<std::size_t> depth) {
  const Look look = Looking(model).run();
  return program_diagram(outline(model, look), depth, look);
}

}  // namespace rmpl::compiler
