// How much computing something takes, whatever else the machine does meanwhile.
// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace rmpl::runtime {

/// Processor time of this thread since construction.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_ = now();
};

}  // namespace rmpl::runtime
