// How likely it is that a formula comes to hold, and how long that takes in the mean (docs/safety.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/program.hpp"
#include "automata/step/plant_step.hpp"
#include "verifier/markov/enclosure.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

struct ProbabilityQuestion {
  automata::Formula target;
  bool entailed = false;                  ///< it holds where the store implies it, not where the store allows it
  std::optional<automata::Ticks> period;  ///< none: dense time
  std::optional<automata::Ticks> within;  ///< none: ever
  std::optional<unsigned> faults;         ///< runs with more are not followed
  Commands commands = Commands::one;      ///< of a plant alone
  std::vector<automata::Assignment> from;
  bool mean_time = false;
  std::size_t points = 0;  ///< of a curve, from 0 to `within`; 0: none
  double precision = 1e-6;
  bool least = true, greatest = true;  ///< which of them are asked for, where something is free to choose
};

/// The mean time in seconds.
struct MeanTime {
  Enclosure seconds;
  bool infinite = false;
};

/// At a time: the probability so far.
struct CurvePoint {
  automata::Ticks time;
  Enclosure probability;
};

/// For one way to choose.
struct Likelihood {
  Enclosure probability;
  std::vector<CurvePoint> curve;
  std::optional<MeanTime> mean_time;
};

struct ProbabilityAnswer {
  std::optional<Likelihood> only;             ///< where nothing is free to choose
  std::optional<Likelihood> least, greatest;  ///< else, those that were asked for
  std::optional<unsigned> faults_at_most;     ///< runs with more were not followed
  bool startless = false;                     ///< no initial state is possible
  bool precise = true;                        ///< the bounds are as near to each other as was asked for
  std::optional<Limit> limit;                 ///< which ended the search: there are no bounds
  Progress progress;
};

/// Of a plant under free commands. Throws base::InputError where the question has no answer in this reading of time.
ProbabilityAnswer probability(automata::PlantStep& step, const ProbabilityQuestion& question, const Limits& limits);
/// Of a program, bound to the plant, with its plant; sampled time. A run ends with the program.
ProbabilityAnswer probability(const automata::Program& program, automata::PlantStep& step,
                              const ProbabilityQuestion& question, const Limits& limits);

}  // namespace rmpl::verifier
