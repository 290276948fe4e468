// The threads of a model program, each with the markings that it can come to and the steps between them (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "automata/step/program_rules.hpp"

namespace rmpl::automata {

/// Where a step may lead: a marking, by its position in its thread.
struct ThreadOutcome {
  std::size_t target = 0;
  double probability = 0;
  double rarity = 1;  ///< the probability of its improbable draws, of branches that others are likelier than; 1: none
};

/// The outcomes of a step where conditions are as told: each is one of the program's, or the opposite of one. The steps
/// out of a marking exclude each other, and one of them applies to every store.
struct ThreadStep {
  std::vector<Condition> under;
  std::vector<ThreadOutcome> outcomes;  ///< by target; probabilities sum to 1
};

struct ThreadMarking {
  Marking marked;        ///< primitive locations
  bool possible = true;  ///< else what it tells contradicts itself, or the constraints for the whole model
  double way = 0;        ///< of the likeliest way there, the probability of its improbable draws; 1: it has none
  std::vector<ThreadStep> steps;
};

/// A part of the program that no arc leads into or out of, with what it can come to whatever the others tell and is
/// commanded.
struct Thread {
  LocationId first;                     ///< the first of its locations
  std::vector<ThreadMarking> markings;  ///< in the order in which they are met; the start markings come first
  std::vector<ThreadOutcome> start;     ///< by target
};

/// No more markings of one thread, and no more ways for the guards of all to hold, are looked at.
constexpr std::size_t most_thread_markings = 4096;
constexpr std::size_t most_valuations = std::size_t{1} << 16;

/// In order of their first location, without those that never mark anything. Guards may hold and fail in every way that
/// some store allows in which what the thread tells itself holds, with the constraints of the program. An outcome that
/// is not possible is left out, the others are scaled to 1; where none is, all stay. Throws base::LimitError.
std::vector<Thread> threads_of(const ModelProgram& program);

/// What a marking tells, all at once.
Formula told(const ModelProgram& program, const Marking& marking);

/// Finds the likeliest ways to the markings of a thread by the steps that it has; 0 where there is none.
void find_ways(Thread& thread);

}  // namespace rmpl::automata
