// A log answered line by line, of plants and of model programs alike.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/input_file.hpp"
#include "runtime/executive/trace/log.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

/// A file is checked in full before anything is answered: how many lines it has. What can be read only once is answered
/// as it comes: nothing. `names`: the plant or model program that the log speaks of.
template <class Names>
std::optional<std::size_t> check_log(const std::string& log, const Names& names) {
  if (!base::is_read_again(log)) return std::nullopt;
  base::InputFile input(log);
  runtime::LogReader reader(input.stream(), input.name(), names);
  std::size_t lines = 0;
  while (reader.next()) ++lines;
  return lines;
}

/// Answers each line with `answer(line, name of the log)`, up to an interruption, which is told. Whether one came
/// before the end.
template <class Names, class Answer>
bool answer_log(const std::string& log, const Names& names, std::optional<std::size_t> lines, const Answer& answer) {
  base::InputFile input(log, interrupted);
  runtime::LogReader reader(input.stream(), input.name(), names);
  std::size_t answered = 0;
  while (!interrupted()) {
    const auto line = reader.next();
    if (!line) break;
    print(answer(*line, input.name()));  // whole lines, whatever ends the run
    ++answered;
  }
  const bool early = interrupted() && answered != lines;
  if (early) {
    tell("interrupted after " + std::to_string(answered) + (lines ? " of " + std::to_string(*lines) : std::string()) +
         (answered == 1 && !lines ? " line" : " lines"));
  }
  return early;
}

}  // namespace rmpl::tools
