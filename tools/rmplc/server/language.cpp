// Languages by file names, kinds of names by their words.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/language.hpp"

#include <filesystem>

namespace rmpl::tools {

std::optional<grammar::Language> language_of(const std::string& path) {
  using grammar::Language;
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const Language language : {Language::rmpl, Language::tcca, Language::scn, Language::props, Language::mon})
    if (extension == "." + std::string(grammar::to_string(language))) return language;
  return std::nullopt;
}

std::string_view name_of(compiler::NameKind kind) {
  using compiler::NameKind;
  switch (kind) {
    case NameKind::definition:
      return "definition";
    case NameKind::parameter:
      return "parameter";
    case NameKind::clock:
      return "clock";
    case NameKind::variable:
      return "variable";
    case NameKind::component:
      return "component";
    case NameKind::module:
      return "module";
    case NameKind::plant:
      return "plant";
    case NameKind::domain:
      return "domain";
    case NameKind::value:
      return "value";
    case NameKind::attribute:
      return "attribute";
    case NameKind::mode:
      return "mode";
    case NameKind::instance:
      return "instance";
    case NameKind::scenario:
      return "scenario";
    case NameKind::channel:
      return "channel";
  }
  return "";
}

}  // namespace rmpl::tools
