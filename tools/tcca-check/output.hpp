// What the commands of tcca-check print.
// SPDX-License-Identifier: MIT
#pragma once

#include <iostream>

#include "base/error.hpp"
#include "tools/tcca-check/command_line.hpp"

namespace rmpl::verifier {

/// Ends what went to standard output. Throws base::InputError where it cannot be written.
inline void finish_output() {
  if (!std::cout.flush()) throw base::InputError("standard output: cannot be written");
}

/// Writes an answer in the form that was asked for, by the function that makes that form.
template <class Text, class Json, class Junit>
void print(const CommandLine& line, const Text& text, const Json& json, const Junit& junit) {
  switch (line.format) {
    case CommandLine::Format::text:
      std::cout << text();
      return;
    case CommandLine::Format::json:
      std::cout << json().dump(2) << '\n';
      return;
    case CommandLine::Format::junit:
      std::cout << junit();
      return;
  }
}

/// Says that no initial state is possible; `consequence` is what follows, such as "nothing is reachable".
inline void warn_of_no_start(const char* consequence) {
  std::cerr
      << "tcca-check: warning: no initial state is possible: the initial modes contradict the interconnections, so "
      << consequence << '\n';
}

}  // namespace rmpl::verifier
