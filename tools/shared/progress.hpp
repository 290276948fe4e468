// How far a long run has come, on a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "automata/time/time.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// A line on standard error that is rewritten ten times a second, and wiped at the end. Silent where standard error is
/// no terminal, and in the first half second: most runs are over by then.
class Progress final : public CycleObserver {
 public:
  Progress(std::string name, automata::Ticks duration, bool wanted);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void observe(const CycleRecord& record) override;

 private:
  std::string name_;
  automata::Ticks duration_;
  bool shown_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rmpl::runtime
