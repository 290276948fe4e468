// A limit was hit: one exception type, caught once above main, exit code 3.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace rmpl::base {

/// There is no answer within a limit. The message is lower case and names the limit, where it was hit, and the way out.
class LimitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rmpl::base
