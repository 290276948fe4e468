// Fonts, colours, and where a line of a constraint may end.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/style.hpp"

#include <filesystem>

#include "automata/place.hpp"

namespace rmpl::compiler::style {
namespace {

/// Whether a line may end with the last word of a piece. Lists are broken only where they are long.
bool ends_line(std::string_view word, std::size_t length, std::size_t width) {
  if (word == "&" || word == "|" || word == "->" || word == "<->") return true;
  return !word.empty() && word.back() == ',' && length > width / 2;
}

constexpr std::string_view font = "Helvetica,Arial,sans-serif";

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> result;
  std::string filled;  // what is in the line for good
  std::string piece;   // what must stand together
  const auto take_piece = [&] {
    if (!filled.empty() && filled.size() + 1 + piece.size() > width) {
      result.push_back(filled);
      filled.clear();
    }
    filled += (filled.empty() ? "" : " ") + piece;
    piece.clear();
  };
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    const std::string_view word = text.substr(0, blank);
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
    piece += (piece.empty() ? "" : " ") + std::string(word);
    if (ends_line(word, piece.size(), width)) take_piece();
  }
  if (!piece.empty()) take_piece();
  if (!filled.empty()) result.push_back(filled);
  return result;
}

std::vector<std::string> broken_name(std::string_view name, std::size_t width) {
  std::vector<std::string> result;
  while (name.size() > width) {
    const std::size_t end = name.find_last_of("._-", width - 1);
    if (end == std::string_view::npos) break;
    result.emplace_back(name.substr(0, end + 1));
    name.remove_prefix(end + 1);
  }
  result.emplace_back(name);
  return result;
}

std::string place_in_parentheses(const automata::Origin& origin) {
  return automata::in_parentheses({std::filesystem::path(origin.file).filename().string(), origin.line, origin.column});
}

std::string lines(const std::vector<std::string>& texts, Align align, std::string_view tag) {
  const std::string open = tag.empty() ? "" : "<" + std::string(tag) + ">";
  const std::string close = tag.empty() ? "" : "</" + std::string(tag) + ">";
  // An overbar reaches above its line: without room between them it would strike through the line before.
  const std::string room = tag == "O" ? R"(<FONT POINT-SIZE="4">&#160;</FONT>)" : "";
  const std::string end = align == Align::left ? R"(<BR ALIGN="LEFT"/>)" : "<BR/>";
  std::string result;
  for (const std::string& text : texts) {
    if (!result.empty()) result += (align == Align::left ? "" : end) + (room.empty() ? "" : room + end);
    result += open + escaped(text) + close + (align == Align::left ? end : "");
  }
  return result;
}

std::string beside_arrow(std::string_view markup) {
  return R"(<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0" CELLPADDING="3"><TR><TD BALIGN="LEFT">)" +
         std::string(markup) + "</TD></TR></TABLE>";
}

std::string in_font(std::string_view markup, std::string_view color, std::size_t size) {
  if (markup.empty()) return {};
  return "<FONT COLOR=\"" + std::string(color) + "\" POINT-SIZE=\"" + std::to_string(size) + "\">" +
         std::string(markup) + "</FONT>";
}

DotText begin(std::string_view name, std::string_view direction) {
  DotText dot(name);
  dot.set({{"rankdir", dot_value(direction)},
           {"compound", dot_value("true")},
           {"bgcolor", dot_value(paper)},
           {"fontname", dot_value(font)},
           {"fontcolor", dot_value(ink)},
           {"fontsize", dot_value("10")}});
  dot.defaults("node", {{"fontname", dot_value(font)},
                        {"fontcolor", dot_value(ink)},
                        {"fontsize", dot_value("10")},
                        {"color", dot_value(line)}});
  dot.defaults("edge", {{"fontname", dot_value(font)},
                        {"fontcolor", dot_value(ink)},
                        {"fontsize", dot_value("9")},
                        {"color", dot_value(line)},
                        {"arrowsize", dot_value("0.7")}});
  return dot;
}

void caption(DotText& dot, std::string_view name, std::string_view kind) {
  dot.set({{"labelloc", dot_value("t")},
           {"label", dot_label("<B>" + in_font(escaped(name), ink, 13) + "</B>&#160;&#160;" +
                               in_font(escaped(kind), faint, 10))}});
}

}  // namespace rmpl::compiler::style
