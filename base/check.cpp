// The message of a check that failed.
// SPDX-License-Identifier: MIT
#include "base/check.hpp"

#include <string_view>

namespace rmpl::base {

void check_failed(const char* condition, const char* file, int line) {
  std::string_view place = file;
  const std::string_view here = __FILE__;
  if (place.substr(0, tree_path_length) == here.substr(0, tree_path_length)) place.remove_prefix(tree_path_length);
  // A compiler cache names files from the folder of the build, and units name them in full.
  while (place.starts_with("../")) place.remove_prefix(3);
  throw InternalError(std::string(place) + ":" + std::to_string(line) + ": expected " + condition);
}

}  // namespace rmpl::base
