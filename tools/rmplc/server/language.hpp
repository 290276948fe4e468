// Which language a document is in, and what kinds of names are called in the list of words.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/session/names.hpp"
#include "grammar/editor/keywords.hpp"

namespace rmpl::tools {

/// By the ending of the name.
std::optional<grammar::Language> language_of(const std::string& path);

/// `definition`, `mode` …
std::string_view name_of(compiler::NameKind kind);

}  // namespace rmpl::tools
