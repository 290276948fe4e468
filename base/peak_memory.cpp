// How much memory this process has taken.
// SPDX-License-Identifier: MIT
#include "base/peak_memory.hpp"

#include <sys/resource.h>

namespace rmpl::base {

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts it in kilobytes
}

}  // namespace rmpl::base
