// Another program, run to its end: what it prints, and how it ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rmpl::tools {

struct ChildCall {
  std::vector<std::string> arguments;  ///< the program first: a path, or a name that PATH knows
  std::string input = {};              ///< its standard input
  std::optional<std::chrono::duration<double>> time_limit = {};
  std::function<bool()> interrupted = {};  ///< asked now and then; none: never
};

struct ChildEnd {
  std::optional<int> status;  ///< its exit code; nothing where a signal ended it
  int signal = 0;             ///< that ended it
  bool late = false;          ///< it was asked to end, as its time was over
  std::string output;         ///< its standard output
  std::string errors;         ///< its standard error
};

/// Runs a program. Where its time is over, or after an interruption, it is asked to end (SIGTERM), and made to five
/// seconds later. Nothing where there is no such program. Throws base::InputError where the system gives no process.
/// May be called from several threads.
std::optional<ChildEnd> run_child(const ChildCall& call);

}  // namespace rmpl::tools
