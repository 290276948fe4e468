// From a place in the automata back to the stretch of text that it came from.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "automata/origin.hpp"
#include "compiler/session/files.hpp"
#include "grammar/source/source_file.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

/// Knows where the parts of some trees begin and end: steps, definitions, names, transitions, interconnections, items
/// of scenarios and properties.
class Places {
 public:
  /// Refers to the sources.
  Places(const grammar::Sources& sources, std::span<const File> files);

  /// The shortest part that begins at this place; where none does, the place itself, empty. Of a place without source,
  /// or in a file that was not read as text, the start of the first file. Logarithmic.
  [[nodiscard]] grammar::Span at(const automata::Origin& origin) const;
  /// Whether the place lies in one of the texts: what came from a compiled document does not.
  [[nodiscard]] bool has(const automata::Origin& origin) const { return files_.count(origin.file) > 0; }

 private:
  const grammar::Sources& sources_;
  std::map<std::string, std::uint32_t> files_;  ///< by name
  std::vector<grammar::Span> parts_;            ///< sorted
};

}  // namespace rmpl::compiler
