// Statements of DOT, and its two ways of escaping.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/dot.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "base/printable.hpp"

namespace rmpl::compiler {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Words and numbers of the grammar; its keywords are none, in any case of letters, and neither is a number that an
/// identifier follows.
bool stands_bare(std::string_view text) {
  constexpr std::array<std::string_view, 6> keywords{"node", "edge", "graph", "digraph", "subgraph", "strict"};
  if (text.empty()) return false;
  if (std::all_of(text.begin(), text.end(), is_digit)) return true;
  if (!is_letter(text.front())) return false;
  if (!std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); })) return false;
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(keywords.begin(), keywords.end(), lower) == keywords.end();
}

std::string in_list(const DotAttributes& attributes) {
  std::string text;
  for (const DotAttribute& attribute : attributes) {
    text += (text.empty() ? " [" : ", ") + std::string(attribute.name) + "=" + attribute.value;
  }
  return text.empty() ? text : text + "]";
}

}  // namespace

std::string dot_value(std::string_view text) {
  if (stands_bare(text)) return std::string(text);
  std::string result = "\"";
  for (const char c : base::printable(text)) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string dot_tooltip(std::string_view text) { return dot_value(escaped(text)); }

std::string dot_label(std::string_view markup) { return "<" + std::string(markup) + ">"; }

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : base::printable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\\':
        // Graphviz replaces `\N` once, or twice, or not at all: a blank of no width parts it.
        result += "&#92;&#8203;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

DotText::DotText(std::string_view name) : text_("digraph " + dot_value(name) + " {\n") {}

void DotText::set(const DotAttributes& attributes) {
  for (const DotAttribute& attribute : attributes) {
    text_ += margin_ + std::string(attribute.name) + "=" + attribute.value + ";\n";
  }
}

void DotText::statement(std::string_view subject, const DotAttributes& attributes) {
  text_ += margin_ + std::string(subject) + in_list(attributes) + ";\n";
}

void DotText::defaults(std::string_view kind, const DotAttributes& attributes) { statement(kind, attributes); }
void DotText::node(std::string_view id, const DotAttributes& attributes) { statement(id, attributes); }

void DotText::edge(std::string_view from, std::string_view to, const DotAttributes& attributes) {
  statement(std::string(from) + " -> " + std::string(to), attributes);
}

void DotText::open_cluster(std::string_view id, const DotAttributes& attributes) {
  text_ += margin_ + "subgraph cluster_" + std::string(id) + " {\n";
  margin_ += "  ";
  set(attributes);
}

void DotText::close_cluster() {
  CHECK(margin_.size() > 2 && "a cluster is open");
  margin_.resize(margin_.size() - 2);
  text_ += margin_ + "}\n";
}

std::string DotText::finish() {
  CHECK(margin_.size() == 2 && "every cluster is closed");
  return text_ + "}\n";
}

}  // namespace rmpl::compiler
