// Percent-encoding of RFC 3986.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// A path as it stands in a URI: all but letters, digits and `-._~/` as `%` and two hexadecimal digits a byte.
std::string percent_encoded(std::string_view path);

}  // namespace rmpl::base
