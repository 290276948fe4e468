// Standard output and standard error, by their descriptors: a stream would keep the reason of a failure to itself.
// SPDX-License-Identifier: MIT
#include "tools/shared/terminal.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"
#include "tools/shared/progress.hpp"

namespace rmpl::tools {
namespace {

std::string& program() {
  static std::string name;
  return name;
}

base::Painter painter(Color color, int descriptor) {
  switch (color) {
    case Color::always:
      return {true};
    case Color::never:
      return {false};
    case Color::automatic: {
      const char* wish = std::getenv("NO_COLOR");
      return {isatty(descriptor) != 0 && (wish == nullptr || *wish == '\0')};
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

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    constexpr unsigned char blank = 0x20, del = 0x7f;
    if ((byte >= blank && byte != del) || c == '\n') {
      result += c;
    } else {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned>(byte));
      result += code.data();
    }
  }
  return result;
}

}  // namespace

base::Painter output_painter(Color color) { return painter(color, STDOUT_FILENO); }
base::Painter error_painter(Color color) { return painter(color, STDERR_FILENO); }

bool output_is_seen() { return isatty(STDOUT_FILENO) != 0; }

void print(std::string_view text) {
  erase_progress();
  const int reason = written(STDOUT_FILENO, text);
  if (reason == EBADF) throw base::InputError("standard output: cannot be written: it is closed");
  if (reason != 0) throw base::InputError(std::string("standard output: cannot be written: ") + std::strerror(reason));
}

void print_error(std::string_view text) {
  erase_progress();
  (void)written(STDERR_FILENO, text);  // there is nowhere left to say so
}

void tell(std::string_view text) { print_error(program() + ": " + escaped(text) + "\n"); }

void name_program(std::string name) { program() = std::move(name); }

}  // namespace rmpl::tools
