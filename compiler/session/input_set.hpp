// An input set on its way to a document: files read, plants and programs lowered once each, scenarios over both.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "automata/property.hpp"
#include "automata/scenario.hpp"
#include "compiler/lower/part.hpp"
#include "compiler/lower/program.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/files.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// Compiles one input set. What is wrong is reported into the diagnostics; the document means something only where
/// there are no errors.
class InputSet {
 public:
  InputSet(Provider& provider, grammar::Sources& sources, grammar::Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics), files_(provider, sources, diagnostics) {}

  automata::Document compile(std::span<const std::string> paths, const Options& options);
  /// What the `.props` files stated, once all is compiled.
  std::vector<automata::PlantProperty> take_properties() { return std::move(properties_); }
  /// Where the programs of the document stand, once all is compiled.
  std::vector<ProgramPlaces> take_places() { return std::move(places_); }
  /// The same of its model programs.
  std::vector<ProgramPlaces> take_model_places() { return std::move(model_places_); }
  /// Plants that hold model programs, by position, as they were before their threads became components, once all is
  /// compiled.
  std::map<std::size_t, automata::PlantWithModels> take_plants_with_models() { return std::move(with_models_); }
  /// Where the conditions of their model programs stand, by position of the plant, once all is compiled.
  std::map<std::size_t, ProgramPlaces> take_software_places() { return std::move(software_places_); }
  /// What was read, once all is compiled.
  std::vector<File> take_files() { return files_.take(); }

 private:
  using Roots = std::vector<const File*>;

  /// A plant of the document; `part` is null where it has errors, so that what refers to it is not judged by it.
  struct Plant {
    std::size_t position = 0;    ///< among the plants
    const Part* part = nullptr;  ///< null too where there is none
  };
  /// Where execution of a program starts, as the user said it.
  struct Entry {
    std::string name;
    std::optional<grammar::Span> span;  ///< none: on the command line, or nowhere
  };

  /// Takes over what a compiled document holds.
  void adopt(const File& file);
  /// Binds programs that were compiled without a plant.
  void bind_adopted(const Part& plant);
  automata::Program bound(const automata::Program& program, const Part* plant, grammar::Span blame);

  /// Takes the files of model programs out of those that the user named, where others hold control programs.
  [[nodiscard]] Roots beside_control(Roots& programs) const;
  /// The files that the user named. Throws base::InputError that tells of all that cannot be read.
  Roots opened(std::span<const std::string> paths, const Options& options);
  Plant plant(const Roots& roots, grammar::Span blame);
  /// Keeps the part of a plant of the document, and the plant itself until all is compiled: large ones are not copied.
  const Part& add_part(std::size_t position, Part part);
  /// The plant that the model program of some files is.
  Plant alone(const Roots& roots, const Entry& entry, grammar::Span blame);
  /// The plant that the model program of a compiled document is.
  Plant alone(const File& document, grammar::Span blame);
  /// The plant that a model program of the document is by itself; where it cannot be one that is reported at `blame`.
  Plant alone(std::size_t model, const std::vector<grammar::Span>& declared, grammar::Span blame);
  /// The plant that a scenario flies.
  Plant flown(const File& scenarios, const grammar::PlantPart& part);
  /// Makes components of the model programs that a plant holds, which is to stand at a position; false where they are
  /// too large for that.
  bool lower_software(Part& part, std::size_t position);
  /// The model program of a definition in one of the files, as a part; null where there is none.
  const Part* model_type(const std::vector<const File*>& files, const grammar::Name& definition);
  std::optional<Part> lower_plant(const Roots& roots, grammar::Span blame);
  /// A program of the document. A model program has no position among those that control a plant.
  struct Program {
    std::optional<std::size_t> position;  ///< nothing: it has errors, or is a model program
    std::optional<std::size_t> model;     ///< its position among the models
    std::vector<grammar::Span> declared;  ///< of the model, per variable, where
  };
  Program program(const Roots& roots, const Entry& entry, const Part* plant, grammar::Span blame);
  /// The program, or the model program with its places; neither where there are errors.
  struct Lowered {
    std::optional<LoweredProgram> program;
    std::optional<automata::ModelProgram> model;
    ProgramPlaces model_places = {};
    std::vector<grammar::Span> declared = {};  ///< of the model program, per variable, where
  };
  Lowered lower_program(const Roots& roots, const Entry& entry, const Part* plant, grammar::Span blame);
  /// The same from sources that are read; `plant` as above.
  Lowered lower_definitions(const std::vector<ProgramSource>& files, const Entry& entry, const Part* plant,
                            grammar::Span blame);
  /// Where execution starts; nothing where that is not known, which has been reported where it has to be.
  std::optional<std::size_t> start(const Definitions& definitions, const Entry& entry, grammar::Span blame);
  void scenarios(const File& file);
  /// A scenario that gives samples of channels, and the plant that it flies; null where that has errors.
  struct Sampled {
    const grammar::ScenarioDefinition* definition;  ///< null where a compiled document brought it
    grammar::Span blame;                            ///< then: that document
    const automata::Plant* plant;                   ///< of a compiled document known once all is read
    std::optional<std::size_t> scenario;            ///< its position in the document; nothing where it has errors
  };
  class Monitoring;
  /// Files of monitors over the plants that they fit; scenarios get those of their plants. With `flown` a channel
  /// without a monitor is an error where there is no such file, too.
  void monitors(const Roots& files, bool flown);
  [[nodiscard]] std::vector<const automata::Plant*> all_plants() const;
  [[nodiscard]] const automata::Plant* plant_of(const automata::Scenario& scenario) const;
  void properties(const File& file, const Plant& plant);
  /// With each of several plants that it fits.
  void properties_of_several(const File& file);
  /// The file of a scenario's control program; null where it is missing or of another kind, and then that has been
  /// reported.
  const File* controlling(const File& scenarios, const grammar::String& path);

  grammar::Sources& sources_;
  grammar::Diagnostics& diagnostics_;
  Files files_;
  bool types_suffice_ = false;   ///< a plant that is asked for may be made of types alone
  bool entry_optional_ = false;  ///< as in the options
  automata::Document document_;
  std::vector<ProgramPlaces> places_;                             ///< per program of the document
  std::vector<ProgramPlaces> model_places_;                       ///< per model program of the document
  std::map<std::size_t, automata::PlantWithModels> with_models_;  ///< by position of the plant
  std::map<std::size_t, ProgramPlaces> software_places_;          ///< likewise
  std::vector<automata::PlantProperty> properties_;
  std::vector<Sampled> sampled_;
  std::vector<grammar::Span> adopted_;               ///< per program that a compiled document brought, that document
  std::deque<Part> parts_;                           ///< of plants without errors; a deque, for they are referred to
  std::vector<std::pair<std::size_t, Part*>> lent_;  ///< by position of the plant, which stays in its part till the end
  std::map<Roots, Plant> plants_;
  std::map<std::size_t, Plant> alone_;                                              ///< by position of the model
  std::map<std::pair<const File*, std::string>, std::optional<Part>> model_types_;  ///< by file and definition
  std::map<std::tuple<Roots, std::string, const Part*>, Program> programs_;
};

}  // namespace rmpl::compiler
