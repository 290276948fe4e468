// A place in a JSON input, with its path: every look-up that fails says where and what was expected.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/json/parse.hpp"
#include "automata/time/time.hpp"
#include "base/nearest.hpp"
#include "base/printable.hpp"

namespace rmpl::automata {

/// A value of a JSON document. Cheap to copy; refers to the document. The path that leads to it is found where it has
/// to be told.
class Node {
 public:
  explicit Node(const Json& root) : json_(&root), root_(&root) {}

  [[noreturn]] void fail(const std::string& expected) const { throw JsonError(path(), "expected " + expected); }
  /// Fails where this is an object with a key that is none of these.
  void only(std::initializer_list<std::string_view> keys) const {
    if (!json_->is_object()) fail("an object");
    for (const auto& [key, value] : json_->get_ref<const Json::object_t&>()) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      throw JsonError(member_path(path(), key), "unknown key '" + key + "'" + base::suggestion(key, std::vector(keys)),
                      JsonError::Blame::key);
    }
  }
  [[nodiscard]] const Json& json() const { return *json_; }
  [[nodiscard]] bool has(std::string_view key) const { return json_->is_object() && json_->contains(key); }
  [[nodiscard]] Node at(std::string_view key) const {
    if (!json_->is_object()) fail("an object");
    const auto found = json_->find(key);
    if (found == json_->end()) fail("the key '" + std::string(key) + "'");
    return {*found, *root_};
  }
  [[nodiscard]] std::vector<Node> items() const {
    if (!json_->is_array()) fail("an array");
    std::vector<Node> nodes;
    nodes.reserve(json_->size());
    for (const Json& item : *json_) nodes.push_back({item, *root_});
    return nodes;
  }
  [[nodiscard]] const std::string& text() const {
    if (!json_->is_string()) fail("a string");
    const auto& result = json_->get_ref<const std::string&>();
    // A text of the source may have several lines.
    const auto refused = [](char c) { return base::is_control(c) && c != '\n' && c != '\t'; };
    if (std::any_of(result.begin(), result.end(), refused)) fail("a string without control characters");
    return result;
  }
  [[nodiscard]] bool truth() const {
    if (!json_->is_boolean()) fail("true or false");
    return json_->get<bool>();
  }
  [[nodiscard]] double number() const {
    if (!json_->is_number() || !std::isfinite(json_->get<double>())) fail("a number");
    return json_->get<double>();
  }
  [[nodiscard]] double probability() const {
    const double value = number();
    if (value < 0 || value > 1) fail("a probability, from 0 to 1");
    return value;
  }
  /// A whole number, at least 0.
  [[nodiscard]] std::uint64_t natural() const {
    if (!json_->is_number_integer() || (!json_->is_number_unsigned() && json_->get<std::int64_t>() < 0)) {
      fail("a whole number");
    }
    return json_->get<std::uint64_t>();
  }
  /// A whole number from 0 to `limit` - 1.
  [[nodiscard]] std::size_t index(std::size_t limit) const {
    if (natural() >= limit) fail(limit == 0 ? "nothing to refer to" : "a whole number below " + std::to_string(limit));
    return json_->get<std::size_t>();
  }
  /// Whole nanoseconds, or "inf".
  [[nodiscard]] Ticks ticks() const {
    if (json_->is_string() && *json_ == "inf") return Ticks::infinite();
    constexpr auto limit = static_cast<std::uint64_t>(Ticks::infinite().count);
    if (!json_->is_number_integer() || natural() >= limit) fail("a time in whole nanoseconds, or \"inf\"");
    return {json_->get<std::int64_t>()};
  }

 private:
  Node(const Json& json, const Json& root) : json_(&json), root_(&root) {}

  [[nodiscard]] std::string path() const { return path_in(*root_).value(); }
  /// The path that leads to this value from `tree`, which is looked through; nothing where it is not there.
  [[nodiscard]] std::optional<std::string> path_in(const Json& tree) const;

  const Json* json_;
  const Json* root_;
};

}  // namespace rmpl::automata
