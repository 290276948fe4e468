// The process: what it reads and writes are unnamed files, so that nobody waits for anybody.
// SPDX-License-Identifier: MIT
#include "tools/shared/child_process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

using Clock = std::chrono::steady_clock;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string& program, int reason) {
  throw base::InputError(program + " cannot be run: " + std::strerror(reason));
}

/// All of a file from its beginning.
std::string contents(const std::string& program, std::FILE* file) {
  std::string text;
  std::array<char, 65536> buffer{};
  std::rewind(file);
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), count);
  if (std::ferror(file) != 0) fail(program, errno);
  return text;
}

/// What becomes of descriptors 0, 1 and 2 of the process.
class Redirections {
 public:
  Redirections(std::FILE* input, std::FILE* output, std::FILE* complaints) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, fileno(input), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, fileno(output), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, fileno(complaints), STDERR_FILENO);
  }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Waits for the end of a process, which it may bring about; its status.
int wait_for(pid_t process, const ChildCall& call, ChildEnd& end) {
  constexpr std::chrono::milliseconds longest{20};
  constexpr std::chrono::seconds patience{5};
  const auto start = Clock::now();
  std::optional<Clock::time_point> asked;
  std::chrono::milliseconds step{1};
  int status = 0;
  while (true) {
    const pid_t ended = waitpid(process, &status, call.time_limit || call.interrupted ? WNOHANG : 0);
    if (ended > 0) return status;
    if (ended < 0 && errno != EINTR) fail(call.arguments.front(), errno);
    const auto now = Clock::now();
    const bool late = call.time_limit && now - start > *call.time_limit;
    if (!asked && (late || (call.interrupted && call.interrupted()))) {
      end.late = late;
      asked = now;
      kill(process, SIGTERM);
    }
    if (asked && now - *asked > patience) kill(process, SIGKILL);
    if (ended == 0) std::this_thread::sleep_for(step);
    step = std::min(2 * step, longest);
  }
}

}  // namespace

std::optional<ChildEnd> run_child(const ChildCall& call) {
  const std::string& program = call.arguments.front();
  std::array<File, 3> files;
  for (File& file : files) {
    file.reset(std::tmpfile());
    if (!file) fail(program, errno);
  }
  const auto& [input, output, complaints] = files;
  if (std::fwrite(call.input.data(), 1, call.input.size(), input.get()) != call.input.size() ||
      std::fflush(input.get()) != 0) {
    fail(program, errno);
  }
  std::rewind(input.get());
  std::vector<std::string> texts = call.arguments;
  std::vector<char*> arguments;
  arguments.reserve(texts.size() + 1);
  for (std::string& text : texts) arguments.push_back(text.data());
  arguments.push_back(nullptr);
  const Redirections redirections(input.get(), output.get(), complaints.get());
  pid_t process = 0;
  const int refused = posix_spawnp(&process, program.c_str(), redirections.get(), nullptr, arguments.data(), environ);
  if (refused == ENOENT) return std::nullopt;
  if (refused != 0) fail(program, refused);
  ChildEnd end;
  const int status = wait_for(process, call, end);
  if (WIFEXITED(status)) end.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.output = contents(program, output.get());
  end.errors = contents(program, complaints.get());
  return end;
}

}  // namespace rmpl::tools
