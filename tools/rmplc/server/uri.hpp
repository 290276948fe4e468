// File URIs and paths (RFC 8089, RFC 3986).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::tools {

/// The path of a file URI, percent-decoded; nothing where it is of another scheme or host, or holds a NUL.
std::optional<std::string> path_of_uri(std::string_view uri);

/// The URI of an absolute path.
std::string uri_of_path(std::string_view path);

}  // namespace rmpl::tools
