// Automorphisms of a plant, by those of a graph.
// SPDX-License-Identifier: MIT
#include "verifier/symmetry/automorphisms.hpp"

#include <algorithm>
#include <bliss/graph.hh>
#include <map>
#include <string>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::Plant;
using automata::VariableId;

namespace {

constexpr unsigned most_vertices = 1'000'000;

/// The graph. A formula is its tree, whose leaves are the values that it names; what an inner vertex means is its
/// colour, and where the order of two edges matters each has a coloured vertex of its own.
class PlantGraph {
 public:
  PlantGraph(const Plant& plant, const std::vector<Formula>& formulas, const std::vector<Assignment>& from)
      : plant_(plant) {
    add_variables(from);
    for (const auto& [q, origin] : plant.interconnections) graph_.add_edge(vertex("interconnection"), tree(q));
    for (std::size_t f = 0; f < formulas.size(); ++f) {
      graph_.add_edge(vertex("question " + std::to_string(f)), tree(formulas[f]));
    }
    for (const Component& component : plant.components) {
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        const Formula& constraint = component.modes[m].constraint;
        if (!constraint.is_true()) link("constraint", value(component.mode, m), tree(constraint));
      }
      for (const automata::Transition& t : component.transitions) add_transition(component, t);
    }
  }

  std::vector<Permutation> automorphisms() {
    if (graph_.get_nof_vertices() > most_vertices) return {};
    bliss::Stats statistics;
    graph_.set_component_recursion(false);  // bliss 0.73 loses memory with it
    graph_.find_automorphisms(
        statistics, [](void* self, unsigned, const unsigned* image) { static_cast<PlantGraph*>(self)->collect(image); },
        this);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  unsigned vertex(const std::string& kind) {
    const auto colour = static_cast<unsigned>(colours_.size());
    return graph_.add_vertex(colours_.try_emplace(kind, colour).first->second);
  }

  /// An edge of a kind of its own.
  void link(const std::string& kind, unsigned from, unsigned to) {
    const unsigned middle = vertex(kind);
    graph_.add_edge(from, middle);
    graph_.add_edge(middle, to);
  }

  [[nodiscard]] unsigned value(VariableId variable, std::size_t position) const {
    return first_value_[variable.index()] + static_cast<unsigned>(position);
  }

  void add_variables(const std::vector<Assignment>& from) {
    std::vector<std::string> kinds(plant_.variables.size(), "attribute");
    std::vector<std::vector<std::string>> values;
    for (const auto& variable : plant_.variables) values.emplace_back(variable.values.size(), "value");
    for (const automata::Control& control : plant_.controls) {
      kinds[control.variable.index()] = "control";
      values[control.variable.index()][control.idle.index()] = "idle";
    }
    for (const Component& component : plant_.components) {
      kinds[component.mode.index()] = "component";
      const auto given =
          std::find_if(from.begin(), from.end(), [&](const Assignment& a) { return a.variable == component.mode; });
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        const bool initial = given == from.end() ? component.initial[m] > 0 : given->value.index() == m;
        values[component.mode.index()][m] =
            std::string(component.modes[m].fault ? "fault" : "mode") + (initial ? ", initial" : "");
      }
    }
    for (std::size_t v = 0; v < kinds.size(); ++v) {
      variables_.push_back(vertex(kinds[v]));
      first_value_.push_back(graph_.get_nof_vertices());
      for (const std::string& kind : values[v]) graph_.add_edge(variables_.back(), vertex(kind));
    }
  }

  void add_transition(const Component& component, const automata::Transition& t) {
    std::string kind = t.restart ? "restart" : t.consequence ? "consequence" : "transition";
    if (t.timing) kind += " " + std::to_string(t.timing->lower.count) + " " + std::to_string(t.timing->upper.count);
    if (t.weight.kind != automata::Weight::Kind::none) {
      kind += (t.weight.kind == automata::Weight::Kind::rate ? " rate " : " weight ") + std::to_string(t.weight.value);
    }
    const unsigned self = vertex(kind);
    link("source", self, value(component.mode, t.from.index()));
    link("target", self, value(component.mode, t.to.index()));
    link("guard", self, tree(t.guard));
  }

  unsigned tree(const Formula& formula) {
    switch (formula.kind) {
      case Formula::Kind::constant:
        return vertex(formula.truth ? "true" : "false");
      case Formula::Kind::member: {
        const unsigned self = vertex("member");
        for (const automata::ValueId v : formula.values) graph_.add_edge(self, value(formula.variable, v.index()));
        // A member of no values still speaks of its variable.
        if (formula.values.empty()) graph_.add_edge(self, variables_[formula.variable.index()]);
        return self;
      }
      case Formula::Kind::equality: {
        const unsigned self = vertex("equal");
        for (std::size_t k = 0; k < plant_.variables[formula.variable].values.size(); ++k) {
          const unsigned both = vertex("equal value");
          graph_.add_edge(self, both);
          graph_.add_edge(both, value(formula.variable, k));
          graph_.add_edge(both, value(formula.other, k));
        }
        return self;
      }
      case Formula::Kind::clock:
      case Formula::Kind::knowledge:
        CHECK(false && "a plant has atoms of neither clocks nor knowledge");
        return vertex("");
      case Formula::Kind::negation:
        return node("not", formula);
      case Formula::Kind::conjunction:
        return node("and", formula);
      case Formula::Kind::disjunction:
        return node("or", formula);
      case Formula::Kind::equivalence:
        return node("equivalent", formula);
      case Formula::Kind::implication: {
        const unsigned self = vertex("implies");
        link("premise", self, tree(formula.operands[0]));
        link("conclusion", self, tree(formula.operands[1]));
        return self;
      }
    }
    return 0;
  }

  unsigned node(const std::string& kind, const Formula& formula) {
    const unsigned self = vertex(kind);
    for (const Formula& operand : formula.operands) graph_.add_edge(self, tree(operand));
    return self;
  }

  void collect(const unsigned* image) {
    std::map<unsigned, std::uint32_t> component_of;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      component_of[variables_[plant_.components[c].mode.index()]] = static_cast<std::uint32_t>(c);
    }
    Permutation result;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const Component& component = plant_.components[c];
      const std::uint32_t to = component_of.at(image[variables_[component.mode.index()]]);
      Renaming renaming{static_cast<std::uint32_t>(c), to, {}};
      bool changed = to != c;
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        renaming.modes.push_back(image[value(component.mode, m)] - value(plant_.components[to].mode, 0));
        changed = changed || renaming.modes.back() != m;
      }
      if (changed) result.push_back(std::move(renaming));
    }
    if (!result.empty()) found_.push_back(std::move(result));
  }

  const Plant& plant_;
  bliss::Graph graph_;
  std::map<std::string, unsigned> colours_;
  std::vector<unsigned> variables_;    ///< by variable
  std::vector<unsigned> first_value_;  ///< by variable
  std::vector<Permutation> found_;
};

const Renaming* find(const Permutation& permutation, std::uint32_t component) {
  const auto at = std::lower_bound(permutation.begin(), permutation.end(), component,
                                   [](const Renaming& r, std::uint32_t c) { return r.component < c; });
  return at != permutation.end() && at->component == component ? &*at : nullptr;
}

}  // namespace

Permutation composed(const Permutation& first, const Permutation& second) {
  Permutation result;
  const auto add = [&](Renaming renaming) {
    bool changed = renaming.to != renaming.component;
    for (std::size_t m = 0; m < renaming.modes.size(); ++m) changed = changed || renaming.modes[m] != m;
    if (changed) result.push_back(std::move(renaming));
  };
  for (const Renaming& one : first) {
    const Renaming* two = find(second, one.to);
    if (two == nullptr) {
      add(one);
      continue;
    }
    Renaming both{one.component, two->to, {}};
    for (const std::uint32_t m : one.modes) both.modes.push_back(two->modes[m]);
    add(std::move(both));
  }
  for (const Renaming& two : second) {
    if (find(first, two.component) == nullptr) add(two);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Permutation inverse(const Permutation& permutation) {
  Permutation result;
  for (const Renaming& r : permutation) {
    Renaming back{r.to, r.component, std::vector<std::uint32_t>(r.modes.size())};
    for (std::size_t m = 0; m < r.modes.size(); ++m) back.modes[r.modes[m]] = static_cast<std::uint32_t>(m);
    result.push_back(std::move(back));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Permutation> automorphisms(const Plant& plant, const std::vector<Formula>& formulas,
                                       const std::vector<Assignment>& from) {
  return PlantGraph(plant, formulas, from).automorphisms();
}

}  // namespace rmpl::verifier
