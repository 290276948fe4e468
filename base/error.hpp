// The world's failure, or an input that is no model: one exception type, caught once in each main, exit code 2.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace rmpl::base {

/// What is wrong with an input or with the world (files, JSON, names that do not match). The message is lower case and
/// names the thing, where it is, and what was expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rmpl::base
