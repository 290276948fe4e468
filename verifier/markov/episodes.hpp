// What begins again and again is followed once.
//
// What follows a point depends on what clocks read, not on when that is. Where clocks begin to run, each run that comes
// there goes on alike, whenever it does. So an *episode*, from there on until no clock runs, or clocks begin to run
// anew, is followed a single time, from a probability of 1; what it leads to is summed up over the times at which runs
// came to its start (a Markov renewal equation; D. Cox: The analysis of non-Markovian stochastic processes by the
// inclusion of supplementary variables, 1955; H. Choi, V. Kulkarni, K. Trivedi: Markov regenerative stochastic Petri
// nets, 1994).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "verifier/markov/front.hpp"

namespace rmpl::verifier {

/// An episode, as far as it has been followed.
class Episode {
 public:
  /// What a step of it leads to, of all that began.
  struct Stage {
    std::vector<std::pair<std::uint32_t, Enclosure>> ends;  ///< where it ends, as a position in `exits`
    Enclosure wanted;
    Real unknown = 0;
  };

  /// From a point, as it is at step 0, for so many steps. Keeps references.
  Episode(Process& process, RowMemory& rows, const Point& start, Units last, const Tolerance& tolerance, Meter& meter);

  /// After so many steps; it is followed that far.
  const Stage& after(Units steps);
  /// At most what is unknown after so many steps, of all steps together.
  Real unknown_within(Units steps);
  /// Whether it is over by then.
  [[nodiscard]] bool is_over_by(Units steps) const {
    return front_.points().empty() && steps >= static_cast<Units>(stages_.size());
  }
  /// Where it ends: points where no clock runs, or where clocks begin to, as they are at step 0.
  [[nodiscard]] const std::vector<Point>& exits() const { return exits_.points(); }

 private:
  void go_on();

  Process& process_;
  Meter& meter_;
  Front front_;
  std::vector<Stage> stages_;  ///< from after 0 steps on
  PointNumbers exits_;
};

/// Episodes that have been begun, beside a front that is followed step by step.
class Episodes {
 public:
  Episodes(Process& process, RowMemory& rows, Units last, const Tolerance& tolerance, Meter& meter)
      : process_(process), rows_(rows), last_(last), tolerance_(tolerance), meter_(meter) {}

  /// Whether what has come to the point at that step is followed here: where runs come to its start in one step after
  /// the other. Clocks that begin to run now and then are followed best one by one, many steps at once.
  bool takes(const Point& point, const Enclosure& mass, Units now, Front& front);
  /// What comes of all that goes on here in the step that ends at `now`.
  void leave(Units now, Front& front);
  [[nodiscard]] bool none_goes_on() const { return going_on_ == 0; }

 private:
  struct Begun {
    Units last = 0;                                     ///< when runs came to its start
    std::unique_ptr<Episode> episode;                   ///< null: nothing has been taken yet
    Real all = 0;                                       ///< at most what has been taken
    Real foreseen = 0;                                  ///< what the episode is fine enough for
    std::vector<std::pair<Units, Enclosure>> going_on;  ///< when that began, and how much
  };
  void follow_finer(const Point& start, Begun& begun, Units now, Front& front);
  void leave(Begun& begun, Units now, Front& front);

  Process& process_;
  RowMemory& rows_;
  Units last_;
  Tolerance tolerance_;
  Meter& meter_;
  PointNumbers starts_;
  std::vector<Begun> begun_;  ///< by start
  std::size_t going_on_ = 0;
  std::vector<Enclosure> sums_;  ///< by exit, kept for its memory
};

}  // namespace rmpl::verifier
