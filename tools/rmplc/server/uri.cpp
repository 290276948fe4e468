// Percent-encoding and its undoing.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/uri.hpp"

#include "base/percent.hpp"

namespace rmpl::tools {
namespace {

constexpr std::string_view scheme = "file://";

int value_of(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  return -1;
}

}  // namespace

std::optional<std::string> path_of_uri(std::string_view uri) {
  if (!uri.starts_with(scheme)) return std::nullopt;
  uri.remove_prefix(scheme.size());
  if (uri.starts_with("localhost/")) uri.remove_prefix(std::string_view("localhost").size());
  if (!uri.starts_with('/')) return std::nullopt;
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool encoded = uri[i] == '%' && i + 2 < uri.size() && value_of(uri[i + 1]) >= 0 && value_of(uri[i + 2]) >= 0;
    path += encoded ? static_cast<char>(value_of(uri[i + 1]) * 16 + value_of(uri[i + 2])) : uri[i];
    if (path.back() == '\0') return std::nullopt;
    if (encoded) i += 2;
  }
  return path;
}

std::string uri_of_path(std::string_view path) { return std::string(scheme) + base::percent_encoded(path); }

}  // namespace rmpl::tools
