// Units, by who names whom.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/units.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "compiler/session/files.hpp"
#include "grammar/parse/scan.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {
namespace {

using compiler::Kind;

constexpr std::size_t most_files_of_a_folder = 500;

/// The strings behind `import`, `program` and `plant`, by the tokens alone: a text with errors names files too.
std::vector<std::string> named_in(std::string_view text) {
  std::vector<std::string> names;
  const char* const end = text.data() + text.size();
  bool expected = false;
  for (const char* at = grammar::skip_blank(text.data(), end); at != end; at = grammar::skip_blank(at, end)) {
    const std::string_view token = grammar::token_at(at, end);
    if (expected && token.size() > 2 && token.front() == '"' && token.back() == '"')
      names.emplace_back(token.substr(1, token.size() - 2));
    expected = token == "import" || token == "program" || token == "plant";
    at = token.data() + token.size();
  }
  return names;
}

/// A file that units are made of.
struct Candidate {
  std::string path;
  std::string id;
  Kind kind;
  bool open = false;
  std::set<std::string> reached;  ///< by identity, itself too
};

class Making {
 public:
  Making(References& references, compiler::Provider& texts) : references_(references), texts_(texts) {}

  void add(const std::string& path, bool open) {
    const auto kind = compiler::kind_by_name(path);
    if (!kind || *kind == Kind::document) return;
    const std::string id = texts_.identity(path);
    if (with(id) == nullptr) files_.push_back({path, id, *kind, open, {}});
  }

  /// A set of a project. Its files are looked at wherever they are.
  void add(const SetFiles& set) {
    for (const std::string& path : {set.plant, set.program}) {
      if (!path.empty()) add(path, false);
    }
    for (const auto* paths : {&set.scenarios, &set.properties, &set.monitors}) {
      for (const std::string& path : *paths) add(path, false);
    }
    sets_.push_back(set);
  }

  std::vector<Unit> run() {
    for (Candidate& file : files_) reach(file.path, file.id, file.reached);
    scenarios();
    pairs();
    with_plants(Kind::properties);
    with_plants(Kind::monitors);
    for (const Candidate& file : files_) {
      if (file.open && !covered_.contains(file.id)) add_root_of(file);
    }
    return std::move(units_);
  }

 private:
  void reach(const std::string& path, const std::string& id, std::set<std::string>& reached) {
    reached.insert(id);
    std::vector<std::string> pending{path};
    while (!pending.empty()) {
      const std::string from = std::move(pending.back());
      pending.pop_back();
      for (const std::string& next : references_.of(from)) {
        if (reached.insert(texts_.identity(next)).second) pending.push_back(next);
      }
    }
  }

  bool leads_to_open(const Candidate& file) const {
    return std::any_of(files_.begin(), files_.end(),
                       [&](const Candidate& to) { return to.open && file.reached.contains(to.id); });
  }

  void cover(const Candidate& file) { covered_.insert(file.reached.begin(), file.reached.end()); }

  void scenarios() {
    std::map<std::set<std::string>, std::size_t> by_plants;
    for (const Candidate& file : files_) {
      if (file.kind != Kind::scenario || !leads_to_open(file)) continue;
      std::set<std::string> plants;
      for (const std::string& named : references_.of(file.path)) {
        if (compiler::kind_by_name(named) == Kind::plant) plants.insert(texts_.identity(named));
      }
      const auto [at, fresh] = by_plants.emplace(std::move(plants), units_.size());
      if (fresh) units_.emplace_back();
      units_[at->second].paths.push_back(file.path);
      cover(file);
    }
    for (const auto& [plants, unit] : by_plants) add_monitors(plants, units_[unit]);
  }

  /// The monitors of scenarios: those of their set of the project, else the only ones that the plants have beside them.
  void add_monitors(const std::set<std::string>& plants, Unit& unit) {
    std::vector<const Candidate*> own;
    const auto add = [&](const Candidate* file) {
      if (file != nullptr && std::find(own.begin(), own.end(), file) == own.end()) own.push_back(file);
    };
    for (const SetFiles& set : sets_) {
      const bool flies = std::any_of(set.scenarios.begin(), set.scenarios.end(), [&](const std::string& path) {
        return std::any_of(unit.paths.begin(), unit.paths.end(),
                           [&](const std::string& other) { return texts_.identity(path) == texts_.identity(other); });
      });
      if (!flies) continue;
      for (const std::string& path : set.monitors) add(find(path));
    }
    if (own.empty()) {
      for (const Candidate& file : files_) {
        if (file.kind != Kind::monitors) continue;
        const Candidate* plant = plant_of(file);
        if (plant != nullptr && plants.contains(plant->id)) add(&file);
      }
      if (own.size() > 1) return;  // which of them is meant is not known
    }
    for (const Candidate* file : own) {
      unit.paths.push_back(file->path);
      cover(*file);
    }
  }

  const Candidate* with(const std::string& id) const {
    const auto found = std::find_if(files_.begin(), files_.end(), [&](const Candidate& file) { return file.id == id; });
    return found == files_.end() ? nullptr : &*found;
  }
  const Candidate* find(const std::string& path) { return with(texts_.identity(path)); }

  /// A program and a plant that the project names together, where no scenario does.
  void pairs() {
    for (const SetFiles& set : sets_) {
      if (set.plant.empty() || set.program.empty()) continue;
      const Candidate* plant = find(set.plant);
      const Candidate* program = find(set.program);
      if (plant == nullptr || program == nullptr || covered_.contains(program->id)) continue;
      if (!leads_to_open(*plant) && !leads_to_open(*program)) continue;
      units_.push_back({{plant->path, program->path}, false});
      cover(*plant);
      cover(*program);
    }
  }

  /// The plant that a set of the project has for properties or monitors: the one it names, or its scenarios name.
  const Candidate* plant_in_set(const Candidate& file) {
    for (const SetFiles& set : sets_) {
      const auto& list = file.kind == Kind::monitors ? set.monitors : set.properties;
      const bool listed = std::any_of(list.begin(), list.end(),
                                      [&](const std::string& path) { return texts_.identity(path) == file.id; });
      if (!listed) continue;
      if (!set.plant.empty()) return find(set.plant);
      for (const std::string& scenario : set.scenarios) {
        for (const std::string& named : references_.of(scenario)) {
          if (compiler::kind_by_name(named) != Kind::plant) continue;
          if (const Candidate* plant = find(named)) return plant;
        }
      }
    }
    return nullptr;
  }

  /// The plant that properties or monitors speak of: by the project, of the same name, or the only one beside them.
  const Candidate* plant_of(const Candidate& speaking) {
    if (const Candidate* plant = plant_in_set(speaking)) return plant;
    const std::filesystem::path path(speaking.path);
    std::vector<const Candidate*> beside;
    for (const Candidate& file : files_) {
      const std::filesystem::path other(file.path);
      if (file.kind != Kind::plant || other.parent_path() != path.parent_path()) continue;
      if (other.stem() == path.stem()) return &file;
      const bool imported = std::any_of(files_.begin(), files_.end(), [&](const Candidate& user) {
        return &user != &file && user.kind == Kind::plant && user.reached.contains(file.id);
      });
      if (!imported) beside.push_back(&file);
    }
    return beside.size() == 1 ? beside.front() : nullptr;
  }
  void with_plants(Kind kind) {
    for (const Candidate& file : files_) {
      if (file.kind != kind || (kind == Kind::monitors && covered_.contains(file.id))) continue;
      const Candidate* plant = plant_of(file);
      if (plant == nullptr || (!file.open && !leads_to_open(*plant))) continue;
      units_.push_back({{plant->path, file.path}, false});
      cover(file);
      cover(*plant);
    }
  }

  void add_root_of(const Candidate& file) {
    const auto imports = [&](const Candidate& user, const Candidate& used) {
      return &user != &used && user.kind == used.kind && user.reached.contains(used.id);
    };
    const auto is_root = [&](const Candidate& root) {
      return imports(root, file) &&
             std::none_of(files_.begin(), files_.end(), [&](const Candidate& above) { return imports(above, root); });
    };
    const auto root = std::find_if(files_.begin(), files_.end(), is_root);
    const Candidate& chosen = root == files_.end() ? file : *root;
    units_.push_back({{chosen.path}, true});
    cover(chosen);
  }

  References& references_;
  compiler::Provider& texts_;
  std::vector<Candidate> files_;
  std::vector<SetFiles> sets_;
  std::set<std::string> covered_;
  std::vector<Unit> units_;
};

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (compiler::kind_by_name(entry->path().string())) paths.push_back(entry->path().string());
  std::sort(paths.begin(), paths.end());
  if (paths.size() > most_files_of_a_folder) paths.resize(most_files_of_a_folder);
  return paths;
}

/// The sets of the project that a folder is in, by absolute paths. Of a manifest that is wrong, and of a set that names
/// what there is not, none: `rmplc test` tells why, and so does lint.
std::vector<SetFiles> sets_around(const std::string& folder, std::set<std::string>& manifests,
                                  compiler::Provider& texts) {
  std::vector<SetFiles> sets;
  const auto found = find_manifest(folder);
  if (!found) return sets;
  std::error_code error;
  const std::string path = std::filesystem::absolute(*found, error).lexically_normal().string();
  if (error || !manifests.insert(path).second) return sets;
  try {
    const Manifest manifest = read_manifest(path, texts.read(path));
    for (const ManifestSet& set : manifest.sets) {
      try {
        sets.push_back(files_of(manifest, set));
      } catch (const base::InputError&) {
        continue;
      }
    }
  } catch (const base::InputError&) {
  }
  return sets;
}

}  // namespace

const std::vector<std::string>& References::of(const std::string& path) {
  const auto known = known_.find(texts_.identity(path));
  if (known != known_.end()) return known->second;
  update(path);
  return known_.at(texts_.identity(path));
}

bool References::update(const std::string& path) {
  std::vector<std::string> paths;
  try {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    for (const std::string& name : named_in(texts_.read(path))) {
      paths.push_back((folder / name).lexically_normal().string());
      (void)texts_.identity(paths.back());  // a name that can be of no file throws here, and not later
    }
  } catch (const base::InputError&) {
    paths.clear();  // whoever compiles it says so
  }
  std::vector<std::string>& before = known_[texts_.identity(path)];
  if (before == paths) return false;
  before = std::move(paths);
  return true;
}

std::vector<Unit> units_of(const Documents& documents, References& references, compiler::Provider& texts) {
  Making making(references, texts);
  std::set<std::string> folders;
  for (const auto& [uri, document] : documents.all()) {
    making.add(document.path, true);
    if (document.is_file) folders.insert(std::filesystem::path(document.path).parent_path().string());
  }
  for (const std::string& folder : folders) {
    for (const std::string& path : files_in(folder)) making.add(path, false);
  }
  std::set<std::string> manifests;
  for (const std::string& folder : folders) {
    for (const SetFiles& set : sets_around(folder, manifests, texts)) making.add(set);
  }
  return making.run();
}

}  // namespace rmpl::tools
