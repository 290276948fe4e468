// What the threads of a model program may be in at one moment, of which nothing is known that was before (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/phca.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::runtime {

/// The markings of a thread (automata/software/threads.hpp), of its primitive locations, that it can come to.
struct JudgedThread {
  std::vector<automata::Marking> likely;  ///< those without an improbable draw, ascending
  struct Fault {
    automata::Marking marked;
    double probability;  ///< of the improbable draws on the likeliest way there
  };
  std::vector<Fault> faults;  ///< the others, ascending
};

/// In the order of the threads. Throws base::LimitError.
std::vector<JudgedThread> judged_threads(const automata::ModelProgram& program);

}  // namespace rmpl::runtime
