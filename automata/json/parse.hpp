// JSON texts, read strictly; and where in a text a value stands.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace rmpl::automata {

using Json = nlohmann::ordered_json;

/// An empty object with room for so many members: one that outgrows its room copies all that is in it.
Json object_with_room(std::size_t members);

/// What is wrong with a value of a JSON text. The message begins with its path.
class JsonError : public base::InputError {
 public:
  enum class Blame { value, key };  ///< the value itself, or the key before it

  /// `path` is a JSON pointer (RFC 6901), empty for the whole text.
  JsonError(std::string path, const std::string& message, Blame blame = Blame::value)
      : base::InputError((path.empty() ? "/" : path) + ": " + message), path_(std::move(path)), blame_(blame) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] Blame blame() const { return blame_; }

 private:
  std::string path_;
  Blame blame_;
};

/// The path of a member: `path` and its key, escaped as RFC 6901 has it.
std::string member_path(const std::string& path, std::string_view key);

/// Parses a text. Throws Json::parse_error where it is no JSON, and JsonError where an object has a key twice, which
/// the parser by itself would pass over.
Json parse_json(std::string_view text);

/// Values from the whole text down to one within it.
using JsonLevels = std::vector<Json*>;
using JsonClosed = std::function<void(const JsonLevels&)>;

/// The value of a text that `scan_json` is sure of; else nothing. Throws JsonError as `parse_json` does. `closed` is
/// shown each object at `depth`, 1 for the whole text and 0 for none, as it ends, with all that it is in, of which it
/// is the last; it may take it out.
std::optional<Json> scan_json_value(std::string_view text, std::size_t depth = 0, const JsonClosed& closed = nullptr);

/// The bytes of a text from `begin` to `end`.
struct JsonPlace {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where the value of a path, or its key, stands in a text that is JSON: of a key that is there twice, the last; of an
/// object or an array, the bracket that opens it. A path that leads nowhere has the place of what it leads furthest to.
/// Walks the text; meant for messages.
JsonPlace place_of(std::string_view text, std::string_view path, JsonError::Blame blame);

}  // namespace rmpl::automata
