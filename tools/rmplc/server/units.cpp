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
    const auto same = std::find_if(files_.begin(), files_.end(), [&](const Candidate& f) { return f.id == id; });
    if (same == files_.end()) files_.push_back({path, id, *kind, open, {}});
  }

  std::vector<Unit> run() {
    for (Candidate& file : files_) reach(file.path, file.id, file.reached);
    scenarios();
    properties();
    for (const Candidate& file : files_) {
      if (file.open && !covered_.contains(file.id)) add_root_of(file);
    }
    return std::move(units_);
  }

 private:
  void reach(const std::string& path, const std::string& id, std::set<std::string>& reached) {
    if (!reached.insert(id).second) return;
    for (const std::string& next : references_.of(path)) reach(next, texts_.identity(next), reached);
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
  }

  /// The plant that a file of properties speaks of: of the same name, or the only one beside it.
  const Candidate* plant_of(const Candidate& properties) {
    const std::filesystem::path path(properties.path);
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
  void properties() {
    for (const Candidate& file : files_) {
      if (file.kind != Kind::properties) continue;
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
  return making.run();
}

}  // namespace rmpl::tools
