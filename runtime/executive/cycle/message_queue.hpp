// First in, first out.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace rmpl::runtime {

/// A queue of messages. Its memory is kept and reused whenever it has run empty, which it does in every cycle.
template <class Message>
class MessageQueue {
 public:
  void push(Message message) { messages_.push_back(std::move(message)); }

  /// The oldest message, or nothing when there is none.
  std::optional<Message> pop() {
    if (front_ == messages_.size()) {
      messages_.clear();
      front_ = 0;
      return std::nullopt;
    }
    return std::move(messages_[front_++]);
  }

 private:
  std::vector<Message> messages_;
  std::size_t front_ = 0;
};

}  // namespace rmpl::runtime
