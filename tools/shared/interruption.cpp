// The signal handler.
// SPDX-License-Identifier: MIT
#include "tools/shared/interruption.hpp"

#include <csignal>

namespace rmpl::runtime {
namespace {

volatile std::sig_atomic_t signalled = 0;

extern "C" void note_signal(int) {
  signalled = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

void watch_for_interruption() { std::signal(SIGINT, note_signal); }

bool interrupted() { return signalled != 0; }

}  // namespace rmpl::runtime
