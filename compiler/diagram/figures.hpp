// The pictures that a document can be drawn as, and their names.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"
#include "automata/software/model_component.hpp"

namespace rmpl::compiler {

/// One picture. It refers to the document that it is of.
struct Figure {
  /// Where one name stands for several, the first kind is meant.
  enum class Kind { program, plant, type, module, instance };
  Kind kind = Kind::program;
  std::string name;  ///< of the program, plant or component type; the path of a module or of a component
  const automata::Program* program = nullptr;        ///< of control programs
  const automata::Plant* plant = nullptr;            ///< of all others
  const automata::Component* component = nullptr;    ///< of instances; of a type, the first instance
  const automata::ModelProgram* model = nullptr;     ///< of model programs, whose kind is program
  const automata::PlantWithModels* whole = nullptr;  ///< of all of a plant that holds model programs
  const automata::ModelComponent* held = nullptr;    ///< of one that it holds, or of a type, the first such
};

using PlantsWithModels = std::map<std::size_t, automata::PlantWithModels>;

/// All of a document: programs; then each plant, its component types in the order in which they are first used, its
/// modules and its components. A plant without a name has none of its own. Plants that hold model programs, by
/// position, are drawn as the text has them: a model program is a component of the type that its definition is.
std::vector<Figure> figures_of(const automata::Document& document, const PlantsWithModels& plants = {});

/// Those that a document is about, where nobody says which one: programs and plants, or where there is neither (a model
/// of types alone) its types.
std::vector<Figure> main_figures(const std::vector<Figure>& figures);

/// Those of the first kind that has this name.
std::vector<Figure> named(const std::vector<Figure>& figures, std::string_view name);

/// `program`, `plant`, `component`, `module`, `instance`.
std::string_view to_string(Figure::Kind kind);

/// A figure in DOT: same figure, same bytes. `depth` is how many levels of boxes are opened, those of a program or the
/// modules of a plant; without it all of a program, and of a plant as many as give a picture that can be read.
std::string to_dot(const Figure& figure, std::optional<std::size_t> depth);

}  // namespace rmpl::compiler
