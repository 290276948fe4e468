// What all diagrams look like: one sheet of colours and sizes, and texts in lines.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "automata/origin.hpp"
#include "compiler/diagram/dot.hpp"

namespace rmpl::compiler::style {

inline constexpr std::string_view ink = "#1f2328";
inline constexpr std::string_view faint = "#6e7781";
inline constexpr std::string_view line = "#57606a";
inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view shade = "#f6f8fa";
inline constexpr std::string_view goal = "#ddebfa";
inline constexpr std::string_view clock = "#fdf1cf";
inline constexpr std::string_view command = "#0a5cc2";
inline constexpr std::string_view sensor = "#1a7f37";
inline constexpr std::string_view fault = "#b3261e";
inline constexpr std::string_view fault_shade = "#fdf2f1";

/// Where the lines of a text stand in a label.
enum class Align { left, center };

/// The text in lines of at most `width` characters where that can be: broken behind connectives and commas.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// A name in lines of at most `width` characters where that can be: broken behind dots, underscores and hyphens.
std::vector<std::string> broken_name(std::string_view name, std::size_t width);

/// ` (mars_entry.rmpl:7)`, without the folders of the file, so that a picture that is kept beside its source is the
/// same wherever both stand; empty where there is no source.
std::string place_in_parentheses(const automata::Origin& origin);

/// Lines as markup; `tag`, as in `B` or `O`, is put around each.
std::string lines(const std::vector<std::string>& texts, Align align, std::string_view tag = {});

/// Markup as the label of an arrow, with room to the arrow's line.
std::string beside_arrow(std::string_view markup);

/// Markup in a colour and of a size in points.
std::string in_font(std::string_view markup, std::string_view color, std::size_t size);

/// A graph with the fonts and colours of all figures; `direction` as `rankdir` has it.
DotText begin(std::string_view name, std::string_view direction);

/// Sets the line at the top of a figure: what it shows, in bold, and of what kind it is.
void caption(DotText& dot, std::string_view name, std::string_view kind);

}  // namespace rmpl::compiler::style
