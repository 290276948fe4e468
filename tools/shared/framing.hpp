// The frames of the protocol in a stream of bytes: a header with a length, then a message.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rmpl::tools {

/// The longest message that is taken, in bytes: longer ones are passed over, and answered with an error.
inline constexpr std::size_t message_limit = 64u << 20;

/// What was found in the stream: a message, or what is wrong where one was expected.
struct Frame {
  std::string message;
  std::string wrong;  ///< empty where there is a message
};

/// Takes bytes as they come and gives frames. After garbage it goes on at the next header.
class Frames {
 public:
  void feed(std::string_view bytes);
  /// The next whole frame, or nothing until more bytes come.
  std::optional<Frame> next();

 private:
  /// The end of the header that is being read, with its length; or what is wrong with it.
  std::optional<Frame> read_header();
  void take_field(std::string_view line);

  std::string pending_;
  std::size_t at_ = 0;                 ///< of `pending_`, what has been taken
  std::optional<std::size_t> length_;  ///< of the message, once its header has been read
  std::optional<std::size_t> field_;   ///< the length in a header that is not yet at its end
  std::size_t to_skip_ = 0;            ///< of a message that is too long
  bool garbage_ = false;               ///< between what is no header and the next one
};

/// A message with its header.
std::string framed(std::string_view message);

}  // namespace rmpl::tools
