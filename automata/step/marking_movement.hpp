// One step out of one marking, in the making: effects of arcs, and which draws have to be looked at together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "automata/step/marking_rules.hpp"

namespace rmpl::automata {

class MarkingMovement {
 public:
  MarkingMovement(const MarkingRules& rules, MarkingRules::Holds holds);

  /// The program begins.
  void start();
  /// A primitive location that was marked draws and takes its arcs. Before `moves`, once.
  void leave(LocationId location);
  MarkingMoves moves();

 private:
  using RuledArc = MarkingRules::RuledArc;

  /// What some arcs bring about. Of composites only those are told whose ending has a consequence.
  struct Effect {
    Marking marked;  ///< primitive locations, ascending
    Marking kept;    ///< composites that an arc from inside leads into, ascending: they do not end
    Marking active;  ///< composites that something in is marked, or counts as started, ascending: they may end
    auto operator<=>(const Effect&) const = default;
  };
  struct Chance {
    double probability = 0;
    unsigned improbable = 0;  ///< draws, as few as will do
  };
  /// Several ways, of which one is drawn; merged where they come to the same.
  using Ways = std::map<Effect, Chance>;

  static void unite(Marking& into, const Marking& other);
  static Marking without(const Marking& from, const Marking& other);
  static void unite(Effect& into, const Effect& other);
  static void add(Ways& ways, Effect effect, Chance chance);

  bool holds(std::size_t condition);
  bool hold(const std::vector<std::size_t>& guard);
  /// Whether something that holds the location fails, so that it is left without taking an arc.
  bool left(LocationId location);
  /// Whether an arc leaves the composite, if it ends.
  bool matters(LocationId composite);
  void take(const RuledArc& arc, Effect& effect);
  void add_arcs(const std::vector<RuledArc>& arcs, Effect& effect);
  void activate(LocationId location, Effect& effect);
  Effect ending(LocationId composite);
  void add_draw(Ways ways);
  void settle_common(Ways& ways);
  void settle_composites();
  void join_overlapping();
  std::vector<MarkingOutcome> turn_out(const std::vector<std::size_t>& draws, const Marking& composites);

  const MarkingRules& rules_;
  MarkingRules::Holds holds_;
  std::vector<signed char> known_;    ///< per condition: whether it holds, or -1
  std::vector<signed char> matters_;  ///< per location, likewise
  Effect certain_;
  std::vector<Ways> draws_;        ///< those that are not certain
  Marking undecided_;              ///< composites whose end is up to draws, falling
  std::vector<Effect> endings_;    ///< of those
  std::vector<std::size_t> part_;  ///< per draw, then per undecided composite: the part that it belongs to
};

}  // namespace rmpl::automata
