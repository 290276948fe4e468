// tcca-check: can a plant get there, can it avoid that, does it answer in time, and what becomes of a program on it.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/out_of_memory.hpp"
#include "tools/tcca-check/check_command.hpp"
#include "tools/tcca-check/export_command.hpp"
#include "tools/tcca-check/input.hpp"
#include "tools/tcca-check/program_command.hpp"
#include "tools/tcca-check/property_command.hpp"

using namespace rmpl;

namespace {

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

verifier::Limits limits(const CommandLine& line) {
  verifier::Limits result{line.max_states, std::nullopt, line.max_bytes, &interrupted, nullptr};
  if (line.timeout && !line.timeout->is_infinite()) result.time.emplace(line.timeout->seconds());
  if (isatty(STDERR_FILENO) != 0 && !line.quiet) {
    result.report = [](const verifier::Progress& p) {
      std::fprintf(stderr, "\r%.0f s: %zu states, %zu unexplored, %zu %s\033[K", p.seconds, p.states, p.waiting,
                   p.steps.value_or(p.level), p.steps ? "steps" : "faults");
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
  const verifier::Limits bounds = limits(line);
  switch (line.kind) {
    case CommandLine::Kind::reachability:
    case CommandLine::Kind::safety:
    case CommandLine::Kind::response:
      return status(verifier::run_property(line, bounds));
    case CommandLine::Kind::program:
      return status(verifier::run_program(line, bounds));
    case CommandLine::Kind::check_file:
      return status(verifier::run_check(line, bounds));
    case CommandLine::Kind::export_model:
      return verifier::run_export(line, bounds) ? 0 : status(verifier::Verdict::undecided);
  }
  return wrong_input;
}

}  // namespace

int main(int count, char** arguments) {
  std::set_terminate([] { base::end_for_lack_of_memory("tcca-check"); });
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
  } catch (const base::InputError& error) {
    std::cerr << "tcca-check: " << error.what() << '\n';
    return wrong_input;
  } catch (const base::InternalError& error) {
    std::cerr << "tcca-check: internal error, nothing is claimed: " << error.what() << '\n';
    return 4;
  } catch (const std::bad_alloc&) {
    std::cerr << "tcca-check: out of memory\n";
    return status(verifier::Verdict::undecided);
  }
}
