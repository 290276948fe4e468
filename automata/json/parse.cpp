// Strict parsing, and a walk through the text for the place of a value.
// SPDX-License-Identifier: MIT
#include "automata/json/parse.hpp"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <vector>

namespace rmpl::automata {
namespace {

/// A compiled document has objects of a dozen keys, a log one for each component or variable.
constexpr std::size_t key_limit = 10'000;

/// An object or array that is open while a text is parsed.
struct Open {
  bool object = false;
  std::unordered_set<std::string> keys;  ///< so far, of an object
  std::string key;                       ///< the last
  std::size_t items = 0;                 ///< begun so far, of an array
};

std::string path_of(const std::vector<Open>& open) {
  std::string path;
  for (const Open& level : open) path = member_path(path, level.object ? level.key : std::to_string(level.items - 1));
  return path;
}

/// Walks a text that is known to be JSON.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
    skip_blank();
  }

  [[nodiscard]] char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] std::size_t at() const { return at_; }
  void go_to(std::size_t at) { at_ = at; }

  /// One character, and the blank behind it.
  void skip_sign() {
    ++at_;
    skip_blank();
  }

  JsonPlace skip_string() {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    const JsonPlace place{begin, std::min(++at_, text_.size())};
    skip_blank();
    return place;
  }

  /// A value with all that is in it.
  JsonPlace skip_value() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    std::size_t depth = 0;
    do {
      if (here() == '"') {
        end = skip_string().end;
        continue;
      }
      if (here() == '{' || here() == '[') ++depth;
      if ((here() == '}' || here() == ']') && --depth == 0) {
        end = at_ + 1;
        skip_sign();
        break;
      }
      if (depth == 0) {
        end = at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
        skip_blank();
      } else {
        skip_sign();
      }
    } while (depth > 0 && at_ < text_.size());
    return {begin, end};
  }

 private:
  void skip_blank() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  std::string_view text_;
  std::size_t at_ = 0;
};

struct Member {
  JsonPlace key;
  std::size_t value = 0;  ///< where it begins
};

/// The last member of the object at the walk's place that has this key; `key` is as a path writes it.
std::optional<Member> member(Walk walk, std::string_view text, std::string_view key) {
  std::optional<Member> found;
  walk.skip_sign();
  while (walk.here() == '"') {
    const JsonPlace place = walk.skip_string();
    walk.skip_sign();  // the colon
    const auto name = Json::parse(text.substr(place.begin, place.end - place.begin)).get<std::string>();
    if (member_path("", name).substr(1) == key) found = {place, walk.at()};
    walk.skip_value();
    if (walk.here() == ',') walk.skip_sign();
  }
  return found;
}

/// The item of the array at the walk's place with this number.
std::optional<Member> item(Walk walk, std::string_view number) {
  walk.skip_sign();
  for (std::size_t i = 0; walk.here() != ']' && walk.here() != '\0'; ++i) {
    const std::size_t begin = walk.at();
    const JsonPlace place = walk.skip_value();
    if (std::to_string(i) == number) return Member{place, begin};
    if (walk.here() == ',') walk.skip_sign();
  }
  return std::nullopt;
}

}  // namespace

std::string member_path(const std::string& path, std::string_view key) {
  std::string result = path + "/";
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

Json parse_json(std::string_view text) {
  using Event = Json::parse_event_t;
  std::vector<Open> open;
  std::optional<JsonError> error;
  const auto callback = [&](int, Event event, Json& parsed) {
    const bool begins = event == Event::object_start || event == Event::array_start;
    if ((begins || event == Event::value) && !open.empty()) ++open.back().items;
    if (begins) open.push_back({event == Event::object_start, {}, {}, 0});
    if (event == Event::object_end || event == Event::array_end) open.pop_back();
    if (event == Event::key) {
      open.back().key = parsed.get<std::string>();
      // What is not kept costs no look-up: an object is searched from its start for each key that it gets.
      if (!open.back().keys.insert(open.back().key).second) {
        const std::string reason = "the key '" + open.back().key + "' stands twice in one object";
        if (!error) error = JsonError(path_of(open), reason, JsonError::Blame::key);
        return false;
      }
      if (open.back().keys.size() > key_limit) {
        open.back().keys.erase(open.back().key);
        const std::string reason = "expected an object of at most " + std::to_string(key_limit) + " keys";
        if (!error) error = JsonError(path_of({open.begin(), open.end() - 1}), reason);
        return false;
      }
    }
    return true;
  };
  Json json = Json::parse(text, callback);
  if (error) throw JsonError(*error);
  return json;
}

JsonPlace place_of(std::string_view text, std::string_view path, JsonError::Blame blame) {
  Walk walk(text);
  std::optional<JsonPlace> key;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/', 1), path.size());
    const std::string_view name = path.substr(1, end - 1);
    const auto next = walk.here() == '{'   ? member(walk, text, name)
                      : walk.here() == '[' ? item(walk, name)
                                           : std::nullopt;
    if (!next) break;
    key = next->key;
    walk.go_to(next->value);
    path.remove_prefix(end);
  }
  if (blame == JsonError::Blame::key && path.empty() && key) return *key;
  const std::size_t begin = walk.at();
  return walk.here() == '{' || walk.here() == '[' ? JsonPlace{begin, begin + 1} : walk.skip_value();
}

}  // namespace rmpl::automata
