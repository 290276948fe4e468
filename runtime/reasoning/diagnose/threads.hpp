// What the threads of a model program may be in at one moment, of which nothing is known that was before: in a mixed
// plant a thread is a component, or a model program (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/phca.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::runtime {

/// A part of the program that no arc leads into or out of, with the markings of its primitive locations that it can
/// come to, whatever the others tell and is commanded.
struct Thread {
  std::vector<automata::Marking> likely;  ///< those without an improbable draw, ascending
  struct Fault {
    automata::Marking marked;
    double probability;  ///< of the improbable draws on the likeliest way there
  };
  std::vector<Fault> faults;  ///< the others, ascending
};

/// No more markings of one thread, and no more ways for the guards of all to hold, are looked at.
constexpr std::size_t most_thread_markings = 4096;
constexpr std::size_t most_valuations = std::size_t{1} << 16;

/// In order of their first location, without those that never mark anything. Guards may hold and fail in every way that
/// some store allows in which what the thread tells itself holds. Throws base::LimitError.
std::vector<Thread> threads_of(const automata::ModelProgram& program);

}  // namespace rmpl::runtime
