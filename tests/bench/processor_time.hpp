// Processor time of this thread: what else runs on the machine counts little.
// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace rmpl::bench {

inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace rmpl::bench
