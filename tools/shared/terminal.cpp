// Standard output and standard error, by their descriptors: a stream would keep the reason of a failure to itself.
// SPDX-License-Identifier: MIT
#include "tools/shared/terminal.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "tools/shared/progress.hpp"

namespace rmpl::tools {
namespace {

std::string& program() {
  static std::string name;
  return name;
}

std::atomic<bool> begun = false;

/// Whether somebody sees what is written there. Under mpirun standard output is a terminal of its own, from which all
/// goes to wherever mpirun writes: a file, as it may be.
bool is_seen(int descriptor) {
  for (const char* rank : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(rank) != nullptr) return false;
  }
  return isatty(descriptor) != 0;
}

base::Painter painter(Color color, int descriptor) {
  switch (color) {
    case Color::always:
      return {true};
    case Color::never:
      return {false};
    case Color::automatic: {
      const char* wish = std::getenv("NO_COLOR");
      return {is_seen(descriptor) && (wish == nullptr || *wish == '\0')};
    }
  }
  return {false};
}

/// Writes all of a text; 0, or the reason why not.
int written(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace

base::Painter output_painter(Color color) { return painter(color, STDOUT_FILENO); }
base::Painter error_painter(Color color) { return painter(color, STDERR_FILENO); }

bool output_is_begun() { return begun; }

bool output_is_seen() { return is_seen(STDOUT_FILENO); }

void print(std::string_view text) { print_raw(base::printable_in_colour(text)); }
void print_json(std::string_view document) { print_raw(base::printable_json(document)); }
void print_file(std::string_view text) { output_is_seen() ? print(text) : print_raw(text); }

void print_raw(std::string_view text) {
  erase_progress();
  begun = begun || !text.empty();
  const int reason = written(STDOUT_FILENO, text);
  if (reason == EBADF) throw base::InputError("standard output: cannot be written: it is closed");
  if (reason != 0) throw base::InputError(std::string("standard output: cannot be written: ") + std::strerror(reason));
}

void print_error(std::string_view text) {
  erase_progress();
  (void)written(STDERR_FILENO, base::printable_in_colour(text));  // there is nowhere left to say so
}

void tell(std::string_view text) { print_error(program() + ": " + base::printable(text) + "\n"); }

void name_program(std::string name) { program() = std::move(name); }

}  // namespace rmpl::tools
