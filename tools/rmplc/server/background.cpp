// A child process, and the pipe through which it answers.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/background.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace rmpl::tools {
namespace {

constexpr int background_priority = 10;

bool write_all(int descriptor, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + at, text.size() - at);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) at += static_cast<std::size_t>(count);
  }
  return true;
}

/// The whole life of the child. It leaves without unwinding: what is open is its parent's.
[[noreturn]] void serve(int descriptor, const std::function<std::string()>& work) {
  setpriority(PRIO_PROCESS, 0, background_priority);
  bool done = false;
  try {
    done = write_all(descriptor, work());
  } catch (...) {  // the parent sees the status
  }
  _exit(done ? 0 : 1);
}

}  // namespace

Background::Background(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return;
  child_ = fork();
  if (child_ == 0) {
    close(ends[0]);
    serve(ends[1], work);
  }
  close(ends[1]);
  descriptor_ = ends[0];
}

Background::~Background() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    reap();
  }
  if (descriptor_ >= 0) close(descriptor_);
}

bool Background::reap() {
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(child_, &status, 0);
  } while (ended < 0 && errno == EINTR);
  child_ = -1;
  return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::optional<std::string> Background::take() {
  if (child_ < 0) return std::string();
  std::array<char, 1 << 16> bytes;
  const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
  if (count < 0 && errno == EINTR) return std::nullopt;
  if (count > 0) {
    answer_.append(bytes.data(), static_cast<std::size_t>(count));
    return std::nullopt;
  }
  return reap() ? std::move(answer_) : std::string();
}

}  // namespace rmpl::tools
