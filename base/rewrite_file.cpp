// Replacing a file that was read.
// SPDX-License-Identifier: MIT
#include "base/rewrite_file.hpp"

#include "base/output_file.hpp"

namespace rmpl::base {

void rewrite_file(const std::string& path, std::string_view text) {
  forget_input(path);
  write_file(path, text);
}

}  // namespace rmpl::base
