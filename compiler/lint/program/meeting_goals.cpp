// Forks, and the goals on their ways.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/meeting_goals.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace rmpl::compiler {

using automata::Arc;
using automata::Location;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Of a component, the modes that are asked for.
using Asked = std::map<VariableId, std::set<ValueId>>;

void add(Asked& into, const Asked& more) {
  for (const auto& [component, modes] : more) into[component].insert(modes.begin(), modes.end());
}

class Forks {
 public:
  explicit Forks(const automata::Program& program)
      : locations_(program.locations), inside_(locations_.size()), onward_(locations_.size()) {
    for (std::size_t l = 0; l < locations_.size(); ++l) add_goals(l);
    for (std::size_t l = 0; l < locations_.size(); ++l) {
      for (const Arc& arc : locations_[l].arcs) add_edge(l, arc.target.index());
    }
  }

  std::set<VariableId> run() {
    std::map<std::size_t, std::vector<std::size_t>> starts;
    for (std::size_t l = 0; l < locations_.size(); ++l) {
      if (locations_[l].parent && locations_[l].start) starts[locations_[l].parent->index()].push_back(l);
    }
    for (const auto& [composite, ways] : starts) fork(ways);
    for (std::size_t l = 0; l < locations_.size(); ++l) {
      if (!several(locations_[l])) continue;
      std::vector<std::size_t> ways;
      for (const Arc& arc : locations_[l].arcs) {
        if (const auto way = beside(l, arc.target.index())) ways.push_back(*way);
      }
      fork(ways);
    }
    for (const auto& [left, entered] : deep_) fork({left, entered});
    return std::move(found_);
  }

 private:
  void add_goals(std::size_t l) {
    Asked own;
    for (const automata::Assignment& goal : locations_[l].goal) own[goal.variable].insert(goal.value);
    if (own.empty()) return;
    add(inside_[l], own);
    for (auto parent = locations_[l].parent; parent; parent = locations_[parent->index()].parent) {
      add(inside_[parent->index()], own);
    }
  }

  /// Whether arcs can be taken at the same time: there are two that are not each other's opposite.
  static bool several(const Location& location) {
    const auto& arcs = location.arcs;
    for (std::size_t a = 1; a < arcs.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const bool opposite =
            arcs[a].guard.constraint == arcs[b].guard.constraint && arcs[a].guard.entailed != arcs[b].guard.entailed;
        if (!opposite) return true;
      }
    }
    return false;
  }

  /// The locations above one, itself first.
  [[nodiscard]] std::vector<std::size_t> line_of(std::size_t l) const {
    std::vector<std::size_t> line{l};
    for (auto parent = locations_[l].parent; parent; parent = locations_[parent->index()].parent) {
      line.push_back(parent->index());
    }
    return line;
  }

  /// Of two locations, the two beside each other in one composite that are or hold them.
  [[nodiscard]] std::pair<std::size_t, std::size_t> in_one_composite(std::size_t from, std::size_t to) const {
    if (locations_[from].parent == locations_[to].parent) return {from, to};
    const std::vector<std::size_t> above = line_of(from);
    for (std::size_t target = to;; target = locations_[target].parent->index()) {
      for (const std::size_t source : above) {
        if (locations_[source].parent == locations_[target].parent) return {source, target};
      }
    }
  }

  void add_edge(std::size_t from, std::size_t to) {
    const auto [source, target] = in_one_composite(from, to);
    onward_[source].push_back(target);
    // What holds the source stays while something else is entered.
    if (source != from || target != to) deep_.emplace(source, target);
  }

  /// What an arc from a location enters, beside it; nothing where that lies elsewhere, and is a fork of its own.
  [[nodiscard]] std::optional<std::size_t> beside(std::size_t from, std::size_t to) const {
    if (locations_[from].parent == locations_[to].parent) return to;
    return std::nullopt;
  }

  /// All that is asked for on a way within its composite.
  Asked asked_on(std::size_t way) const {
    Asked asked;
    std::set<std::size_t> seen{way};
    std::vector<std::size_t> pending{way};
    while (!pending.empty()) {
      const std::size_t l = pending.back();
      pending.pop_back();
      add(asked, inside_[l]);
      for (const std::size_t next : onward_[l]) {
        if (seen.insert(next).second) pending.push_back(next);
      }
    }
    return asked;
  }

  void fork(const std::vector<std::size_t>& ways) {
    if (ways.size() < 2) return;
    Asked all;
    std::map<VariableId, std::size_t> count;
    for (const std::size_t way : ways) {
      const Asked asked = asked_on(way);
      add(all, asked);
      for (const auto& [component, modes] : asked) ++count[component];
    }
    for (const auto& [component, modes] : all) {
      if (modes.size() > 1 && count[component] > 1) found_.insert(component);
    }
  }

  const std::vector<Location>& locations_;
  std::vector<Asked> inside_;                           ///< per location, with all that it holds
  std::vector<std::vector<std::size_t>> onward_;        ///< per location, what follows it or what it holds, beside it
  std::set<std::pair<std::size_t, std::size_t>> deep_;  ///< arcs into or out of composites, in the one that holds both
  std::set<VariableId> found_;
};

}  // namespace

std::vector<VariableId> components_of_meeting_goals(const automata::Program& program) {
  const std::set<VariableId> found = Forks(program).run();
  return {found.begin(), found.end()};
}

}  // namespace rmpl::compiler
