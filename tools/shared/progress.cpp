// Progress as a line that is rewritten.
// SPDX-License-Identifier: MIT
#include "tools/shared/progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace rmpl::runtime {
namespace {

constexpr auto patience = std::chrono::milliseconds(500);
constexpr auto pace = std::chrono::milliseconds(100);
constexpr std::uint64_t cycles_between_looks = 64;  // asking the clock each time would cost more than a cycle

}  // namespace

Progress::Progress(std::string name, automata::Ticks duration, bool wanted)
    : name_(std::move(name)),
      duration_(duration),
      shown_(wanted && isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + patience) {}

Progress::~Progress() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::observe(const CycleRecord& record) {
  if (!shown_ || record.cycle % cycles_between_looks != 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + pace;
  drawn_ = true;
  std::cerr << "\r\x1b[K" << name_ << ": " << automata::format_seconds(record.time) << " s of at most "
            << automata::format_seconds(duration_) << " s" << std::flush;
}

}  // namespace rmpl::runtime
