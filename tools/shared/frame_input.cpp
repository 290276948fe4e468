// As many bytes as come at once.
// SPDX-License-Identifier: MIT
#include "tools/shared/frame_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace rmpl::tools {

bool input_is_ready() {
  pollfd wanted{STDIN_FILENO, POLLIN, 0};
  return poll(&wanted, 1, 0) > 0;
}

bool read_some(Frames& frames) {
  std::array<char, 1 << 16> bytes;
  ssize_t count = 0;
  do {
    count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw base::InputError(std::string("standard input: ") + std::strerror(errno));
  frames.feed({bytes.data(), static_cast<std::size_t>(count)});
  return count > 0;
}

}  // namespace rmpl::tools
