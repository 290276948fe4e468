// From modules and the plant as written to parts: ports, instances, interconnections, controls, observables.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/domains.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// Lowers one plant model: all files that belong together. Every type is lowered once, used or not, so that its errors
/// are reported once; instances are copies.
class ModelLowering {
 public:
  /// The model program of a definition as a part whose model has no name; null where there is none, which has been
  /// reported.
  using ModelType = std::function<const Part*(const grammar::Name& definition)>;

  ModelLowering(const grammar::Sources& sources, ModelType model_type, grammar::Diagnostics& diagnostics)
      : sources_(sources), model_type_(std::move(model_type)), diagnostics_(diagnostics), domains_(diagnostics) {}

  /// The plant of the model. `blame` is where a model without a plant is reported; where types suffice, it is one
  /// without a name, with an instance of each type, called as the type. Only where no error was reported is the result
  /// a plant that means what the text says. Domains of the `programs` serve where the model declares none of that
  /// name.
  std::optional<Part> run(const std::vector<const grammar::PlantFile*>& files,
                          const std::vector<const grammar::ProgramFile*>& programs, grammar::Span blame,
                          bool types_suffice = false);

 private:
  /// A component type or a module, lowered when it is first needed.
  struct Type {
    grammar::Name name;
    const grammar::ComponentDefinition* component = nullptr;
    const grammar::ModuleDefinition* module = nullptr;
    std::unique_ptr<Part> part;
    bool open = false;       ///< being lowered: an instance of it now contains itself
    bool too_large = false;  ///< reported; instances of it have nothing
  };

  void declare_types(const std::vector<const grammar::PlantFile*>& files);
  void declare_type(Type type);
  /// The part of a type; null where there is none (a cycle, or an error that was reported).
  const Part* lower(Type& type);
  void lower_module(const grammar::ModuleDefinition& definition, Part& part);
  Part instances_of_types();
  void add_instances(const grammar::InstanceDeclaration& declaration, Uniqueness& names, Part& part);
  void add_models(const grammar::InstanceDeclaration& declaration, const std::vector<const grammar::Name*>& fresh,
                  Part& part);
  /// `progress`: all its components are of progress, whatever their types say.
  void add_instance(const grammar::Name& name, const Part& type, const std::optional<std::vector<double>>& initial,
                    bool progress, Part& part);
  Type* find_type(const grammar::Name& name);
  void report_cycle(const Type& type, const grammar::Name& instance);

  const grammar::Sources& sources_;
  ModelType model_type_;
  grammar::Diagnostics& diagnostics_;
  Domains domains_;
  std::map<std::string, Type, std::less<>> types_;
  std::vector<const grammar::ModuleDefinition*> plants_;
  std::vector<Type*> order_;                    ///< as written
  std::set<std::string, std::less<>> unknown_;  ///< types that there are not; each is reported once
  /// The instances that led to the type that is being lowered, for the note of a cycle.
  std::vector<std::pair<Type*, grammar::Name>> path_;
};

}  // namespace rmpl::compiler
