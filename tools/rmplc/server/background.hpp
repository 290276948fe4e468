// Background work of the server, in a child process that can be dropped at any moment.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace rmpl::tools {

/// A child that has a copy of all that we know, and gives one text. Dropping it ends it at once.
class Background {
 public:
  /// Starts `work`. Where there is no process to be had, the answer is empty.
  explicit Background(const std::function<std::string()>& work);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background();

  /// Is readable when there is something to take.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Takes what has come. The answer once it is whole; it is empty where the work failed.
  std::optional<std::string> take();

 private:
  /// Waits for its end; whether that was a good one.
  bool reap();

  pid_t child_ = -1;
  int descriptor_ = -1;
  std::string answer_;
};

}  // namespace rmpl::tools
