// Layout in one walk: a value is measured up to the end of the line and no further.
// SPDX-License-Identifier: MIT
#include "automata/json/layout.hpp"

#include <cstddef>

namespace rmpl::automata {
namespace {

constexpr std::size_t width = 120;

class Layout {
 public:
  std::string run(const Json& json) {
    write(json, 0, 0);
    return std::move(text_);
  }

 private:
  /// `indent` is that of the line, `behind` what has to stand behind the value on its line.
  void write(const Json& json, std::size_t indent, std::size_t behind) {
    if (!json.is_structured() || json.empty()) {
      text_ += json.dump();
      return;
    }
    const std::size_t before = text_.size();
    if (before + behind < line_ + width && on_line(json, line_ + width - behind)) return;
    text_.resize(before);
    text_ += json.is_object() ? '{' : '[';
    bool first = true;
    for (auto item = json.begin(); item != json.end(); ++item) {
      if (!first) text_ += ',';
      first = false;
      text_ += '\n';
      line_ = text_.size();
      text_.append(indent + 2, ' ');
      if (json.is_object()) write_key(item.key());
      write(*item, indent + 2, 1);
    }
    text_ += '\n';
    line_ = text_.size();
    text_.append(indent, ' ');
    text_ += json.is_object() ? '}' : ']';
  }

  /// Writes the value on the line; false where the text would be longer than `limit`, and then not to the end.
  bool on_line(const Json& json, std::size_t limit) {
    if (!json.is_structured()) {
      text_ += json.dump();
      return text_.size() <= limit;
    }
    text_ += json.is_object() ? '{' : '[';
    bool first = true;
    for (auto item = json.begin(); item != json.end(); ++item) {
      if (!first) text_ += ", ";
      first = false;
      if (json.is_object()) write_key(item.key());
      if (!on_line(*item, limit)) return false;
    }
    text_ += json.is_object() ? '}' : ']';
    return text_.size() <= limit;
  }

  void write_key(const std::string& key) {
    text_ += Json(key).dump();
    text_ += ": ";
  }

  std::string text_;
  std::size_t line_ = 0;  ///< where it begins
};

}  // namespace

std::string laid_out(const Json& json) { return Layout().run(json); }

}  // namespace rmpl::automata
