// Messages name what was found in place of what was expected.
// SPDX-License-Identifier: MIT
#include "compiler/session/contents.hpp"

#include <algorithm>
#include <type_traits>

#include "automata/software/software_in.hpp"
#include "base/error.hpp"

namespace rmpl::compiler {

namespace {

/// `'S' is a model program`, of the first thing that an input has in place of what was expected; empty where it has
/// none.
std::string found_in(const automata::Document& document, bool program_expected) {
  if (!document.models.empty()) {
    return "'" + document.models.front().name + "' is a model program";
  }
  if (!program_expected && !document.programs.empty()) {
    return "'" + document.programs.front().name + "' is a control program";
  }
  if (program_expected && !document.plants.empty()) return "'" + document.plants.front().name + "' is a plant";
  return {};
}

/// The only one of some things in an input.
template <class Things>
const auto& only(const Things& things, const automata::Document& document, const std::string& paths, const char* what,
                 const char* ending) {
  if (things.size() == 1) return things.front();
  const std::string expected = std::string("expected one ") + what + ", as in a " + ending + " file";
  if (things.empty()) {
    const std::string found = found_in(document, std::is_same_v<Things, std::vector<automata::Program>>);
    throw base::InputError(paths + ": " + expected + ", and " + (found.empty() ? "there is none in it" : found));
  }
  throw base::InputError(paths + ": " + expected + ", and there are " + std::to_string(things.size()));
}

}  // namespace

const automata::Plant& only_plant(const automata::Document& document, const std::string& paths) {
  return only(document.plants, document, paths, "plant", ".tcca");
}

const automata::Program& only_program(const automata::Document& document, const std::string& paths) {
  return only(document.programs, document, paths, "control program", ".rmpl");
}

const automata::ModelProgram& only_model_program(const automata::Document& document, const std::string& paths) {
  return only(document.models, document, paths, "model program", ".rmpl");
}

bool is_model_program(const automata::Document& document) {
  // A plant that a scenario made of it has its threads alone.
  return !document.models.empty() &&
         std::all_of(document.plants.begin(), document.plants.end(), automata::is_software_alone);
}

void refuse_start(const automata::ModelProgram& program, const std::string& paths) {
  throw base::InputError(paths + ": no start is consistent: what the start locations of '" + program.name +
                         "' tell contradicts itself, or the constraints for the whole model");
}

std::vector<automata::Assignment> each_once(std::vector<automata::Assignment> assignments,
                                            const automata::Variables& variables, std::string_view where) {
  std::sort(assignments.begin(), assignments.end());
  assignments.erase(std::unique(assignments.begin(), assignments.end()), assignments.end());
  const auto twice = std::adjacent_find(assignments.begin(), assignments.end(),
                                        [](const auto& a, const auto& b) { return a.variable == b.variable; });
  if (twice != assignments.end()) {
    throw base::InputError(std::string(where) + ": '" + variables.name(twice->variable) + "' is given two values, '" +
                           variables.value(*twice) + "' and '" + variables.value(*(twice + 1)) + "'");
  }
  return assignments;
}

}  // namespace rmpl::compiler
