// CHECK: what the code relies on, looked at in every build.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace rmpl::base {

/// Our own mistake: a result failed its check, so nothing may be claimed. Caught once in each main, exit code 4.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws the InternalError of a condition that does not hold: `file:line: expected condition`.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

/// The length of the path of the tree in `__FILE__`: messages name files from the root of the tree.
inline constexpr std::size_t tree_path_length = sizeof(__FILE__) - sizeof("base/check.hpp");

}  // namespace rmpl::base

/// Where the condition does not hold, throws base::InternalError (and ends the program where nothing may be thrown).
/// No build flag removes it: the condition is evaluated once, always. `CHECK(found && "what is known about it")`.
#define CHECK(...) \
  (static_cast<bool>(__VA_ARGS__) ? static_cast<void>(0) : ::rmpl::base::check_failed(#__VA_ARGS__, __FILE__, __LINE__))
