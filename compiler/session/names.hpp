// An index of names with their places: what stands here, where is it declared, where else is it used.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/session/files.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

enum class NameKind {
  definition,
  parameter,
  clock,
  variable,  ///< of a model program
  component,
  module,
  plant,
  domain,
  value,
  attribute,
  mode,
  instance,
  scenario,
  channel  ///< of telemetry; declared by the first monitor that names it
};

/// A name where it stands.
struct Mention {
  grammar::Span span;
  NameKind kind = NameKind::value;
  grammar::Span declaration;  ///< of what it names; the span itself where it is declared here
  auto operator<=>(const Mention&) const = default;
};

/// The mentions of some files, in order of file, then place; no two overlap.
class NameIndex {
 public:
  explicit NameIndex(std::vector<Mention> mentions);

  [[nodiscard]] std::span<const Mention> all() const { return mentions_; }
  /// The mention that a byte lies in, or that ends at it. Logarithmic.
  [[nodiscard]] std::optional<Mention> at(std::uint32_t file, std::uint32_t offset) const;
  /// Every mention of what is declared there, the declaration too. Linear.
  [[nodiscard]] std::vector<Mention> of(grammar::Span declaration) const;

 private:
  std::vector<Mention> mentions_;
};

/// Indexes trees, also those of which errors left a part. What a name stands for is found by its text and its scope
/// alone: a name that cannot be found has no mention. `engine.temp` mentions an instance and an attribute. Names of
/// programs, scenarios and monitors are looked for in the first plant among the files. Linear, times the depth of
/// instances.
NameIndex index_names(std::span<const File* const> files);

}  // namespace rmpl::compiler
