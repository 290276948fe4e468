// Edits that do not get in each other's way, from the end of each text to its start.
// SPDX-License-Identifier: MIT
#include "compiler/lint/fixes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "compiler/format/format.hpp"
#include "compiler/session/kind.hpp"

namespace rmpl::compiler {

using grammar::Edit;

namespace {

/// Whether two edits change what the other one changes, or speak of one place in two ways: what goes on either side of
/// a place may go at once.
bool collide(const Edit& a, const Edit& b) {
  if (a.span.file != b.span.file) return false;
  if (a.text.empty() && b.text.empty()) return a.span.begin < b.span.end && b.span.begin < a.span.end;
  return a.span.begin <= b.span.end && b.span.begin <= a.span.end;
}

/// The changed text in the one style, where the text was before.
std::string in_style(const grammar::SourceFile& before, std::string after) {
  const auto kind = kind_by_name(before.name());
  if (!kind || *kind == Kind::document || format(before.text(), *kind) != before.text()) return after;
  std::optional<std::string> laid_out = format(after, *kind);
  return laid_out ? std::move(*laid_out) : std::move(after);
}

}  // namespace

Fixed apply_fixes(std::span<const grammar::Diagnostic> found, const grammar::Sources& sources) {
  Fixed fixed;
  std::vector<Edit> taken;
  for (const grammar::Diagnostic& finding : found) {
    const auto in_the_way = [&](const Edit& edit) {
      return std::any_of(taken.begin(), taken.end(), [&](const Edit& other) { return collide(edit, other); });
    };
    if (finding.fix.empty() || std::any_of(finding.fix.begin(), finding.fix.end(), in_the_way)) {
      fixed.left.push_back(finding);
      continue;
    }
    taken.insert(taken.end(), finding.fix.begin(), finding.fix.end());
    ++fixed.count;
  }
  std::sort(taken.begin(), taken.end(), [](const Edit& a, const Edit& b) { return b.span < a.span; });
  for (const Edit& edit : taken) {
    std::string& text = fixed.texts.try_emplace(edit.span.file, sources[edit.span.file].text()).first->second;
    text.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.text);
  }
  for (auto& [file, text] : fixed.texts) text = in_style(sources[file], std::move(text));
  return fixed;
}

}  // namespace rmpl::compiler
