// The one style of the five languages: a text laid out anew, with all its tokens and comments.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/session/kind.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// The columns of a line, counted in code points. What cannot be broken (a name, a comment, a string) may reach beyond.
inline constexpr std::size_t line_width = 120;

/// The text of `sources[file]` in the one style; nothing where it has syntax errors, and then they are reported. The
/// kind is one of the five languages.
///
/// The tokens and the comments stay, each as it is spelled and in their order; at most one blank line stays between
/// statements. Where lines break and what is aligned follows from the tokens alone. Formatting what is formatted gives
/// the same. That tokens, comments and the tree are those of the text is checked before anything is returned (CHECK).
/// Linear in the length of the text.
std::optional<std::string> format(const grammar::Sources& sources, std::uint32_t file, Kind kind,
                                  grammar::Diagnostics& diagnostics);

/// The same for a text by itself, without its diagnostics: for an editor, which has them already.
std::optional<std::string> format(std::string_view text, Kind kind);

}  // namespace rmpl::compiler
