// tcca-check: can a plant get there, can it avoid that, does it answer in time, and what becomes of a program on it.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/timed_formula.hpp"

namespace {

constexpr const char* main_notes =
    R"(Exit status: 0 holds or reachable, 1 violated or unreachable, even if others are undecided, 2 the command
line or an input is wrong, 3 undecided: a limit or a signal ended the search, 4 an internal error, and nothing is claimed.)";

}  // namespace

int main(int count, char** arguments) {
  using namespace rmpl::tools;
  Program program("tcca-check", RMPL_VERSION,
                  "Checks what a plant model (TCCA) can do in time, by itself or under a control program (RMPL).",
                  main_notes);
  add_reachability(program);
  add_safety(program);
  add_response(program);
  add_stuck(program);
  add_program(program);
  add_check(program);
  add_probability(program);
  add_fault_tree(program);
  add_fmea(program);
  add_export(program);
  const std::vector<std::string> joined = with_joined_times(count, arguments);
  std::vector<const char*> words;
  for (const std::string& word : joined) words.push_back(word.c_str());
  return program.run(static_cast<int>(words.size()), words.data());
}
