// A plant that is a command: a child of this process, with its standard input and output.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>

#include "tools/rmpl-run/live_socket.hpp"

namespace rmpl::tools {

/// Started with the first cycle, and again where it has ended: in the 1st, 2nd, 4th, 8th, … cycle without it. It is a
/// process group of its own, so that Ctrl-C is for the executive, and no part of it stays behind.
class ChildPlant final : public LiveSocket {
 public:
  ChildPlant(std::string command, std::function<bool()> interrupted);
  /// Closes its input and gives it a second to end; then SIGTERM, and another second; then SIGKILL.
  ~ChildPlant() override;
  ChildPlant(const ChildPlant&) = delete;
  ChildPlant& operator=(const ChildPlant&) = delete;

  /// Throws base::InputError where no process can be made for the first of them.
  void revive(std::uint64_t cycles, automata::Ticks until) override;
  [[nodiscard]] std::string reason() const override { return reason_; }

 private:
  void on_gone() override;
  [[nodiscard]] bool start();
  void end();

  std::string command_;
  std::string reason_;
  pid_t child_ = -1;
  bool started_ = false;
};

}  // namespace rmpl::tools
