// The positions of the game of plans, and what each action may bring there: without bounds, modes alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "tests/reference/game_step.hpp"

namespace rmpl::reference {

using Node = std::size_t;

/// A length of time; waits that nothing bounds count apart, before ticks.
struct Span {
  std::size_t unbounded = 0;
  std::int64_t ticks = 0;
  auto operator<=>(const Span&) const = default;
};

/// One way in which an action may turn out.
struct Result {
  Node to;
  std::int64_t soonest = 0;  ///< ticks
  Span latest;
  /// What nature chose: the timed transitions that fire, by component and branch. What is left then is chance. Without
  /// bounds it is chance, too, what ends a wait.
  std::vector<std::pair<std::size_t, std::uint32_t>> chosen;
};

/// An action in a node. One that moves nothing at once is a wait: it is held for as long as nothing happens.
struct Turn {
  bool waits = false;
  bool ends = true;     ///< a wait that must end; else nature may have it last for ever
  bool dead = false;    ///< nothing can come of it: it is no action
  bool at_once = true;  ///< a result comes in the next cycle
  std::vector<Result> results;
  /// What the outcomes of the components, each taken by itself, contradict.
  std::vector<Nogood> contradicted;
};

/// Nodes have numbers, in the order in which they are met. Keeps a reference to the step.
class Arena {
 public:
  explicit Arena(GameStep& step) : step_(step) {}
  virtual ~Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  [[nodiscard]] GameStep& step() const { return step_; }
  /// Where a strategy starts of which the modes alone are known. They are possible.
  virtual Node start(const automata::Modes& modes) = 0;
  [[nodiscard]] virtual const automata::Modes& modes(Node node) const = 0;
  /// Whether actions take time; else no strategy lives on actions alone.
  [[nodiscard]] virtual bool actions_take_time() const { return true; }
  /// Nothing where the action contradicts the model.
  virtual std::optional<Turn> turn(Node node, GameStep::Action action) = 0;

 private:
  GameStep& step_;
};

/// When an exit may be taken, in cycles since its mode was entered (semantics 3): not before the cycle `first`, which
/// is at least 1, and no later than `last`, but for one that becomes enabled after that, which is taken in the next
/// cycle.
struct Window {
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max() / 4;
  std::int64_t first = 1;
  std::int64_t last = never;
};
Window window_of(const automata::Timing& timing, std::int64_t cycle);

/// A node is the modes. A timed transition that is enabled may come in any cycle, and comes some day. A wait takes, at
/// worst, until the least upper bound of what is enabled.
class ModeArena final : public Arena {
 public:
  /// `cycle` in ticks, above 0.
  ModeArena(GameStep& step, std::int64_t cycle) : Arena(step), cycle_(cycle) {}

  Node start(const automata::Modes& modes) override { return number(modes); }
  [[nodiscard]] const automata::Modes& modes(Node node) const override { return *nodes_[node]; }
  std::optional<Turn> turn(Node node, GameStep::Action action) override;

 private:
  Node number(const automata::Modes& modes);

  std::int64_t cycle_;
  std::map<automata::Modes, Node> numbers_;
  std::vector<const automata::Modes*> nodes_;
};

}  // namespace rmpl::reference
