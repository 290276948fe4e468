// The process: what it reads and writes are unnamed files, so that nobody waits for anybody.
// SPDX-License-Identifier: MIT
#include "tools/shared/graphviz.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/error.hpp"

extern char** environ;

namespace rmpl::tools {
namespace {

[[noreturn]] void fail(int reason) {
  throw base::InputError(std::string("dot, which lays pictures out, cannot be run: ") + std::strerror(reason));
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

File unnamed_file() {
  File file(std::tmpfile());
  if (!file) fail(errno);
  return file;
}

/// All of a file from its beginning.
std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 65536> buffer{};
  std::rewind(file);
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), count);
  if (std::ferror(file) != 0) fail(errno);
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

}  // namespace

std::string svg_of(const std::string& graph, std::string_view way_out) {
  const File input = unnamed_file();
  const File output = unnamed_file();
  const File complaints = unnamed_file();
  if (std::fwrite(graph.data(), 1, graph.size(), input.get()) != graph.size() || std::fflush(input.get()) != 0) {
    fail(errno);
  }
  std::rewind(input.get());
  std::string name = "dot";
  std::string format = "-Tsvg";
  const std::array<char*, 3> arguments{name.data(), format.data(), nullptr};
  const Redirections redirections(input.get(), output.get(), complaints.get());
  pid_t process = 0;
  const int refused = posix_spawnp(&process, "dot", redirections.get(), nullptr, arguments.data(), environ);
  if (refused == ENOENT) {
    throw base::InputError("dot, which lays pictures out, is not there: " + std::string(way_out));
  }
  if (refused != 0) fail(refused);
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) fail(errno);
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw base::InputError("dot, which lays pictures out, failed: " + contents(complaints.get()));
  }
  return contents(output.get());
}

}  // namespace rmpl::tools
