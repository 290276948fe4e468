// Names of requirements: some text, once.
// SPDX-License-Identifier: MIT
#include "compiler/lower/requirements.hpp"

#include <string_view>

namespace rmpl::compiler {

using grammar::Code;

namespace {

/// Blanks around it would make another requirement of what reads alike.
bool is_name(const std::string& tag) {
  constexpr std::string_view blanks = " \t\r\n";
  return !tag.empty() && blanks.find(tag.front()) == std::string_view::npos &&
         blanks.find(tag.back()) == std::string_view::npos;
}

}  // namespace

std::vector<std::string> fresh_tags(const std::vector<grammar::String>& tags, TagPlaces& known,
                                    grammar::Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const grammar::String& tag : tags) {
    if (!is_name(tag.text)) {
      const bool empty = tag.text.find_first_not_of(" \t\r\n") == std::string::npos;
      auto& error =
          diagnostics.error(Code::requirement_without_name, tag.span,
                            empty ? "the requirement has no name" : "the requirement begins or ends with a blank");
      error.suggestion = "write it as it is listed, as in `requirement \"FDIR-12\"`";
      continue;
    }
    const auto [first, fresh] = known.emplace(tag.text, tag.span);
    if (fresh) {
      result.push_back(tag.text);
      continue;
    }
    auto& warning =
        diagnostics.warning(Code::requirement_twice, tag.span, "requirement \"" + tag.text + "\" is named twice");
    warning.notes.push_back({first->second, "the first is here"});
  }
  return result;
}

}  // namespace rmpl::compiler
