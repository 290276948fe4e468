// The one public door to text: files or a formula in, automata or diagnostics out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"
#include "automata/property.hpp"
#include "automata/scenario.hpp"
#include "automata/software/model_component.hpp"
#include "grammar/source/findings.hpp"

namespace rmpl::compiler {

class NameIndex;
struct File;
struct ProgramPlaces;
class Provider;

struct Options {
  std::string main = {};  ///< the entry definition of the control program; empty: the one that no other calls
  /// Whether `.props` files may be among the inputs. They speak of the plant of the inputs; of several, of each that
  /// they fit: in which all their names are known.
  bool properties = false;
  /// Whether `.mon` files may be among the inputs. They speak of each plant of the inputs that they fit, and a channel
  /// that a scenario gives samples of has to be one of theirs.
  bool monitors = false;
  bool flown = false;           ///< a scenario with channels needs monitors: it is to be flown
  bool types_suffice = false;   ///< a model without a plant becomes one without a name, of an instance of each type
  bool model_is_plant = false;  ///< a model program becomes the plant where there is no other
  bool entry_optional = false;  ///< that nothing says where execution starts is no error: a program is checked without
};

/// What came of compiling an input set: a document, or at least one error. Nothing is rendered or printed here.
class Compilation {
 public:
  Compilation(Compilation&&) noexcept;
  Compilation& operator=(Compilation&&) noexcept;
  ~Compilation();

  [[nodiscard]] bool ok() const;
  /// The document. Only where `ok()`.
  [[nodiscard]] const automata::Document& document() const;
  /// What the `.props` files among the inputs state, in order of the files, once for each plant that they speak of.
  /// Only where `ok()`.
  [[nodiscard]] const std::vector<automata::PlantProperty>& properties() const;
  /// Where the programs of the document stand, one by one (`compiler/lower/program_places.hpp`). Only where `ok()`.
  [[nodiscard]] std::span<const ProgramPlaces> places() const;
  /// The same of its model programs.
  [[nodiscard]] std::span<const ProgramPlaces> model_places() const;
  /// Plants that hold model programs, by position, as they were before the threads of these became components.
  [[nodiscard]] const std::map<std::size_t, automata::PlantWithModels>& plants_with_models() const;
  /// Where the conditions of those model programs stand, likewise. Only where `ok()`.
  [[nodiscard]] const std::map<std::size_t, ProgramPlaces>& software_places() const;
  /// All that was read, with or without errors, by index; nothing once that was forgotten.
  [[nodiscard]] std::span<const File> files() const;
  /// Lets go of the files with their trees, a good part of what a large model takes: the document rests on none.
  void forget_files();
  /// Every diagnostic, warnings too, and the texts that they speak of.
  [[nodiscard]] const grammar::Findings& findings() const;
  /// The names in all that was read, with or without errors (`compiler/session/names.hpp`).
  [[nodiscard]] NameIndex names() const;

 private:
  friend Compilation compile(std::span<const std::string> paths, const Options& options, Provider& provider);
  struct Result;
  explicit Compilation(std::unique_ptr<Result> result);
  std::unique_ptr<Result> result_;
};

/// Compiles an input set: any mixture of `.rmpl`, `.tcca`, `.scn` and compiled `.json`; `-` is standard input (its kind
/// is told by its content). Imports are followed relative to the importing file. At most one plant and one control
/// program come from the `.tcca` and `.rmpl` arguments; where both are there, the program is checked against the plant
/// and bound to it. Scenarios bring the program and plant that they name. Throws base::InputError where a file
/// cannot be read.
Compilation compile(std::span<const std::string> paths, const Options& options = {});
/// The same with sources from elsewhere than the disk.
Compilation compile(std::span<const std::string> paths, const Options& options, Provider& provider);

/// A constraint from the command line, over a plant's modes and attributes. Where it is wrong, `formula` is empty and
/// `findings` says why. `where` names the place, as in `--target`.
struct CompiledFormula {
  std::optional<automata::Formula> formula;
  grammar::Findings findings;
};
CompiledFormula compile_formula(std::string_view text, const automata::Plant& plant, std::string_view where);
/// The same, asked of a program with its plant: it may ask of the executive's knowledge.
CompiledFormula compile_program_formula(std::string_view text, const automata::Plant& plant, std::string_view where);
/// The same, as a goal: what no command can achieve is an error, as it is in a program.
CompiledFormula compile_goal(std::string_view text, const automata::Plant& plant, std::string_view where);
/// The same as the first over the variables of a model program.
CompiledFormula compile_formula(std::string_view text, const automata::ModelProgram& program, std::string_view where);

/// A list of assignments from the command line, `x = v, y = w` or `x = v & y = w` (`--from`, `--observe`).
struct CompiledAssignments {
  std::optional<std::vector<automata::Assignment>> assignments;
  grammar::Findings findings;
};
CompiledAssignments compile_assignments(std::string_view text, const automata::Plant& plant, std::string_view where);
CompiledAssignments compile_assignments(std::string_view text, const automata::ModelProgram& program,
                                        std::string_view where);

/// A file of properties (`.props`; `-` is standard input) over a plant, and over a program that controls it where there
/// is one: `under_program`. Where it is wrong, `properties` is empty and `findings` says why. Throws base::InputError
/// where the file cannot be read.
struct CompiledProperties {
  std::optional<std::vector<automata::PlantProperty>> properties;
  grammar::Findings findings;
};
CompiledProperties compile_properties(const std::string& path, const automata::Plant& plant, bool under_program);
CompiledProperties compile_properties(const std::string& path, const automata::Plant& plant, bool under_program,
                                      Provider& provider);

}  // namespace rmpl::compiler
