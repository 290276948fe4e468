// What has to do with what in a model program, by union and find over locations and variables.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/marking_groups.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/partition.hpp"

namespace rmpl::automata {
namespace {

/// Locations, then variables.
class Links {
 public:
  explicit Links(const ModelProgram& program)
      : program_(program),
        partition_(program.locations.size() + program.variables.size()),
        children_(program.locations.size()),
        told_(program.variables.size()) {
    for (std::size_t l = 0; l < program.locations.size(); ++l) {
      if (const auto& parent = program.locations[l].parent) children_[parent->index()].push_back(l);
    }
    find_told();
    for (std::size_t l = 0; l < program.locations.size(); ++l) link(l);
    for (const InitialDraw& draw : program.initial) {
      for (const InitialBranch& branch : draw.branches) {
        for (const LocationId started : branch.started) link_started(draw.choice.index(), started.index());
      }
    }
  }

  [[nodiscard]] bool told(VariableId variable) const { return told_[variable.index()]; }
  std::size_t root(LocationId location) { return partition_.root(location.index()); }
  std::size_t root(VariableId variable) { return partition_.root(node(variable)); }

 private:
  [[nodiscard]] std::size_t node(VariableId variable) const { return program_.locations.size() + variable.index(); }

  /// What is commanded, and told nothing of, has a value that is given.
  void find_told() {
    const auto read = [&](const Formula& formula) {
      for (const VariableId v : variables_of(formula)) told_[v.index()] = true;
    };
    std::vector<bool> commanded(program_.variables.size(), false);
    for (const CommandedVariable& control : program_.controls) commanded[control.variable.index()] = true;
    for (std::size_t v = 0; v < commanded.size(); ++v) told_[v] = !commanded[v];
    for (const ModelLocation& location : program_.locations) read(location.told);
    for (const Interconnection& constraint : program_.constraints) {
      read(constraint.constraint);
      for (const Formula& conjunct : conjuncts_of(constraint.constraint)) {
        const auto variables = variables_of(conjunct);
        for (const VariableId v : variables) partition_.join(node(variables.front()), node(v));
      }
    }
  }

  [[nodiscard]] bool reads_told(const Formula& formula) const {
    const auto variables = variables_of(formula);
    return std::any_of(variables.begin(), variables.end(), [&](VariableId v) { return told(v); });
  }
  void link_read(std::size_t location, const Formula& formula) {
    for (const VariableId v : variables_of(formula)) {
      if (told(v)) partition_.join(location, node(v));
    }
  }
  void link_started(std::size_t location, std::size_t started) {
    partition_.join(location, started);
    for (const std::size_t child : children_[started]) {
      if (program_.locations[child].start) link_started(location, child);
    }
  }
  void link_inside(std::size_t location, std::size_t composite) {
    for (const std::size_t child : children_[composite]) {
      partition_.join(location, child);
      link_inside(location, child);
    }
  }
  void link_arcs(std::size_t location, const std::vector<GuardedArc>& arcs) {
    for (const GuardedArc& arc : arcs) {
      for (const Condition& guard : arc.guard) link_read(location, guard.constraint);
      link_started(location, arc.target.index());
    }
  }
  void link(std::size_t l) {
    const ModelLocation& location = program_.locations[l];
    if (location.composite) {
      if (reads_told(location.maintenance.constraint) || !location.arcs.empty()) link_inside(l, l);
      link_read(l, location.maintenance.constraint);
      link_arcs(l, location.arcs);
      return;
    }
    link_read(l, location.told);
    for (const TransitionFunction& function : location.functions) {
      for (const LocationId started : function.started) partition_.join(l, started.index());
      link_arcs(l, function.arcs);
    }
  }

  const ModelProgram& program_;
  base::Partition partition_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<bool> told_;  ///< by variable: whether its value is more than a command
};

/// Copies one group out of a program.
class Extraction {
 public:
  Extraction(const ModelProgram& whole, std::vector<LocationId> locations, const std::vector<VariableId>& variables)
      : whole_(whole), location_(whole.locations.size()), variable_(whole.variables.size()) {
    group_.locations = std::move(locations);
    for (std::size_t i = 0; i < group_.locations.size(); ++i) location_[group_.locations[i].index()] = LocationId(i);
    for (const VariableId v : variables) variable_[v.index()] = group_.program.variables.add(whole.variables[v]);
  }

  MarkingGroup take() {
    ModelProgram& own = group_.program;
    own.name = whole_.name;
    for (std::size_t c = 0; c < whole_.controls.size(); ++c) {
      if (!variable_[whole_.controls[c].variable.index()]) continue;
      own.controls.push_back({*variable_[whole_.controls[c].variable.index()], whole_.controls[c].idle});
      group_.controls.push_back(c);
    }
    for (const VariableId v : whole_.observables) {
      if (const auto& seen = variable_[v.index()]) own.observables.push_back(*seen);
    }
    for (const LocationId l : group_.locations) own.locations.push_back(location(whole_.locations[l.index()]));
    for (const InitialDraw& draw : whole_.initial) {
      if (!location_[draw.choice.index()]) continue;
      own.initial.push_back(draw);
      own.initial.back().choice = *location_[draw.choice.index()];
      for (auto& branch : own.initial.back().branches) rename(branch.started);
    }
    return std::move(group_);
  }
  [[nodiscard]] Formula formula(const Formula& whole) const {
    return renamed(
        whole, [&](VariableId v) { return *variable_[v.index()]; }, [](VariableId, ValueId value) { return value; });
  }
  [[nodiscard]] const std::optional<VariableId>& variable(VariableId whole) const { return variable_[whole.index()]; }

 private:
  void rename(std::vector<LocationId>& locations) const {
    for (LocationId& l : locations) l = *location_[l.index()];
  }
  void rename(std::vector<GuardedArc>& arcs) const {
    for (GuardedArc& arc : arcs) {
      arc.target = *location_[arc.target.index()];
      for (Condition& guard : arc.guard) guard.constraint = formula(guard.constraint);
    }
  }
  [[nodiscard]] ModelLocation location(const ModelLocation& whole) const {
    ModelLocation own = whole;
    if (own.parent) own.parent = location_[own.parent->index()];
    own.told = formula(own.told);
    own.maintenance.constraint = formula(own.maintenance.constraint);
    rename(own.arcs);
    for (TransitionFunction& function : own.functions) {
      rename(function.started);
      rename(function.arcs);
    }
    return own;
  }

  const ModelProgram& whole_;
  MarkingGroup group_;
  std::vector<std::optional<LocationId>> location_;  ///< by location of the whole
  std::vector<std::optional<VariableId>> variable_;  ///< by variable of the whole
};

/// What a group is made of, in the whole program.
struct Members {
  std::set<LocationId> locations;
  std::set<VariableId> variables;
  std::vector<Interconnection> constraints;
};

void add_guarded(const ModelProgram& program, LocationId location, std::set<VariableId>& variables) {
  const auto add = [&](const std::vector<GuardedArc>& arcs) {
    for (const GuardedArc& arc : arcs) {
      for (const Condition& guard : arc.guard) {
        for (const VariableId v : variables_of(guard.constraint)) variables.insert(v);
      }
    }
  };
  const ModelLocation& own = program.locations[location.index()];
  for (const VariableId v : variables_of(own.maintenance.constraint)) variables.insert(v);
  add(own.arcs);
  for (const TransitionFunction& function : own.functions) add(function.arcs);
}

}  // namespace

MarkingGroups::MarkingGroups(const ModelProgram& program) : homes_(program.variables.size()) {
  Links links(program);
  std::map<std::size_t, Members> members;  // by root
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    if (program.locations[l].composite && !program.locations[l].arcs.empty()) members[links.root(LocationId(l))];
    if (!program.locations[l].composite) members[links.root(LocationId(l))];
  }
  for (const Interconnection& constraint : program.constraints) {
    for (Formula& conjunct : conjuncts_of(constraint.constraint)) {
      const auto variables = variables_of(conjunct);
      const std::size_t root =
          variables.empty() ? (members.empty() ? 0 : members.begin()->first) : links.root(variables.front());
      members[root].constraints.emplace_back(std::move(conjunct), constraint.origin);
    }
  }
  if (members.empty()) members[0];
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const auto own = members.find(links.root(LocationId(l)));
    if (own == members.end()) continue;
    for (std::optional<LocationId> at(l); at; at = program.locations[at->index()].parent) {
      add_guarded(program, *at, own->second.variables);
      own->second.locations.insert(*at);
    }
  }
  for (std::size_t v = 0; v < program.variables.size(); ++v) {
    if (program.variables[VariableId(v)].values.size() == 1) always_.push_back({VariableId(v), ValueId(0)});
    const auto own = members.find(links.root(VariableId(v)));
    if (own != members.end() && links.told(VariableId(v))) own->second.variables.insert(VariableId(v));
  }
  for (auto& [root, part] : members) {
    Extraction extraction(program, {part.locations.begin(), part.locations.end()},
                          {part.variables.begin(), part.variables.end()});
    for (const VariableId v : part.variables) {
      if (links.told(v)) homes_[v.index()] = Home{groups_.size(), *extraction.variable(v)};
    }
    groups_.push_back(extraction.take());
    groups_.back().variables.assign(part.variables.begin(), part.variables.end());
    for (const Interconnection& told : part.constraints) {
      groups_.back().program.constraints.emplace_back(extraction.formula(told.constraint), told.origin);
    }
  }
}

std::vector<Observation> MarkingGroups::divide(const Observation& observation) const {
  std::vector<Observation> result(groups_.size());
  for (const Assignment& reading : observation) {
    if (const auto& home = homes_[reading.variable.index()]) {
      result[home->group].push_back({home->variable, reading.value});
    }
  }
  return result;
}

std::vector<Command> MarkingGroups::divide(const Command& command) const {
  std::vector<Command> result;
  for (const MarkingGroup& group : groups_) {
    Command& own = result.emplace_back();
    for (const std::size_t c : group.controls) own.push_back(command[c]);
  }
  return result;
}

}  // namespace rmpl::automata
