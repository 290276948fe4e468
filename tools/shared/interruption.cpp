// The one signal handler.
// SPDX-License-Identifier: MIT
#include "tools/shared/interruption.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

#include "base/output_file.hpp"
#include "tools/shared/exit_status.hpp"

namespace rmpl::tools {
namespace {

/// A handler may touch atomics that need no lock, and nothing else of ours.
std::atomic<const char*> program_name = "";
std::atomic<bool> ends = false;
std::atomic<bool> noted = false;
std::atomic<unsigned> signals = 0;    ///< that asked for an end
std::atomic<std::int64_t> first = 0;  ///< when the first of them came, in nanoseconds of the monotonic clock
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

void write_error(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // there is nowhere left to say so
}

[[noreturn]] void end_interrupted() {
  base::remove_unfinished_files();
  write_error(program_name);
  write_error(": interrupted\n");
  ::_exit(static_cast<int>(ExitStatus::undecided));
}

/// Whether a signal breaks off by force.
bool is_force(int signal) {
  constexpr unsigned most_signals = 2;
  constexpr std::int64_t patience = 1'000'000'000;
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  const unsigned before = signals++;
  if (before == 0) first = now;
  return signal == SIGINT && before >= most_signals && now - first >= patience;
}

bool asks_for_an_end(int signal) {
  return signal == SIGINT || signal == SIGTERM || signal == SIGHUP || signal == SIGXCPU;
}

extern "C" void on_signal(int signal) {
  const int reason = errno;
  if (asks_for_an_end(signal) && !is_force(signal)) {
    if (ends) end_interrupted();
    noted = true;
    errno = reason;
    return;
  }
  base::remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void note_signals(const char* name) {
  program_name = name;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    // What whoever started us ignores (nohup, a pipe that may break) stays ignored.
    const bool ignored = before.sa_handler == SIG_IGN && (signal == SIGHUP || signal == SIGPIPE);
    if (!ignored) sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of the write
}

void end_at_signals() {
  ends = true;
  if (noted) end_interrupted();
}

bool interrupted() { return noted; }

const std::atomic<bool>& interruption() { return noted; }

}  // namespace rmpl::tools
