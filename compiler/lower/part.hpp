// A part of a plant: a component type or a module, flattened, with names relative to itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "automata/plant.hpp"
#include "automata/software/model_component.hpp"
#include "compiler/lower/program_places.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

/// A model program as a component, over the variables of the part, with the name of its instance to blame.
struct ModelPart {
  automata::ModelComponent component;
  grammar::Span span;
  std::vector<PlacedCondition> conditions = {};  ///< in its source, over these variables
};

/// A plant is its root module as a part. The mode variable and the component of a component type are named "", so that
/// an instance of it takes the instance's name.
struct Part {
  automata::Plant plant;
  std::vector<grammar::Span> declared;  ///< per variable, where its domain is written; a mode variable's: the type
  std::set<std::string, std::less<>> broken;  ///< names that an error left without meaning: no more is said of them
  std::size_t size = 0;                       ///< values, modes and transitions: what a copy costs
  std::vector<ModelPart> models = {};         ///< model programs as components
};

/// How large a part may become, in values, modes and transitions.
inline constexpr std::size_t size_limit = 4'000'000;

/// Makes room in a part for so many values, modes and transitions more. Parts multiply (`any` by modes, domains by
/// attributes, modules within modules): this is where that ends. False where the part is too large; the first time it
/// is reported at `blame`.
bool make_room(Part& part, std::size_t more, grammar::Span blame, grammar::Diagnostics& diagnostics);

/// Puts a copy of `type` into `whole` under the name of an instance; there must be room. The names must be new; see
/// `first_clash`.
void instantiate(Part& whole, const std::string& instance, const Part& type);

/// The first name of `type` as `instance` that `whole` already has, empty where there is none.
std::string first_clash(const Part& whole, const std::string& instance, const Part& type);

/// Whether the name, or what it is a part of (`engine` of `engine.temp`), was left without meaning by an error.
bool is_broken(const Part& part, std::string_view name);

/// A span as a place in the automata.
automata::Origin origin_of(const grammar::Sources& sources, grammar::Span span);

}  // namespace rmpl::compiler
