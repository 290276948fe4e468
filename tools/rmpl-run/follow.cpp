// Lines that are written over, by the sequences that every terminal knows.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/follow.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "base/printable.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

struct Size {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

Size size_of_terminal() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {std::clamp<std::size_t>(size.ws_col, 40, 160), std::clamp<std::size_t>(size.ws_row, 16, 40)};
}

}  // namespace

void FollowScreen::observe(const runtime::CycleRecord& record) {
  constexpr auto pace = std::chrono::milliseconds(100);
  view_.observe(record);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + pace;
  draw();
}

void FollowScreen::draw() {
  const Size size = size_of_terminal();
  std::string text = drawn_ == 0 ? "" : "\x1b[" + std::to_string(drawn_) + "A\r";
  const auto lines = view_.lines(size.columns, size.rows - 3);
  for (const std::string& line : lines) text += base::printable_in_colour(line) + "\x1b[K\n";
  drawn_ = lines.size();
  print_raw(text + "\x1b[J");
}

}  // namespace rmpl::tools
