// Strict parsing, and a walk through the text for the place of a value.
// SPDX-License-Identifier: MIT
#include "automata/json/parse.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "automata/json/scan.hpp"

namespace rmpl::automata {
namespace {

/// A compiled document has objects of a dozen keys, a log one for each component or variable.
constexpr std::size_t key_limit = 1'000'000;

/// Most objects have no more.
constexpr std::size_t usual_keys = 6;

/// Up to so many keys of an object are looked through one by one; more are looked up.
constexpr std::size_t few_keys = 16;

/// The keys of one object, looked up among its members.
class KeyTable {
 public:
  [[nodiscard]] bool contains(const Json::object_t& members, std::string_view name) {
    index(members);
    return slots_[slot_of(members, name)] != 0;
  }

 private:
  /// Takes in the members that came since.
  void index(const Json::object_t& members) {
    if (2 * members.size() >= slots_.size()) {
      slots_.assign(std::max<std::size_t>(4 * few_keys, 4 * std::bit_ceil(members.size())), 0);
      indexed_ = 0;
    }
    for (; indexed_ < members.size(); ++indexed_) {
      slots_[slot_of(members, members.begin()[static_cast<std::ptrdiff_t>(indexed_)].first)] =
          static_cast<std::uint32_t>(indexed_ + 1);
    }
  }
  /// Where the name is, or would be.
  [[nodiscard]] std::size_t slot_of(const Json::object_t& members, std::string_view name) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = std::hash<std::string_view>{}(name)&mask;
    while (slots_[slot] != 0 && members.begin()[slots_[slot] - 1].first != name) slot = (slot + 1) & mask;
    return slot;
  }

  std::vector<std::uint32_t> slots_;  ///< open addressing: position + 1, or 0; size a power of two
  std::size_t indexed_ = 0;           ///< so many members are in it
};

/// What is told of a text, made into a value. Every value is made where it stays: a vector does not grow while what is
/// at its back is open.
class Reader : public nlohmann::json_sax<Json> {
 public:
  /// As in `scan_json_value`.
  explicit Reader(std::size_t depth = 0, const JsonClosed& closed = nullptr) : depth_(depth), closed_(closed) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t& value) override { return add(std::move(value)); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override {
    if (open_.size() != depth_) return close();
    JsonLevels levels;
    for (const Open& level : open_) levels.push_back(level.value);
    close();
    closed_(levels);
    return true;
  }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    auto& members = open_.back().value->get_ref<Json::object_t&>();
    const bool twice = known(members, name);
    if (twice || members.size() >= key_limit) {
      refuse(name, twice);
      slot_ = &lost_.emplace_back();
      return true;
    }
    if (members.empty()) members.reserve(usual_keys);
    // Not `emplace`, which looks through all that are there.
    members.emplace_back(std::move(name), Json());
    slot_ = &members.back().second;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    if (const auto* syntax = dynamic_cast<const Json::parse_error*>(&error)) throw Json::parse_error(*syntax);
    throw Json::out_of_range(dynamic_cast<const Json::out_of_range&>(error));
  }

  /// Throws JsonError where an object was refused.
  Json take() {
    if (error_) throw JsonError(*error_);
    return std::move(root_);
  }

 private:
  struct Open {
    Json* value;
    KeyTable keys;  ///< so far, of an object with more than a few
  };

  bool known(const Json::object_t& members, const std::string& name) {
    if (members.size() <= few_keys) {
      return std::any_of(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
    }
    return open_.back().keys.contains(members, name);
  }

  /// Where the next value goes.
  Json& place() {
    if (open_.empty()) return root_;
    Json& parent = *open_.back().value;
    if (parent.is_object()) return *slot_;
    parent.get_ref<Json::array_t&>().emplace_back();
    return parent.back();
  }
  template <class Value>
  bool add(Value&& value) {
    place() = Json(std::forward<Value>(value));
    return true;
  }
  bool open(Json&& empty) {
    Json& here = place();
    here = std::move(empty);
    open_.push_back({&here, {}});
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  /// A syntax error further on is told in its place.
  void refuse(const std::string& name, bool twice) {
    if (error_) return;
    std::string path;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Json& level = *open_[i].value;
      path = member_path(path, level.is_object() ? level.get_ref<const Json::object_t&>().back().first
                                                 : std::to_string(level.size() - 1));
    }
    if (twice) {
      error_.emplace(member_path(path, name), "the key '" + name + "' stands twice in one object",
                     JsonError::Blame::key);
    } else {
      error_.emplace(path, "expected an object of at most " + std::to_string(key_limit) + " keys");
    }
  }

  Json root_;
  std::vector<Open> open_;
  Json* slot_ = nullptr;   ///< of the last key
  std::deque<Json> lost_;  ///< in place of what is refused, which may be refused within what is refused
  std::optional<JsonError> error_;
  std::size_t depth_;  ///< of objects that are told of as they end; 0 where none is
  JsonClosed closed_;
};

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

Json object_with_room(std::size_t members) {
  Json object = Json::object();
  object.get_ref<Json::object_t&>().reserve(members);
  return object;
}

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

std::optional<Json> scan_json_value(std::string_view text, std::size_t depth, const JsonClosed& closed) {
  Reader reader(depth, closed);
  return scan_json(text, reader) ? std::optional(reader.take()) : std::nullopt;
}

Json parse_json(std::string_view text) {
  if (auto quick = scan_json_value(text)) return std::move(*quick);
  // The library tells what is wrong, or reads what is rare.
  Reader reader;
  Json::sax_parse(text, &reader);
  return reader.take();
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
