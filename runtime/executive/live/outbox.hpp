// What is to be sent to a plant that reads when it likes: bounded, the newest line first.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "runtime/executive/live/channel.hpp"

namespace rmpl::runtime {

/// A line that was begun is finished, for half a line would garble the next. Of those that were not, only the newest
/// waits: a command is of no use once its cycle is over.
class Outbox {
 public:
  /// `line` ends with a line feed.
  void put(std::string line) { next_ = std::move(line); }
  void clear() { begun_.clear(), next_.clear(); }
  void send(Channel& channel) {
    while (!empty()) {
      if (begun_.empty()) begun_ = std::exchange(next_, {});
      const std::size_t sent = channel.send(begun_);
      begun_.erase(0, sent);
      if (!begun_.empty()) return;
    }
  }
  [[nodiscard]] bool empty() const { return begun_.empty() && next_.empty(); }

 private:
  std::string begun_;  ///< the rest of a line
  std::string next_;   ///< a whole line; empty where there is none
};

}  // namespace rmpl::runtime
