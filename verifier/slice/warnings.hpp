// What is most likely meant otherwise in a question, or misunderstood of its answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "verifier/property/property.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

inline constexpr const char* no_start =
    "no initial state is possible: the initial modes contradict the interconnections, so nothing is reachable";

struct QuestionWarning {
  std::string text;
  bool says_nothing = false;  ///< the model decides what is asked before any run is looked at
};

/// Before anything is searched: that what is asked speaks of commands, which are no part of a state; that it, or the
/// conditions of the program that it is asked of, if there is one, ask of the executive's knowledge; and that the model
/// decides it before any run is looked at, as what it asks about takes a fault and none is permitted, or is there in
/// every state.
std::vector<QuestionWarning> warnings_of(const Question& question, Slices& slices, const automata::Program* program);

/// Of an answer: that no initial state is possible; or, where no run was found in dense time, that a mode in the cone
/// of the question lasts only while a command is held, which no run there does.
std::optional<std::string> warning_of(const Question& question, const Answer& answer, Slices& slices);

}  // namespace rmpl::verifier
