// Commands that bring a model program to what a goal asks for (semantics 8, "Flown by a control program").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/step/marking_step.hpp"
#include "base/bounded_cache.hpp"

namespace rmpl::runtime {

/// What to do next.
struct MarkingMove {
  enum class Kind {
    done,     ///< the goal is entailed
    step,     ///< `command`, which may be idle, is the next of as few as lead there
    failure,  ///< improbable draws alone lead there
    nowhere,  ///< nothing does
    given_up  ///< too many markings were looked at
  };
  Kind kind = Kind::done;
  automata::Command command;
};

/// Plans over the markings of one program, or of one group of its threads. Keeps a reference to it.
class MarkingPlanner {
 public:
  /// Every control of the program has an idle value.
  explicit MarkingPlanner(const automata::ModelProgram& program);

  /// From a marking, given by its primitive locations, to one whose store entails all of `goal`. Draws are taken to
  /// come out likely: improbable ones are failures, which nothing is planned on; of several likely outcomes any may be
  /// hoped for. Fewest steps first, then fewest values off idle, then what is commanded sooner, then the order of
  /// controls and values. In each step any combination of commands is free where there are no more than 256, else one
  /// control at a time. Breadth-first; given up after 100,000 markings, or 250,000 steps.
  MarkingMove next(const automata::Marking& from, std::span<const automata::Assignment> goal);

  /// Whether what the last search found, the goal marking or the one that it set out from, goes on entailing the goal
  /// with all controls idle, as long as draws come out likely. False where that would take too long to find out.
  bool lasts(std::span<const automata::Assignment> goal);
  /// Whether the store of a marking entails an assignment.
  bool entails(const automata::Marking& marking, automata::Assignment wanted) {
    return step_.entails(step_.number(marking), std::span(&wanted, 1));
  }
  /// The idlest command that a marking permits, of those that differ from this one in idle values alone: itself where
  /// it is permitted. Nothing where there is none.
  std::optional<automata::Command> permitted(const automata::Marking& from, const automata::Command& command);
  /// How many markings the last question took; none where its answer was remembered.
  [[nodiscard]] std::size_t looked_at() const { return nodes_.size(); }
  /// A search gives up beyond so many markings, and so many steps that were tried.
  static constexpr std::size_t most_markings = 100'000, most_steps = 250'000;

 private:
  using Number = automata::MarkingStep::Number;
  /// An answer, and where the way ends.
  struct Known {
    MarkingMove move;
    automata::Marking found;
  };
  /// A marking, and the first command of the way to it.
  struct Node {
    Number marking;
    std::size_t first;  ///< of `commands_`
    std::size_t busy;   ///< values off idle on the way
  };

  [[nodiscard]] bool given_up() const { return nodes_.size() > most_markings || steps_ > most_steps; }
  enum class Draws { likely, any };
  MarkingMove searched(Number start, std::span<const automata::Assignment> goal, Draws draws);
  [[nodiscard]] bool better(const Node& a, const Node& b) const;
  template <class Visit>
  void each_way(Number from, const automata::Command& command, Draws draws, const Visit& visit);
  void expand(std::size_t node, bool start, Draws draws);
  void add(const Node& node);

  automata::MarkingStep step_;
  /// Those that are free, the idlest first, with how many values are off idle.
  std::vector<std::pair<std::size_t, automata::Command>> commands_;
  std::vector<Node> nodes_;
  std::vector<std::optional<std::size_t>> at_;  ///< per number: its node
  std::size_t steps_ = 0;                       ///< that the search has tried
  std::size_t layer_ = 0;                       ///< where the nodes of the next layer begin
  Number found_ = 0;                            ///< by the last search
  base::BoundedCache<std::vector<std::uint64_t>, Known> known_{4096};
};

}  // namespace rmpl::runtime
