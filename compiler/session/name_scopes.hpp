// What names can be found in a model: domains, types with their members, the root; and in programs, definitions.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/session/names.hpp"

namespace rmpl::compiler {

/// A declared name.
struct Declared {
  grammar::Span span;
  NameKind kind = NameKind::attribute;
  const grammar::DomainRef* domain = nullptr;  ///< of attributes and variables
  std::string type;                            ///< of instances
};

using Members = std::map<std::string, Declared, std::less<>>;

/// A part of a name and what it leads to: `engine` and `temp` of `engine.temp`.
struct NamePart {
  std::size_t begin = 0;
  std::size_t length = 0;
  const Declared* declared = nullptr;
};

/// The declarations of all files together; of two of one name, the first.
class NameScopes {
 public:
  explicit NameScopes(std::span<const File* const> files);

  [[nodiscard]] const Declared* domain(std::string_view name) const;
  [[nodiscard]] const Declared* type(std::string_view name) const;
  [[nodiscard]] const Declared* definition(std::string_view name) const;
  [[nodiscard]] const Declared* channel(std::string_view name) const;
  /// A name within a type, part by part through its instances, up to the first part that is not there.
  [[nodiscard]] std::vector<NamePart> parts(std::string_view type, std::string_view name) const;
  /// The same for a name that programs and scenarios may have: of a model program's variables, or of the plant.
  [[nodiscard]] std::vector<NamePart> visible_parts(std::string_view name) const;
  /// What all of a name within a type leads to. Null where a part is not there.
  [[nodiscard]] const Declared* member(std::string_view type, std::string_view name) const;
  [[nodiscard]] const Declared* visible(std::string_view name) const;
  /// Where a value of a variable is declared; null where it has no such value.
  [[nodiscard]] const Declared* value(const Declared& variable, std::string_view value) const;
  /// The values of a variable; null where nothing is known of them.
  [[nodiscard]] const Members* values(const Declared& variable) const;
  /// The members of a type as declared; null where there is no such type.
  [[nodiscard]] const Members* members(std::string_view type) const;
  /// The name of the first plant; empty where there is none.
  [[nodiscard]] const std::string& plant() const { return plant_; }
  /// All of a kind, for those who list them.
  [[nodiscard]] const Members& domains() const { return domains_; }
  [[nodiscard]] const Members& types() const { return types_; }
  [[nodiscard]] const Members& definitions() const { return definitions_; }
  [[nodiscard]] const Members& variables() const { return variables_; }
  [[nodiscard]] const Members& channels() const { return channels_; }

 private:
  void add(const grammar::ComponentDefinition& component);
  void add(const grammar::ModuleDefinition& module);
  void add(const grammar::Domain& domain);
  void add(const grammar::ProgramFile& program);
  void add(const grammar::MonitorFile& monitors);
  static void add_attribute(const grammar::AttributeDeclaration& attribute, Members& members);

  Members domains_;
  Members types_;
  Members definitions_;
  Members channels_;                                     ///< of telemetry
  Members variables_;                                    ///< of model programs
  std::map<std::string, Members, std::less<>> members_;  ///< by type
  std::map<std::string, Members, std::less<>> values_;   ///< of named domains, and modes of component types
  std::map<grammar::Span, Members> values_in_place_;     ///< of domains without a name, by their place
  std::string plant_;                                    ///< the first
};

}  // namespace rmpl::compiler
