// Starting, watching and ending a child.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/child_plant.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

/// Waits for the end of a child, no longer than `most`; nothing where it goes on.
std::optional<int> status_within(pid_t child, std::chrono::milliseconds most) {
  constexpr std::chrono::milliseconds step{5};
  for (auto left = most;; left -= step) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) != 0) return status;
    if (left <= step) return std::nullopt;
    std::this_thread::sleep_for(step);
  }
}

std::string described(int status) {
  if (WIFSIGNALED(status)) return "it was ended by signal " + std::to_string(WTERMSIG(status));
  return "it ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildPlant::ChildPlant(std::string command, std::function<bool()> interrupted)
    : LiveSocket(std::move(interrupted)), command_(std::move(command)) {}

ChildPlant::~ChildPlant() { end(); }

void ChildPlant::revive(std::uint64_t cycles, automata::Ticks /*until*/) {
  const bool power_of_two = (cycles & (cycles - 1)) == 0;
  if (!power_of_two || start() || started_) return;
  throw base::InputError(std::string("--exec: cannot start a process: ") + std::strerror(errno));
}

bool ChildPlant::start() {
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) return false;
  Descriptor ours(pair[0]);
  const Descriptor theirs(pair[1]);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, theirs.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, theirs.number(), STDOUT_FILENO);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGXFSZ);  // which this process ignores
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  std::string shell = "sh", flag = "-c";
  const std::array<char*, 4> arguments{shell.data(), flag.data(), command_.data(), nullptr};
  errno = posix_spawn(&child_, "/bin/sh", &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (errno != 0) return false;
  connect(std::move(ours));
  started_ = true;
  return true;
}

/// It has closed its output, which is the end of it as a plant.
void ChildPlant::on_gone() {
  constexpr std::chrono::milliseconds patience{200};
  const auto status = status_within(child_, patience);
  kill(-child_, SIGKILL);
  if (!status) waitpid(child_, nullptr, 0);
  reason_ = status ? described(*status) : "it closed its output";
  child_ = -1;
}

void ChildPlant::end() {
  if (child_ < 0) return;
  constexpr std::chrono::milliseconds patience{1000};
  shutdown(socket(), SHUT_WR);
  bool ended = status_within(child_, patience).has_value();
  if (!ended) {
    kill(-child_, SIGTERM);
    ended = status_within(child_, patience).has_value();
  }
  kill(-child_, SIGKILL);
  if (!ended) waitpid(child_, nullptr, 0);
  child_ = -1;
}

}  // namespace rmpl::tools
