// By the names in a set, and in its scenarios.
// SPDX-License-Identifier: MIT
#include "tools/shared/property_subject.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "compiler/session/files.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;
using compiler::Compilation;

/// A file, and the definition in it that is meant; none: the only one.
using Named = std::pair<std::string, std::string>;

/// The plants, or the programs, that the scenarios of a set name.
std::set<Named> named_by_scenarios(const Compilation& compilation, bool plants) {
  std::set<Named> found;
  const auto add = [&](const compiler::File& file, const grammar::String& path,
                       const std::optional<grammar::Name>& main) {
    found.emplace((fs::path(file.directory) / path.text).lexically_normal().string(),
                  main ? main->text : std::string());
  };
  for (const compiler::File& file : compilation.files()) {
    if (!file.scenarios || !file.named) continue;
    for (const grammar::ScenarioDefinition& scenario : file.scenarios->scenarios) {
      for (const grammar::ScenarioItem& item : scenario.items) {
        const auto* plant = std::get_if<grammar::PlantPart>(&item);
        const auto* program = std::get_if<grammar::ProgramPart>(&item);
        if (plants && plant != nullptr) add(file, plant->path, plant->main);
        if (!plants && program != nullptr) add(file, program->path, program->main);
      }
    }
  }
  return found;
}

}  // namespace

PropertySubject subject_of(const Manifest& manifest, const ManifestSet& set, const SetFiles& files,
                           const Compilation& compilation) {
  PropertySubject subject{files.plant, files.program, files.main};
  if (subject.plant.empty()) {
    const std::set<Named> plants = named_by_scenarios(compilation, true);
    if (plants.size() != 1) {
      manifest.fail(
          set.properties.front(),
          plants.empty()
              ? "properties refer to a plant: expected 'plant' in the set"
              : "the scenarios of the set fly several plants: expected 'plant', the one that the properties refer to");
    }
    subject.plant = plants.begin()->first;
  }
  if (!subject.program.empty()) return subject;
  const std::set<Named> programs = named_by_scenarios(compilation, false);
  if (programs.size() == 1) std::tie(subject.program, subject.main) = *programs.begin();
  return subject;
}

PropertySubject subject_of(const Manifest& manifest, const std::string& properties) {
  const ManifestSet* found = nullptr;
  SetFiles files;
  for (const ManifestSet& set : manifest.sets) {
    SetFiles own = files_of(manifest, set);
    const bool has = std::any_of(own.properties.begin(), own.properties.end(), [&](const std::string& path) {
      std::error_code error;
      return fs::equivalent(path, properties, error);
    });
    if (!has) continue;
    if (found != nullptr) {
      throw base::InputError(properties + ": the sets '" + found->name + "' and '" + set.name + "' of " +
                             manifest.path + " contain it; give the plant before the property file");
    }
    found = &set;
    files = std::move(own);
  }
  if (found == nullptr) {
    throw base::InputError(
        properties +
        ": properties refer to a plant; give the plant before the property file, or name both in a set of " +
        manifest.path);
  }
  return subject_of(manifest, *found, files, compiler::compile(files.scenarios, {}));
}

}  // namespace rmpl::tools
