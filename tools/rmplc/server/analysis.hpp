// What is known of a unit: its diagnostics, its trees, and once somebody asks, its names.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/lint/lint.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/name_scopes.hpp"
#include "compiler/session/names.hpp"
#include "tools/rmplc/server/message.hpp"
#include "tools/rmplc/server/units.hpp"

namespace rmpl::tools {

/// A compiled unit. Spans are those of its own sources.
class Analysis {
 public:
  /// Throws base::InputError where a file of the unit cannot be read.
  Analysis(Unit unit, compiler::Provider& texts);

  [[nodiscard]] const Unit& unit() const { return unit_; }
  [[nodiscard]] const grammar::Sources& sources() const { return compilation_.findings().sources; }
  /// In order of the text.
  [[nodiscard]] const std::vector<grammar::Diagnostic>& diagnostics() const { return diagnostics_; }
  [[nodiscard]] std::span<const compiler::File> files() const { return compilation_.files(); }
  /// The position of a source among the sources; nothing where it was not read.
  [[nodiscard]] std::optional<std::uint32_t> find(const std::string& identity) const;
  [[nodiscard]] const compiler::File& file(std::uint32_t index) const { return compilation_.files()[index]; }
  /// Whether a change of this source may change what is known.
  [[nodiscard]] bool depends_on(const std::string& identity) const;

  /// Whether it can be linted, and was not. Of what a lone file is there for, nothing can be said.
  [[nodiscard]] bool awaits_lint() const;
  /// Lints it: seconds, for a large plant.
  [[nodiscard]] std::vector<grammar::Diagnostic> lint(const compiler::LintSettings& settings) const;
  /// What came of linting it, ready for the client (`findings_of`); nothing where it failed.
  void take_lint(std::optional<Json> findings);
  [[nodiscard]] const std::optional<Json>& lint_findings() const { return lint_findings_; }

  [[nodiscard]] const compiler::NameIndex& names() const;
  [[nodiscard]] const compiler::NameScopes& scopes() const;

 private:
  Unit unit_;
  compiler::Compilation compilation_;
  std::vector<grammar::Diagnostic> diagnostics_;
  std::vector<std::string> identities_;  ///< per source
  bool linted_ = false;
  std::optional<Json> lint_findings_;
  mutable std::optional<compiler::NameIndex> names_;
  mutable std::optional<compiler::NameScopes> scopes_;
};

}  // namespace rmpl::tools
