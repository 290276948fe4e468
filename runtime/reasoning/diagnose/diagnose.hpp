// Diagnosis of one snapshot: livingstone's mode identification without a history.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

struct DiagnoseOptions {
  std::size_t k = 10;  ///< how many of the leading diagnoses; without effect where `all_minimal`
  /// None that is more than so many times less likely than the best; at least 1. Without effect where `all_minimal`.
  double ratio = std::numeric_limits<double>::infinity();
  bool all_minimal = false;                                          ///< instead every diagnosis with the fewest faults
  bool first = false;                                                ///< with `all_minimal`: only one of them
  bool count_only = false;                                           ///< with `all_minimal`: only how many there are
  std::size_t candidates = std::numeric_limits<std::size_t>::max();  ///< how many may be checked
};

/// Components that are faulty, each in one fault mode; all others are in some nominal mode.
struct Diagnosis {
  /// The prior of the assignment, a product over all components. A component is in a fault mode if it began there,
  /// with the initial probability, or if it began in no fault mode and came to this one, with the probability of the
  /// likeliest way of fault transitions from a nominal mode (a rate counts over one second); the nominal modes together
  /// have the rest. It is not divided by the probability of the observations.
  double probability = 0;
  double log_probability = 0;  ///< its natural logarithm: of thousands of components the product may underflow
  std::vector<std::pair<automata::ComponentId, automata::ModeId>> faults;  ///< in order of component
};

struct Diagnoses {
  std::vector<Diagnosis> diagnoses;        ///< most probable first, ties in order of state, nominal before faulty
  boost::multiprecision::cpp_int count;    ///< how many there are; with `count_only` they are not listed
  std::optional<std::size_t> cardinality;  ///< the fewest faults of a diagnosis here; nothing where there is none
  std::size_t checked = 0;                 ///< candidates checked
  bool cut = false;                        ///< the limit of candidates ended the search early
  double seconds = 0;                      ///< wall-clock time, the one thing here that differs from run to run
};

/// The fault assignments that, with some nominal mode for every other component and the interconnections, are
/// consistent with the observations (of any attributes). The leading ones by prior, where an assignment with prior 0
/// is none; or with `all_minimal` all those of the least number of faults, each once, whatever their priors. Where the
/// plant is a circuit with all inputs observed (see `circuit_of`), the latter are found by cores and sections, which
/// counts sets far too large to list; there one with the fewest faults, proved, is also the answer to `k` = 1 where all
/// gates are equally likely to fail, since it is then one of the most probable.
Diagnoses diagnose(const automata::Plant& plant, const automata::Observation& observation,
                   const DiagnoseOptions& options);

}  // namespace rmpl::runtime
