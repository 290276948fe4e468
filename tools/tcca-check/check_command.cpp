// tcca-check check.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/check_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "base/error.hpp"
#include "grammar/source/render.hpp"
#include "tools/tcca-check/input.hpp"
#include "tools/tcca-check/output.hpp"
#include "verifier/plant/check_all.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::verifier {

using automata::PlantProperty;
using base::InputError;

namespace {

Commands commands_of(PlantProperty::Commands commands) {
  switch (commands) {
    case PlantProperty::Commands::none:
      return Commands::none;
    case PlantProperty::Commands::one:
      return Commands::one;
    case PlantProperty::Commands::any:
      return Commands::any;
  }
  return Commands::one;
}

Property property_of(const PlantProperty& stated) {
  switch (stated.claim) {
    case PlantProperty::Claim::never:
      return Safety{stated.formula, {}, false};
    case PlantProperty::Claim::reach:
      return Reachability{stated.formula, {}, false};
    case PlantProperty::Claim::response:
      break;
  }
  return Response{stated.formula, stated.then, stated.within};
}

std::vector<PlantProperty> read_properties(const CommandLine& line, const automata::Plant& plant) {
  auto compiled = compiler::compile_properties(line.properties, plant);
  std::cerr << grammar::render_text(compiled.findings, colored(line, STDERR_FILENO));
  if (!compiled.properties) throw Rejected{};
  std::vector<PlantProperty> all = std::move(*compiled.properties);
  for (const std::string& name : line.only) {
    const auto called = [&](const PlantProperty& p) { return p.name == name; };
    if (std::none_of(all.begin(), all.end(), called)) {
      throw base::InputError("--only: " + line.properties + " has no property \"" + name + "\"");
    }
  }
  if (!line.only.empty()) {
    std::erase_if(
        all, [&](const auto& p) { return std::find(line.only.begin(), line.only.end(), p.name) == line.only.end(); });
  }
  return all;
}

}  // namespace

Verdict run_check(const CommandLine& line, const Limits& limits) {
  if (line.properties == "-" && line.models.front() == "-") {
    throw base::InputError("standard input cannot be both the model and the properties");
  }
  const compiler::Compilation compilation = load(line);
  const automata::Plant& plant = compilation.document().plants.front();
  const std::vector<PlantProperty> stated = read_properties(line, plant);
  std::vector<Question> questions;
  for (const PlantProperty& p : stated) {
    questions.push_back({property_of(p),
                         {.period = p.period,
                          .faults = p.faults,
                          .commands = commands_of(p.commands),
                          .entailed = p.entailed,
                          .threads = line.threads,
                          .from = p.from}});
  }
  automata::PlantStep step(plant);
  std::vector<Answer> answers = check_all(step, questions, limits);
  if (limits.report) std::fputs("\r\033[K", stderr);
  if (std::any_of(answers.begin(), answers.end(), [](const Answer& a) { return a.startless; })) {
    warn_of_no_start("nothing is reachable");
  }
  std::vector<Claim> claims;
  for (std::size_t q = 0; q < stated.size(); ++q) {
    claims.push_back({stated[q].name, std::move(questions[q]), stated[q].expect_violated, std::move(answers[q])});
  }
  print(
      line, [&] { return to_table(plant, claims, line.statistics, colored(line, STDOUT_FILENO)); },
      [&] { return to_json(plant, claims); }, [&] { return to_junit(plant, claims); });
  finish_output();
  const Count found = count(claims);
  if (found.unexpected > 0) return Verdict::violated;
  return found.undecided > 0 ? Verdict::undecided : Verdict::holds;
}

}  // namespace rmpl::verifier
