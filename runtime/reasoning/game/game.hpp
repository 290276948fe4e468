// The game of the executive against nature (semantics 5): nodes, actions and outcomes, explored forward.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/hash.hpp"
#include "runtime/reasoning/game/age.hpp"
#include "runtime/reasoning/game/arena.hpp"
#include "runtime/reasoning/game/cost.hpp"

namespace rmpl::runtime {

/// All that can come of a start under any actions.
///
/// An action is a *wait* where no component has to leave its mode at once: it is held until something happens. So all
/// outcomes of a wait change something. Outcomes of one action fall into classes by the timed transitions that come in
/// them: nature chooses the class, chance what is left.
class Game {
 public:
  /// What is known of the past.
  enum class Memory {
    modes,  ///< the modes: a timed transition that is enabled may come in any cycle, and a bounded one comes some day
    ages    ///< an interval for the age of each mode, of each by itself
  };
  struct Outcome {
    std::uint32_t node;
    std::uint32_t choice;  ///< the class, from 0 for each action
    StepCost cost;
    std::int64_t soonest;       ///< ticks
    bool irreversible = false;  ///< some step of it cannot be undone, licensed or not
    bool coincides = false;     ///< something timed comes in the very cycle of an action
  };
  struct Edge {
    std::uint32_t action;  ///< as the arena numbers them
    std::uint32_t off;     ///< controls off idle
    std::uint32_t first;   ///< of its outcomes
    std::uint32_t count;   ///< 0: nothing ever happens
    std::uint32_t choices = 0;
    std::uint32_t entry = 0;  ///< its place among the actions of the position
    bool waits = false;       ///< else it takes one cycle
    bool at_once = false;     ///< something comes in the next cycle
    bool dead = false;        ///< all that could come of it is excluded: it is no action
    bool ends = false;        ///< of a wait: some bound ends it
    bool permitted = true;    ///< else it is never sent: it does or risks harm
    std::uint64_t takes = 0;  ///< harm in the step itself, what the model excludes among it
  };
  struct Node {
    std::uint32_t position;
    std::uint32_t first;     ///< of its edges; the first is the one to rest with
    std::uint32_t count;     ///< 0: nothing is possible here
    std::uint64_t harm = 0;  ///< what may come from here if the executive rests
    bool explored = true;    ///< else nothing is possible here, as far as is looked at
  };

  struct Limits {
    std::size_t nodes, outcomes;
    /// Of the same modes so many ages are looked at, as they are met; no strategy relies on others. What a wait costs
    /// is then its longest time, however much of that has been charged.
    std::optional<std::size_t> alike = std::nullopt;
  };
  /// Explores from `start`, which is possible. `cycle`: of the executive; 0 where actions take no time. `ages`: of the
  /// arena's components, where they are known; else nothing is but that nothing is overdue that resting enables.
  Game(Arena& arena, Memory memory, automata::Ticks cycle, Limits limits, const automata::Modes& start,
       const std::optional<std::vector<Age>>& ages = std::nullopt);

  /// Not all was explored, as there are too many nodes, actions, outcomes or harms: nothing is known.
  [[nodiscard]] bool too_large() const { return too_large_; }
  /// It is too large for its limits of nodes and outcomes.
  [[nodiscard]] bool beyond_limits() const { return beyond_limits_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] const Position& position(std::uint32_t node) const { return arena_.at(nodes_[node].position); }
  /// By component of the arena; empty where modes alone are known.
  [[nodiscard]] const std::vector<Age>& ages(std::uint32_t node) const { return *ages_[node]; }
  [[nodiscard]] Arena& arena() const { return arena_; }
  /// What a bit of harm stands for: a step of one component, from a mode to another; or modes of several components
  /// that the model excludes, then `excluded`.
  struct HarmOf {
    std::vector<std::pair<automata::ComponentId, automata::ModeId>> modes;  ///< of a step: before it and after it
    bool excluded;
  };
  [[nodiscard]] HarmOf harm_of(unsigned bit) const;
  /// What an edge does or risks that resting in its node does not, as bits.
  [[nodiscard]] std::uint64_t added_harm(std::uint32_t node, const Edge& edge) const;
  [[nodiscard]] Memory memory() const { return memory_; }
  /// Whether actions take time; else a strategy may not live on actions alone.
  [[nodiscard]] bool actions_take_time() const { return memory_ == Memory::modes || cycle_.count > 0; }
  /// The node of these modes of which nothing else is known, or these ages; none where the game does not come there.
  [[nodiscard]] std::optional<std::uint32_t> find(const automata::Modes& modes,
                                                  const std::optional<std::vector<Age>>& ages = std::nullopt) const;
  /// Whether no more is known of ages in the node than in any of its modes.
  [[nodiscard]] bool is_fresh(std::uint32_t node) const;

 private:
  using Harm = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  ///< a step, or modes that exclude each other
  /// Stands behind modes that exclude each other, which tells them from a step.
  static constexpr std::pair<std::uint32_t, std::uint32_t> exclusion{~std::uint32_t{0}, ~std::uint32_t{0}};
  static constexpr std::uint64_t unknown_harm = std::uint64_t{1} << 63;  ///< of a node that is not explored
  struct Key {
    std::uint32_t position;
    std::vector<Age> ages;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };
  struct Choice;
  struct Turn;

  void explore(Limits limits, Key start);
  /// Of a position of which these ages are known, or nothing.
  [[nodiscard]] Key key_of(std::uint32_t position, const std::optional<std::vector<Age>>& ages) const;
  [[nodiscard]] std::optional<std::uint32_t> position_of(const automata::Modes& modes) const;
  void add_edge(std::uint32_t node, const Position& position, const Position::Action& action);
  bool list_choices(std::uint32_t node, const Position& position, const Position::Action& action, Turn& turn);
  void add_outcome(std::uint32_t node, const Position& position, const Turn& turn, Edge& edge);
  std::uint32_t node_of(Key key);
  std::uint32_t unexplored(std::uint32_t position);
  void find_caps();
  void cap(Key& key) const;
  std::uint64_t bit_of(Harm harm);
  void spread_harm();
  void forbid();

  Arena& arena_;
  Memory memory_;
  automata::Ticks cycle_;
  AgeRules rules_;
  std::vector<std::vector<std::int64_t>> caps_;  ///< by member, by mode: the age from which on nothing changes
  std::vector<Node> nodes_;
  std::vector<const std::vector<Age>*> ages_;  ///< by node; they live in the keys
  std::vector<Edge> edges_;
  std::vector<Outcome> outcomes_;
  std::unordered_map<Key, std::uint32_t, KeyHash> numbers_;
  std::map<Harm, std::uint32_t> harms_;
  std::map<std::vector<std::pair<std::size_t, std::uint32_t>>, std::uint32_t> classes_;  ///< of the present edge
  std::optional<std::size_t> most_alike_;
  std::vector<std::size_t> alike_;                     ///< by position: how many ages were met, where few are kept
  std::map<std::uint32_t, std::uint32_t> unexplored_;  ///< by position
  std::deque<std::vector<Age>> unknown_ages_;          ///< of nodes that are not explored
  bool too_large_ = false;
  bool beyond_limits_ = false;
};

}  // namespace rmpl::runtime
