// Where in its strategies an executive is: what it knows beside the modes that it sees (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/game/age.hpp"

namespace rmpl::runtime {

/// The nodes in force of strategies for one goal, as far as modes do not tell them: how old modes are. A value that is
/// compared by what it says, so that it can be part of a state; most are empty.
class StrategyPosition {
 public:
  /// Of a group of the goal whose bounds matter.
  struct Group {
    std::vector<std::size_t> parts;                 ///< of the goal, ascending
    std::vector<automata::ComponentId> components;  ///< ascending
    std::vector<Age> ages;                          ///< by component
    auto operator<=>(const Group&) const = default;
  };

  /// Nothing is known of ages but that nothing is overdue.
  StrategyPosition() = default;
  StrategyPosition(std::string goal, std::vector<Group> groups);

  [[nodiscard]] bool is_empty() const { return data_ == nullptr; }
  /// None where the position is one of another goal.
  [[nodiscard]] const std::vector<Group>& groups(const std::string& goal) const;

  bool operator==(const StrategyPosition& other) const { return (*this <=> other) == 0; }
  std::strong_ordering operator<=>(const StrategyPosition& other) const;
  [[nodiscard]] std::size_t hash() const;

 private:
  struct Data {
    std::string goal;  ///< its text
    std::vector<Group> groups;
    auto operator<=>(const Data&) const = default;
  };
  std::shared_ptr<const Data> data_;
};

/// The edges of the nodes in force: which position follows an action, by the modes that are seen next.
class StrategyEdges {
 public:
  /// Of one group.
  struct Group {
    std::vector<std::size_t> parts;
    std::vector<automata::ComponentId> components;
    /// Components outside on whose modes the group rests, with these modes: where they change, no edge fits.
    std::vector<std::pair<automata::ComponentId, automata::ModeId>> context;
    struct Edge {
      std::vector<automata::ModeId> modes;  ///< by component
      std::vector<Age> ages;
    };
    std::vector<Edge> edges;
  };

  StrategyEdges(std::string goal, std::vector<Group> groups) : goal_(std::move(goal)), groups_(std::move(groups)) {}

  /// Of groups of which no edge fits nothing is known.
  [[nodiscard]] StrategyPosition to(const automata::Modes& modes) const;

 private:
  std::string goal_;
  std::vector<Group> groups_;
};

}  // namespace rmpl::runtime
