// The fault tree of a formula: minimal cut sets with probabilities, the top event, and which faults matter most.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/markov/probability.hpp"
#include "verifier/property/fault.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

struct FaultTreeQuestion {
  automata::Formula top;
  std::optional<automata::Ticks> period;  ///< none: dense time
  std::optional<automata::Ticks> within;  ///< by when; none: no probabilities are told
  unsigned order = 2;                     ///< of a plant with dynamics: sets of no more faults
  std::optional<std::size_t> listed;      ///< so many sets, the likeliest; none: all
  Commands commands = Commands::one;
  std::vector<automata::Assignment> from;
};

/// A fault of the tree, and how it is drawn.
struct TreeEvent {
  Fault fault;
  automata::Weight weight;  ///< none: it hangs on guards, and has no probability of its own
  bool once = false;        ///< its probability is drawn once, not in each step
  std::optional<Enclosure> probability;
  /// Where the tree is exact: how much the top event's probability grows from the fault's absence to its presence
  /// (Birnbaum), by what part it falls without the fault (Fussell-Vesely), by what factor it grows with the fault (risk
  /// achievement worth) and falls without it (risk reduction worth; none: to 0).
  struct Importance {
    double birnbaum = 0, fussell_vesely = 0, achievement = 0;
    std::optional<double> reduction;
  };
  std::optional<Importance> importance;
};

struct TreeSet {
  std::vector<std::size_t> events;  ///< positions in the tree, ascending
  std::optional<Enclosure> probability;
};

struct FaultTree {
  std::vector<TreeEvent> events;
  std::vector<TreeSet> sets;     ///< those that are listed
  std::vector<Real> by_order;    ///< how many minimal sets there are of 0, 1, 2 … faults
  bool exact = false;            ///< the plant is a fault tree, and these are all sets
  bool monotone = true;          ///< else the sets are those of a formula that failures only make true
  std::optional<Enclosure> top;  ///< its probability, where the plant is a fault tree
  std::optional<Limit> limit;
  Progress progress;
};

/// By decision diagrams where the plant has no dynamics (static_tree.hpp); else by the search for cut sets. Throws
/// base::InputError as `check` does.
FaultTree fault_tree(automata::PlantStep& step, const FaultTreeQuestion& question, const Limits& limits);

/// The probability that a formula comes to hold, where the plant is a fault tree of it that failures only make true;
/// nothing where it is not, or where more is asked.
std::optional<ProbabilityAnswer> static_probability(automata::PlantStep& step, const ProbabilityQuestion& question,
                                                    const Limits& limits);

}  // namespace rmpl::verifier
