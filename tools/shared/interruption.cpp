// The one signal handler.
// SPDX-License-Identifier: MIT
#include "tools/shared/interruption.hpp"

#include <csignal>

#include "base/output_file.hpp"

namespace rmpl::tools {
namespace {

std::atomic<bool> watching = false;
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void on_signal(int signal) {
  const bool asks = signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
  if (asks && watching && !noted.exchange(true)) return;
  base::remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void clean_up_on_signals() {
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

void watch_for_interruption() { watching = true; }

bool interrupted() { return noted; }

const std::atomic<bool>& interruption() { return noted; }

}  // namespace rmpl::tools
