// The way to a plant outside the process, whatever it is made of: a child's streams, a socket, or a test's script.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// Bytes to and from one plant at a time. Only `wait` and `revive` take time, and never beyond what they are given.
class Channel {
 public:
  enum class News {
    none,       ///< the time has come, or the run was interrupted
    connected,  ///< a plant is there that was not
    received,   ///< bytes have come
    sendable,   ///< bytes can be sent again
    gone        ///< the plant is there no longer; all that it had sent was received before
  };

  virtual ~Channel() = default;
  /// Of the machine's steady clock, since the start of the run.
  [[nodiscard]] virtual automata::Ticks now() const = 0;
  [[nodiscard]] virtual bool connected() const = 0;
  /// Sends what can be sent at once, and says how many bytes that was. A plant that turns out to be gone takes nothing,
  /// and `wait` tells.
  virtual std::size_t send(std::string_view bytes) = 0;
  /// The next news, or none at `until`. Looks at least once. `bytes` gets what was received, no more than 64 KiB;
  /// whether it can be sent is news only where it is `to_send`.
  virtual News wait(automata::Ticks until, bool to_send, std::string& bytes) = 0;
  /// At the start of a cycle, the `cycles`-th in a row in which no plant is there (from 1): does what may bring one,
  /// and waits for it until `until`.
  virtual void revive(std::uint64_t cycles, automata::Ticks until) = 0;
  /// Why the last plant is gone, as part of a sentence: `it ended with status 3`.
  [[nodiscard]] virtual std::string reason() const = 0;
};

}  // namespace rmpl::runtime
