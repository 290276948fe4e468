// tcca-check: can a plant get there, can it avoid that, does it answer in time, and what becomes of a program on it.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "automata/error.hpp"
#include "verifier/command/check_command.hpp"
#include "verifier/command/export_command.hpp"
#include "verifier/command/input.hpp"
#include "verifier/command/program_command.hpp"
#include "verifier/evidence/report.hpp"

namespace {

using automata::InputError;
using automata::Plant;
using verifier::colored;
using verifier::CommandLine;
using verifier::formula;
using verifier::load;
using verifier::starting_modes;

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

verifier::Property property(const Plant& plant, const CommandLine& line) {
  const verifier::Window window{line.not_before, line.by};
  switch (line.kind) {
    case CommandLine::Kind::reachability:
      return verifier::Reachability{formula(line.target, plant, "--target", line), window, line.fastest};
    case CommandLine::Kind::safety:
      return verifier::Safety{formula(line.never, plant, "--never", line), window, line.fastest};
    case CommandLine::Kind::response:
    case CommandLine::Kind::program:
    case CommandLine::Kind::check_file:
    case CommandLine::Kind::export_model:
      break;
  }
  return verifier::Response{formula(line.after, plant, "--after", line), formula(line.then, plant, "--within", line),
                            line.within};
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

verifier::CheckOptions options(const Plant& plant, const CommandLine& line) {
  verifier::CheckOptions result{.period = line.period,
                                .faults = line.faults,
                                .commands = line.commands,
                                .entailed = line.entailed,
                                .fewest_faults = line.fewest_faults,
                                .cut_sets = line.cut_sets.has_value(),
                                .symmetry = !line.no_symmetry,
                                .threads = line.threads,
                                .from = starting_modes(plant, line)};
  if (line.fewest_faults && !line.faults_given) result.faults.reset();
  if (line.cut_sets) result.faults = line.cut_sets;
  return result;
}

int run(const CommandLine& line) {
  if (line.kind == CommandLine::Kind::program) return verifier::run_program(line, limits(line));
  if (line.kind == CommandLine::Kind::check_file) return verifier::run_check(line, limits(line));
  if (line.kind == CommandLine::Kind::export_model) return verifier::run_export(line, limits(line));
  const compiler::Compilation compilation = load(line);
  const Plant& plant = compilation.document().plants.front();
  const verifier::Property asked = property(plant, line);
  if (line.verbose) {
    std::cerr << "checking " << verifier::name_of(asked) << " of " << plant.name << ": " << plant.components.size()
              << " components, " << plant.controls.size() << " controls\n";
  }
  automata::PlantStep step(plant);
  const verifier::Limits bounds = limits(line);
  const verifier::CheckOptions asked_for = options(plant, line);
  const verifier::Result result = verifier::check(step, asked, asked_for, bounds);
  if (bounds.report) std::fputs("\r\033[K", stderr);
  if (result.startless) {
    std::cerr
        << "tcca-check: warning: no initial state is possible: the initial modes contradict the interconnections, so "
           "nothing is reachable\n";
  }
  switch (line.format) {
    case CommandLine::Format::json:
      std::cout << verifier::to_json(plant, asked, asked_for, result).dump(2) << '\n';
      break;
    case CommandLine::Format::text:
    case CommandLine::Format::junit:  // of `check` alone
      std::cout << verifier::to_text(plant, asked, asked_for, result, line.statistics, colored(line, STDOUT_FILENO));
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
  } catch (const verifier::Rejected&) {
    return wrong_input;
  } catch (const InputError& error) {
    std::cerr << "tcca-check: " << error.what() << '\n';
    return wrong_input;
  }
}
