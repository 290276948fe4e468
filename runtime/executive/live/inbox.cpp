// Lines, cut out of a buffer that holds little more than one.
// SPDX-License-Identifier: MIT
#include "runtime/executive/live/inbox.hpp"

#include <algorithm>

namespace rmpl::runtime {

std::optional<Inbox::Line> Inbox::next() {
  const std::size_t end = bytes_.find('\n', std::max(begin_, looked_));
  if (end == std::string::npos) {
    bytes_.erase(0, begin_);
    begin_ = 0;
    if (bytes_.size() > longest) too_long_ = true;
    if (too_long_) bytes_.clear();
    looked_ = bytes_.size();
    return std::nullopt;
  }
  Line line;
  line.too_long = too_long_ || end - begin_ > longest;
  if (!line.too_long) line.text = bytes_.substr(begin_, end - begin_);
  begin_ = looked_ = end + 1;
  too_long_ = false;
  return line;
}

}  // namespace rmpl::runtime
