// Frames: headers are read line by line, messages by their length.
// SPDX-License-Identifier: MIT
#include "tools/shared/framing.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

namespace rmpl::tools {
namespace {

constexpr std::size_t line_limit = 4096;
constexpr std::string_view length_field = "content-length";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool is_length_field(std::string_view name) {
  return std::equal(name.begin(), name.end(), length_field.begin(), length_field.end(),
                    [](char a, char b) { return lower(a) == b; });
}

}  // namespace

void Frames::feed(std::string_view bytes) {
  const std::size_t skipped = std::min(to_skip_, bytes.size());
  to_skip_ -= skipped;
  bytes.remove_prefix(skipped);
  if (at_ > 0 && at_ >= pending_.size() / 2) {
    pending_.erase(0, at_);
    at_ = 0;
  }
  pending_.append(bytes);
}

std::optional<Frame> Frames::next() {
  if (!length_) {
    if (auto wrong = read_header()) return wrong;
    if (!length_) return std::nullopt;
  }
  if (*length_ > message_limit) {
    const std::size_t here = std::min(*length_, pending_.size() - at_);
    at_ += here;
    to_skip_ = *length_ - here;
    const std::string length = std::to_string(*length_);
    length_.reset();
    return Frame{
        {},
        "a message of " + length + " bytes; expected at most " + std::to_string(message_limit) + ", it is passed over"};
  }
  if (pending_.size() - at_ < *length_) return std::nullopt;
  Frame frame{pending_.substr(at_, *length_), {}};
  at_ += *length_;
  length_.reset();
  return frame;
}

std::optional<Frame> Frames::read_header() {
  while (true) {
    const std::size_t end = pending_.find('\n', at_);
    const bool no_line = end == std::string::npos;
    if (no_line && pending_.size() - at_ <= line_limit) return std::nullopt;
    if (no_line || end - at_ > line_limit) {
      at_ = no_line ? pending_.size() : end + 1;
      field_.reset();
      if (std::exchange(garbage_, true)) continue;
      return Frame{{}, "expected a header `Content-Length: …`, found a line of more than 4096 bytes"};
    }
    std::string_view line(pending_.data() + at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at_ = end + 1;
    if (!line.empty()) {
      take_field(line);
    } else if (field_) {
      length_ = field_;
      field_.reset();
      garbage_ = false;
      return std::nullopt;
    } else if (!std::exchange(garbage_, true)) {
      return Frame{{}, "expected a header `Content-Length: …` with the length of the message in bytes"};
    }
  }
}

void Frames::take_field(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || !is_length_field(trimmed(line.substr(0, colon)))) return;
  const std::string_view text = trimmed(line.substr(colon + 1));
  std::size_t length = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (text.empty() || end != text.data() + text.size()) return;
  if (failure == std::errc()) field_ = length;
}

std::string framed(std::string_view message) {
  std::string frame = "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n";
  frame += message;
  return frame;
}

}  // namespace rmpl::tools
