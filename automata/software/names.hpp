// Names for threads and markings, in the words of the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/phca.hpp"
#include "automata/software/threads.hpp"

namespace rmpl::automata {

/// The innermost definitions that a marking is in, as an identifier; of nothing, `ended`.
std::string name_of(const ModelProgram& program, const Marking& marking);

/// A name for each marking of a thread, each once: the innermost definitions that it is in; where that is not enough,
/// what it tells; then a number. The marking of nothing is `ended`. All are identifiers.
std::vector<std::string> names_of_markings(const ModelProgram& program, const Thread& thread);

/// A name for each thread of an instance: that of the instance, if it has one thread; else that and the definition that
/// the thread begins with. Without an instance that of the program, or of the definition. None is the name of a
/// variable.
std::vector<std::string> names_of_threads(const ModelProgram& program, const std::vector<Thread>& threads,
                                          const std::string& instance, const Variables& variables);

}  // namespace rmpl::automata
