// Progress as a line that is rewritten.
// SPDX-License-Identifier: MIT
#include "tools/shared/progress.hpp"

#include <unistd.h>

#include <atomic>
#include <string>

#include "base/printable.hpp"

namespace rmpl::tools {
namespace {

std::atomic<bool> drawn = false;

void draw(const std::string& text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) drawn = false;
}

}  // namespace

bool progress_is_seen(bool quiet) { return !quiet && isatty(STDERR_FILENO) != 0; }

void show_progress(std::string_view line) {
  drawn = true;
  draw("\r\x1b[K" + base::printable(line));
}

void erase_progress() {
  if (drawn.exchange(false)) draw("\r\x1b[K");
}

}  // namespace rmpl::tools
