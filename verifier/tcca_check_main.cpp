// tcca-check: can a plant get there, can it avoid that, does it answer in time.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "automata/error.hpp"
#include "compiler/compiler.hpp"
#include "verifier/command_line.hpp"
#include "verifier/evidence/report.hpp"

namespace {

using automata::InputError;
using automata::Plant;
using verifier::CommandLine;

constexpr int wrong_input = 2;

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

/// The first interrupt ends the search with what was found so far; a second one ends the program.
void end_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted = true; };
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
}

bool colored(const CommandLine& line, int stream) {
  switch (line.color) {
    case CommandLine::Color::automatic:
      return isatty(stream) != 0;
    case CommandLine::Color::always:
      return true;
    case CommandLine::Color::never:
      return false;
  }
  return false;
}

/// Diagnostics that were printed already: nothing is left to say.
struct Rejected {};

compiler::Compilation load(const CommandLine& line) {
  const std::array paths = {line.model};
  compiler::Compilation compilation = compiler::compile(paths);
  const bool failed = !compilation.ok();
  if (failed || !line.quiet) {
    std::cerr << compilation.diagnostics(compiler::DiagnosticFormat::text, colored(line, STDERR_FILENO));
  }
  if (failed) throw Rejected{};
  const std::size_t plants = compilation.document().plants.size();
  if (plants != 1) {
    throw InputError(line.model + ": holds " + std::to_string(plants) + " plants; expected one, as in a .tcca file");
  }
  return compilation;
}

automata::Formula formula(const std::string& text, const Plant& plant, const char* option, const CommandLine& line) {
  auto compiled = compiler::compile_formula(text, plant, option, colored(line, STDERR_FILENO));
  if (compiled.formula) return *compiled.formula;
  std::cerr << compiled.diagnostics;
  throw Rejected{};
}

verifier::Property property(const Plant& plant, const CommandLine& line) {
  const verifier::Window window{line.not_before, line.by};
  switch (line.kind) {
    case CommandLine::Kind::reachability:
      return verifier::Reachability{formula(line.target, plant, "--target", line), window, line.fastest};
    case CommandLine::Kind::safety:
      return verifier::Safety{formula(line.never, plant, "--never", line), window, line.fastest};
    case CommandLine::Kind::response:
      break;
  }
  return verifier::Response{formula(line.after, plant, "--after", line), formula(line.then, plant, "--within", line),
                            line.within};
}

verifier::CheckOptions options(const Plant& plant, const CommandLine& line) {
  verifier::CheckOptions result{line.period, line.faults, line.commands, line.entailed, {}};
  if (line.from.empty()) return result;
  auto compiled = compiler::compile_assignments(line.from, plant, "--from", colored(line, STDERR_FILENO));
  if (!compiled.assignments) {
    std::cerr << compiled.diagnostics;
    throw Rejected{};
  }
  result.from = std::move(*compiled.assignments);
  return result;
}

verifier::Limits limits(const CommandLine& line) {
  verifier::Limits result{line.max_states, std::nullopt, line.max_bytes, &interrupted, nullptr};
  if (line.timeout && !line.timeout->is_infinite()) result.time.emplace(line.timeout->seconds());
  if (isatty(STDERR_FILENO) != 0 && !line.quiet) {
    result.report = [](const verifier::Progress& p) {
      std::fprintf(stderr, "\r%.0f s: %zu states, %zu unexplored, %zu steps\033[K", p.seconds, p.states, p.waiting,
                   p.steps);
    };
  }
  return result;
}

int status(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::holds:
      return 0;
    case verifier::Verdict::violated:
      return 1;
    case verifier::Verdict::undecided:
      return 3;
  }
  return wrong_input;
}

int run(const CommandLine& line) {
  const compiler::Compilation compilation = load(line);
  const Plant& plant = compilation.document().plants.front();
  const verifier::Property asked = property(plant, line);
  if (line.verbose) {
    std::cerr << "checking " << verifier::name_of(asked) << " of " << plant.name << ": " << plant.components.size()
              << " components, " << plant.controls.size() << " controls\n";
  }
  automata::PlantStep step(plant);
  const verifier::Limits bounds = limits(line);
  const verifier::Result result = verifier::check(step, asked, options(plant, line), bounds);
  if (bounds.report) std::fputs("\r\033[K", stderr);
  if (result.startless) {
    std::cerr
        << "tcca-check: warning: no initial state is possible: the initial modes contradict the interconnections, so "
           "nothing is reachable\n";
  }
  switch (line.format) {
    case CommandLine::Format::json:
      std::cout << verifier::to_json(plant, asked, result).dump(2) << '\n';
      break;
    case CommandLine::Format::text:
      std::cout << verifier::to_text(plant, asked, result, line.statistics, colored(line, STDOUT_FILENO));
      break;
  }
  if (!std::cout.flush()) throw InputError("standard output: cannot be written");
  return status(result.verdict);
}

}  // namespace

int main(int count, char** arguments) {
  const auto parsed = verifier::parse_command_line(count, arguments, RMPL_VERSION);
  if (!parsed.command_line) {
    (parsed.failed ? std::cerr : std::cout) << parsed.message;
    return parsed.failed ? wrong_input : 0;
  }
  end_on_interrupt();
  try {
    return run(*parsed.command_line);
  } catch (const Rejected&) {
    return wrong_input;
  } catch (const InputError& error) {
    std::cerr << "tcca-check: " << error.what() << '\n';
    return wrong_input;
  }
}
