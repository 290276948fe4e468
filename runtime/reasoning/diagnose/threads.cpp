// Markings by the ways that lead there.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/threads.hpp"

#include <algorithm>

#include "automata/software/threads.hpp"

namespace rmpl::runtime {

std::vector<JudgedThread> judged_threads(const automata::ModelProgram& program) {
  std::vector<JudgedThread> result;
  for (const automata::Thread& thread : automata::threads_of(program)) {
    JudgedThread& judged = result.emplace_back();
    for (const automata::ThreadMarking& marking : thread.markings) {
      if (!marking.possible) continue;
      if (marking.way == 1) {
        judged.likely.push_back(marking.marked);
      } else {
        judged.faults.push_back({marking.marked, marking.way});
      }
    }
    std::sort(judged.likely.begin(), judged.likely.end());
    std::sort(judged.faults.begin(), judged.faults.end(),
              [](const auto& a, const auto& b) { return a.marked < b.marked; });
  }
  return result;
}

}  // namespace rmpl::runtime
