// Diagnosis of one moment of a model program: which improbable draws explain it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "automata/phca.hpp"
#include "automata/state.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::runtime {

struct ModelDiagnosis {
  double probability = 1;                    ///< of the improbable draws that it takes, on the likeliest ways
  std::vector<automata::Marking> faults;     ///< of the threads that took one: what is marked, primitive locations
  std::vector<automata::Assignment> values;  ///< that follow, with what is seen, by variable
};

struct ModelDiagnoses {
  std::vector<ModelDiagnosis> diagnoses;  ///< best first; ties in order of threads, likely before not
  bool starts = true;                     ///< false: no start of the program is consistent
  std::size_t checked = 0;                ///< candidates
};

/// The `k` best assignments of markings to threads (threads.hpp) that are consistent with what is seen, of any
/// variables, and are not more than `ratio` times less likely than the best. Markings without an improbable draw count
/// as one, as the nominal modes of a component do: which of them it is, is left to the store. Throws base::LimitError.
ModelDiagnoses diagnose(const automata::ModelProgram& program, const automata::Observation& observation, std::size_t k,
                        double ratio = std::numeric_limits<double>::infinity());

}  // namespace rmpl::runtime
