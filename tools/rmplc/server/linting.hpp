// When units are linted: one after another, in the background, once the client is quiet.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "tools/rmplc/server/background.hpp"
#include "tools/rmplc/server/workspace.hpp"

namespace rmpl::tools {

/// What a server waits for besides its client.
struct Pause {
  int descriptor = -1;    ///< until it is readable; -1: none
  int milliseconds = -1;  ///< at most; -1: for ever
};

class Linting {
 public:
  /// How long to wait before `rest`. What an edit has overtaken is dropped.
  Pause pause(Workspace& workspace);
  /// The pause is over, and the client has said nothing. Whether there is something new to tell.
  bool rest(Workspace& workspace);
  /// What kept a unit from being linted, such as a wrong rmpl.ini, told once; empty: nothing.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

 private:
  std::weak_ptr<Analysis> subject_;
  std::unique_ptr<Background> running_;
  std::string complaint_;
};

}  // namespace rmpl::tools
