// From an input set to one document.
// SPDX-License-Identifier: MIT
#include "compiler/session/input_set.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "compiler/check/clocks.hpp"
#include "compiler/check/definitions.hpp"
#include "compiler/check/recursion.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lower/model.hpp"
#include "compiler/lower/model_declarations.hpp"
#include "compiler/lower/module.hpp"
#include "compiler/lower/program.hpp"
#include "compiler/lower/property.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Span;

automata::Document InputSet::compile(std::span<const std::string> paths, const Options& options) {
  entry_optional_ = options.entry_optional;
  std::map<Kind, Roots> roots;
  for (const File* file : opened(paths, options)) {
    Roots& same = roots[file->kind];
    if (std::find(same.begin(), same.end(), file) == same.end()) same.push_back(file);
  }
  for (const File* file : roots[Kind::document]) adopt(*file);
  Roots& programs = roots[Kind::program];
  const bool plantless = roots[Kind::plant].empty() && document_.plants.empty();
  const Roots software = plantless ? beside_control(programs) : Roots{};
  const bool asked_of_plant =
      options.model_is_plant || !roots[Kind::properties].empty() || !roots[Kind::monitors].empty();
  Plant plant;
  if (!roots[Kind::plant].empty()) {
    types_suffice_ = options.types_suffice;
    plant = this->plant(roots[Kind::plant], {roots[Kind::plant].front()->index, 0, 0});
  } else if (document_.plants.size() == 1) {
    plant = {0, &parts_.front()};
  } else if (!software.empty()) {
    plant = alone(software, {}, {software.front()->index, 0, 0});
  } else if (plantless && document_.models.size() == 1 && (asked_of_plant || !programs.empty() || !adopted_.empty())) {
    plant = alone(0, {}, {roots[Kind::document].front()->index, 0, 0});
  }
  if (plant.part != nullptr) bind_adopted(*plant.part);
  if (!programs.empty()) {
    const Span blame{programs.front()->index, 0, 0};
    const Program made = program(programs, {options.main, std::nullopt}, plant.part, blame);
    if (made.model && asked_of_plant && document_.plants.empty()) plant = alone(*made.model, made.declared, blame);
  } else if (!options.main.empty()) {
    throw base::InputError("--main " + options.main + ": expected a control program (.rmpl) among the inputs");
  }
  for (const File* file : roots[Kind::scenario]) scenarios(*file);
  for (const File* file : roots[Kind::properties]) properties(*file, plant);
  monitors(roots[Kind::monitors], options.flown);
  for (const auto& [position, part] : lent_) document_.plants[position] = std::move(part->plant);
  return std::move(document_);
}

InputSet::Roots InputSet::opened(std::span<const std::string> paths, const Options& options) {
  Roots roots;
  std::vector<std::string> failures;
  for (const std::string& path : paths) {
    try {
      roots.push_back(&files_.open(path));
      if (roots.back()->kind == Kind::properties && !options.properties) throw base::InputError(not_a_model(path));
      if (roots.back()->kind == Kind::monitors && !options.monitors) throw base::InputError(not_a_model(path));
    } catch (const base::InputError& error) {
      failures.emplace_back(error.what());
    }
  }
  if (failures.size() == 1) throw base::InputError(failures.front());
  if (!failures.empty()) {
    std::string all = std::to_string(failures.size()) + " inputs cannot be used:";
    for (const std::string& failure : failures) all += "\n  " + failure;
    throw base::InputError(all);
  }
  return roots;
}

void InputSet::adopt(const File& file) {
  if (!file.document) return;
  const std::size_t plants = document_.plants.size();
  const std::size_t programs = document_.programs.size();
  automata::Document& more = *file.document;
  if (more.plants.size() == 1) {
    document_.plants.emplace_back();
    plants_.emplace(Roots{&file}, Plant{plants, &add_part(plants, {std::move(more.plants.front()), {}, {}, 0})});
  } else {
    std::move(more.plants.begin(), more.plants.end(), std::back_inserter(document_.plants));
  }
  for (const automata::Program& program : more.programs) {
    document_.programs.push_back(program);
    places_.emplace_back();
    adopted_.push_back({file.index, 0, 0});
  }
  for (const automata::ModelProgram& model : more.models) document_.models.push_back(model);
  model_places_.resize(document_.models.size());
  for (const automata::Scenario& scenario : more.scenarios) {
    automata::Scenario& copy = document_.scenarios.emplace_back(scenario);
    copy.plant += plants;
    copy.program += programs;
    if (copy.samples.empty()) continue;
    sampled_.push_back({nullptr, {file.index, 0, 0}, nullptr, document_.scenarios.size() - 1});
  }
}

void InputSet::bind_adopted(const Part& plant) {
  for (std::size_t p = 0; p < adopted_.size(); ++p) {
    automata::Program& program = document_.programs[p];
    const auto is_its_own = [&](const automata::Plant& own) { return own.variables == program.variables; };
    const bool has_plant =
        std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) { return is_its_own(part.plant); }) ||
        std::any_of(document_.plants.begin(), document_.plants.end(),
                    [&](const automata::Plant& own) { return !own.components.empty() && is_its_own(own); });
    if (!has_plant) program = bound(program, &plant, adopted_[p]);
  }
}

automata::Program InputSet::bound(const automata::Program& program, const Part* plant, Span blame) {
  if (plant == nullptr || program.variables == plant->plant.variables) return program;
  automata::Binding binding = automata::bind(program, plant->plant);
  for (const automata::Mismatch& lacking : binding.lacking) {
    diagnostics_.error(Code::not_in_plant, blame,
                       lacking.origin.line > 0 ? lacking.message + ", at " + to_text(lacking.origin) + " of its source"
                                               : lacking.message);
  }
  if (!binding.lacking.empty()) return program;
  return std::move(binding.program);
}

InputSet::Plant InputSet::plant(const Roots& roots, Span blame) {
  if (const auto known = plants_.find(roots); known != plants_.end()) return known->second;
  Plant result{document_.plants.size(), nullptr};
  auto part = lower_plant(roots, blame);
  if (part && !part->models.empty() && !lower_software(*part, result.position)) part.reset();
  if (part) {
    document_.plants.emplace_back();
    result.part = &add_part(result.position, std::move(*part));
  }
  plants_.emplace(roots, result);
  return result;
}

const Part& InputSet::add_part(std::size_t position, Part part) {
  Part& kept = parts_.emplace_back(std::move(part));
  lent_.emplace_back(position, &kept);
  return kept;
}

std::optional<Part> InputSet::lower_plant(const Roots& roots, Span blame) {
  const FileSet set = files_.with_imports(roots);
  if (!set.complete) return std::nullopt;
  const std::size_t errors = diagnostics_.error_count();
  if (roots.front()->kind == Kind::document) {
    const auto& plants = roots.front()->document->plants;
    if (plants.size() == 1) return Part{plants.front(), {}, {}, 0};
    diagnostics_.error(plants.empty() ? Code::no_plant : Code::several_plants, blame,
                       "the compiled document holds " + std::to_string(plants.size()) + " plants, expected one");
    return std::nullopt;
  }
  std::vector<const grammar::PlantFile*> files;
  for (const File* file : set.files) files.push_back(&*file->plant);
  const auto model_type = [&](const grammar::Name& definition) { return this->model_type(set.programs, definition); };
  std::vector<const grammar::ProgramFile*> programs;
  for (const File* file : files_.with_imports(set.programs).files) programs.push_back(&*file->program);
  auto part = ModelLowering(sources_, model_type, diagnostics_).run(files, programs, blame, types_suffice_);
  return diagnostics_.error_count() == errors ? std::move(part) : std::nullopt;
}

InputSet::Program InputSet::program(const Roots& roots, const Entry& entry, const Part* plant, Span blame) {
  const auto key = std::tuple(roots, entry.name, plant);
  if (const auto known = programs_.find(key); known != programs_.end()) return known->second;
  Program result;
  Lowered lowered = lower_program(roots, entry, plant, blame);
  if (lowered.program) {
    result.position = document_.programs.size();
    document_.programs.push_back(std::move(lowered.program->program));
    places_.push_back(std::move(lowered.program->places));
  } else if (lowered.model) {
    result.model = document_.models.size();
    document_.models.push_back(std::move(*lowered.model));
    result.declared = std::move(lowered.declared);
    model_places_.push_back(std::move(lowered.model_places));
  }
  programs_.emplace(key, result);
  return result;
}

InputSet::Lowered InputSet::lower_program(const Roots& roots, const Entry& entry, const Part* plant, Span blame) {
  const FileSet set = files_.with_imports(roots);
  if (!set.complete) return {};
  const std::size_t errors = diagnostics_.error_count();
  if (roots.front()->kind == Kind::document) {
    const auto& programs = roots.front()->document->programs;
    if (programs.size() == 1) return {LoweredProgram{bound(programs.front(), plant, blame), {}, {}, true}, {}};
    diagnostics_.error(programs.empty() ? Code::no_program : Code::several_programs, blame,
                       "the compiled document holds " + std::to_string(programs.size()) + " programs, expected one");
    return {};
  }
  std::vector<ProgramSource> files;
  for (std::size_t f = 0; f < set.files.size(); ++f) files.push_back({&*set.files[f]->program, f < set.roots});
  Lowered lowered = lower_definitions(files, entry, plant, blame);
  return diagnostics_.error_count() == errors ? std::move(lowered) : Lowered{};
}

std::optional<std::size_t> InputSet::start(const Definitions& definitions, const Entry& entry, Span blame) {
  grammar::Diagnostics unasked;
  auto start = find_entry(definitions, entry.name, entry.span, blame, entry_optional_ ? unasked : diagnostics_);
  if (!start) return std::nullopt;
  const grammar::Definition& definition = *definitions.all[*start].definition;
  if (definition.parameters.empty()) return start;
  if (entry_optional_) return std::nullopt;
  diagnostics_.error(
      Code::wrong_argument_count, definition.name.span,
      "execution starts at " + backquoted(definition.name.text) + ", which takes arguments: nothing gives them");
  return start;
}

InputSet::Lowered InputSet::lower_definitions(const std::vector<ProgramSource>& files, const Entry& entry,
                                              const Part* plant, Span blame) {
  const Definitions definitions = collect_definitions(files, diagnostics_);
  if (definitions.mixed) return {};
  const Recursion recursion = check_recursion(definitions, diagnostics_);
  std::optional<ModelDeclarations> declared;
  if (definitions.model) declared = declare_model(sources_, files, diagnostics_);
  std::vector<bool> reached(definitions.all.size(), false);
  const auto lower = [&](std::size_t from, Purpose purpose, const Part* names) {
    return compiler::lower_program(sources_, definitions, recursion, from, purpose, declared ? &declared->part : names,
                                   reached, diagnostics_);
  };
  Lowered result;
  std::vector<std::size_t> entries;
  if (const auto start = this->start(definitions, entry, blame)) {
    LoweredProgram lowered = lower(*start, Purpose::run, plant);
    if (!lowered.complete) return {};
    entries.push_back(*start);
    if (declared) {
      result.model = model_program(lowered, *declared, diagnostics_);
      result.model_places = std::move(lowered.places);
      result.declared = declared->part.declared;
    } else {
      result.program = std::move(lowered);
    }
  }
  // What the program does not use is checked too, but for the names of a plant: it may be meant for another.
  for (const bool called : {false, true}) {
    for (std::size_t d = 0; d < definitions.all.size(); ++d) {
      if (reached[d] || definitions.all[d].called != called) continue;
      const LoweredProgram unused = lower(d, Purpose::check, nullptr);
      if (!unused.complete) return {};
      if (declared) model_program(unused, *declared, diagnostics_);
      entries.push_back(d);
    }
  }
  // What a definition that is not there would start is not known.
  if (definitions.unknown.empty() && !declared) check_clocks(definitions, recursion, entries, diagnostics_);
  return result;
}

void InputSet::properties(const File& file, const Plant& plant) {
  if (!file.whole) return;
  const Part* part = plant.part;
  if (part == nullptr && parts_.size() == 1 && document_.plants.size() == 1) part = &parts_.front();
  if (part == nullptr && lent_.size() > 1) return properties_of_several(file);
  if (part == nullptr) {
    // A plant with errors has been told of.
    if (!diagnostics_.has_errors()) {
      diagnostics_.error(Code::no_plant, {file.index, 0, 0},
                         "properties speak of a plant, and there is not one of it among the inputs");
    }
    return;
  }
  // The program that some speak of is needed where they are decided.
  auto stated = lower_properties(sources_, *file.properties, {file.index, 0, 0}, part->plant, true, diagnostics_);
  std::move(stated.begin(), stated.end(), std::back_inserter(properties_));
}

/// A file of properties does not name its plant. It speaks of those whose names it uses.
void InputSet::properties_of_several(const File& file) {
  grammar::Diagnostics nearest;  // what keeps it from the plant that it fits best
  bool fits = false;
  for (const auto& [position, part] : lent_) {
    grammar::Diagnostics wrong;
    auto stated = lower_properties(sources_, *file.properties, {file.index, 0, 0}, part->plant, true, wrong);
    if (wrong.has_errors()) {
      if (nearest.empty() || wrong.error_count() < nearest.error_count()) nearest = std::move(wrong);
      continue;
    }
    fits = true;
    for (automata::PlantProperty& property : stated) {
      property.plant = position;
      properties_.push_back(std::move(property));
    }
  }
  if (fits || diagnostics_.has_errors()) return;
  diagnostics_.error(Code::no_plant, {file.index, 0, 0},
                     "these properties fit none of the " + std::to_string(lent_.size()) +
                         " plants among the inputs; below, what is wrong for the one that they fit best");
  for (const grammar::Diagnostic& diagnostic : nearest.all()) diagnostics_.add(diagnostic);
}

}  // namespace rmpl::compiler
