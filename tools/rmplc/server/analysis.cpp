// Compiling a unit, and what is left out of what the compiler says of it.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/analysis.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"

namespace rmpl::tools {
namespace {

compiler::Options options_of(const Unit& unit) {
  compiler::Options options;
  options.properties = options.monitors = true;
  options.types_suffice = options.entry_optional = unit.lone;
  return options;
}

}  // namespace

Analysis::Analysis(Unit unit, compiler::Provider& texts)
    : unit_(std::move(unit)), compilation_(compiler::compile(unit_.paths, options_of(unit_), texts)) {
  for (const compiler::File& file : files()) {
    CHECK(file.index == identities_.size());
    identities_.push_back(texts.identity(sources()[file.index].name()));
  }
  diagnostics_ = compilation_.findings().diagnostics.sorted();
  // A lone file may have no plant: who imports it has one.
  if (unit_.lone) std::erase_if(diagnostics_, [](const auto& d) { return d.code == grammar::Code::no_plant; });
}

std::optional<std::uint32_t> Analysis::find(const std::string& identity) const {
  const auto found = std::find(identities_.begin(), identities_.end(), identity);
  if (found == identities_.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - identities_.begin());
}

bool Analysis::depends_on(const std::string& identity) const { return find(identity).has_value(); }

bool Analysis::awaits_lint() const {
  if (linted_ || !compilation_.ok()) return false;
  return !compilation_.document().plants.empty() || !compilation_.document().programs.empty();
}

std::vector<grammar::Diagnostic> Analysis::lint(const compiler::LintSettings& settings) const {
  return compiler::lint(compilation_, settings).sorted();
}

void Analysis::take_lint(std::optional<Json> findings) {
  linted_ = true;
  lint_findings_ = std::move(findings);
}

const compiler::NameIndex& Analysis::names() const {
  if (!names_) names_ = compilation_.names();
  return *names_;
}

const compiler::NameScopes& Analysis::scopes() const {
  if (!scopes_) {
    std::vector<const compiler::File*> files;
    for (const compiler::File& file : this->files()) files.push_back(&file);
    scopes_.emplace(files);
  }
  return *scopes_;
}

}  // namespace rmpl::tools
