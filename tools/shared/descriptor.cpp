// Closes a file descriptor.
// SPDX-License-Identifier: MIT
#include "tools/shared/descriptor.hpp"

#include <unistd.h>

namespace rmpl::tools {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this == &other) return *this;
  close();
  number_ = std::exchange(other.number_, -1);
  return *this;
}

void Descriptor::close() {
  if (open()) ::close(std::exchange(number_, -1));
}

}  // namespace rmpl::tools
