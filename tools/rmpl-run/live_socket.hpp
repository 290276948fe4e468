// Bytes to and from a plant over a stream socket: what a child and a listener have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/executive/live/channel.hpp"
#include "tools/shared/descriptor.hpp"

namespace rmpl::tools {

/// Waits until a descriptor can be read or, for `writable`, written, or until the end of `patience`. A signal ends the
/// wait early. What poll(2) says of it; 0 where it says nothing.
short wait_for(int descriptor, bool writable, automata::Ticks patience);

/// A channel over a connected, non-blocking socket. Waits look for an interruption twenty times a second.
class LiveSocket : public runtime::Channel {
 public:
  explicit LiveSocket(std::function<bool()> interrupted) : interrupted_(std::move(interrupted)) { restart_clock(); }

  [[nodiscard]] automata::Ticks now() const override;
  [[nodiscard]] bool connected() const override { return socket_.open(); }
  std::size_t send(std::string_view bytes) override;
  News wait(automata::Ticks until, bool to_send, std::string& bytes) override;

 protected:
  /// The run starts now.
  void restart_clock() { start_ = std::chrono::steady_clock::now(); }
  void connect(Descriptor socket) { socket_ = std::move(socket); }
  /// The plant has ended the connection: `socket_` is closed after this.
  virtual void on_gone() = 0;
  /// Another plant may have come: looks without waiting, and says whether it is connected now.
  virtual bool look_for_another() { return false; }
  /// Adds what to wait for besides the plant: what can be read.
  virtual void await_also(std::vector<pollfd>& /*wanted*/) {}
  [[nodiscard]] bool interrupted() const { return interrupted_(); }
  [[nodiscard]] int socket() const { return socket_.number(); }

 private:
  News receive(std::string& bytes);
  void gather(bool to_send);

  std::function<bool()> interrupted_;
  std::chrono::steady_clock::time_point start_;
  Descriptor socket_;
  std::vector<pollfd> awaited_;  ///< the socket, then what is waited for besides it
};

}  // namespace rmpl::tools
