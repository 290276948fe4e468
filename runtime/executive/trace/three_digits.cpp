// Three digits of a number.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/three_digits.hpp"

#include <array>
#include <charconv>

namespace rmpl::runtime {

std::string three_digits(double probability) {
  if (probability < 1 && probability > 0.9995) return ">0.999";
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), probability, std::chars_format::general, 3);
  return {digits.data(), end.ptr};
}

}  // namespace rmpl::runtime
