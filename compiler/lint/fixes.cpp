// Edits that do not get in each other's way, from the end of each text to its start.
// SPDX-License-Identifier: MIT
#include "compiler/lint/fixes.hpp"

#include <algorithm>

namespace rmpl::compiler {

using grammar::Edit;

Fixed apply_fixes(std::span<const grammar::Diagnostic> found, const grammar::Sources& sources) {
  Fixed fixed;
  std::vector<Edit> taken;
  for (const grammar::Diagnostic& finding : found) {
    const auto in_the_way = [&](const Edit& edit) {
      return std::any_of(taken.begin(), taken.end(), [&](const Edit& other) {
        return edit.span.file == other.span.file && edit.span.begin <= other.span.end &&
               other.span.begin <= edit.span.end;
      });
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
  return fixed;
}

}  // namespace rmpl::compiler
