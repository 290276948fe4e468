// Findings that are known and not to be told again: what a project had when it began to be linted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::tools {

/// Findings by code, file and message, and not by line: what stands above them may change. Files are relative to the
/// folder of the baseline.
class Baseline {
 public:
  /// None.
  Baseline() = default;
  /// Reads grammar/schema/lint_baseline.schema.json. Throws base::InputError where it is something else.
  explicit Baseline(const std::string& path);

  /// Those that are not known. Of what is known so often, so many are left out, the first ones.
  std::vector<grammar::Diagnostic> unknown(const std::vector<grammar::Diagnostic>& found,
                                           const grammar::Sources& sources);
  /// How many of the known ones were not found so far.
  [[nodiscard]] std::size_t unmet() const;

 private:
  using Key = std::tuple<std::string, std::string, std::string>;  ///< code, file, message
  std::string folder_;
  std::map<Key, std::size_t> left_;
};

/// The findings as a baseline that stands at a path.
std::string to_baseline(std::span<const grammar::Diagnostic> found, const grammar::Sources& sources,
                        const std::string& path);

}  // namespace rmpl::tools
