// Lists in words.
// SPDX-License-Identifier: MIT
#include "base/enumerated.hpp"

namespace rmpl::base {

std::string enumerated(std::span<const std::string> names, std::string_view link) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " " + std::string(link) + " " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace rmpl::base
