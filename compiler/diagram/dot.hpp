// DOT, the language of Graphviz, as it is written: statements in order, everything escaped.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rmpl::compiler {

/// A value in DOT: a word or a number as it is, anything else in quotes, with the ends of lines as Graphviz writes
/// them.
std::string dot_value(std::string_view text);

/// An HTML-like label: `markup` is written with `escaped` and tags.
std::string dot_label(std::string_view markup);

/// A text inside of markup. What Graphviz would replace in labels and tooltips, as `\N`, stays what it is.
std::string escaped(std::string_view text);

/// A text that is shown where one points at something.
std::string dot_tooltip(std::string_view text);

/// An attribute; `value` is what `dot_value` or `dot_label` made.
struct DotAttribute {
  std::string_view name;
  std::string value;
};
using DotAttributes = std::vector<DotAttribute>;

/// One directed graph with clusters, one statement a line. Identifiers of nodes and clusters are words.
class DotText {
 public:
  explicit DotText(std::string_view name);

  /// Attributes of the graph or cluster that is open, one a line.
  void set(const DotAttributes& attributes);
  /// What all nodes, or all edges (`kind`), have from here on.
  void defaults(std::string_view kind, const DotAttributes& attributes);
  void node(std::string_view id, const DotAttributes& attributes);
  void edge(std::string_view from, std::string_view to, const DotAttributes& attributes);
  void open_cluster(std::string_view id, const DotAttributes& attributes);
  void close_cluster();
  /// The whole text. Every cluster is closed.
  [[nodiscard]] std::string finish();

 private:
  void statement(std::string_view subject, const DotAttributes& attributes);

  std::string text_;
  std::string margin_ = "  ";
};

}  // namespace rmpl::compiler
