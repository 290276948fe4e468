// Files below the roots, by who names whom, and by what fits.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/everywhere.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "compiler/session/files.hpp"

namespace rmpl::tools {
namespace {

using compiler::Kind;

constexpr std::size_t most_files = 2'000;
constexpr std::size_t most_entries = 200'000;  ///< of folders, whatever they are
constexpr std::size_t most_pairs = 2'000;      ///< of a plant and what may fit it

/// Sources below a folder, in order. Hidden folders are left out, and links are not followed: they may lead in circles.
void add_below(const std::string& root, std::set<std::string>& paths) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, error);
  std::size_t entries = 0;
  for (; !error && entry != fs::recursive_directory_iterator() && paths.size() < most_files; entry.increment(error)) {
    if (++entries > most_entries) return;
    std::error_code unknown;
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.') && entry->is_directory(unknown)) entry.disable_recursion_pending();
    const auto kind = compiler::kind_by_name(entry->path().string());
    if (kind && *kind != Kind::document && entry->is_regular_file(unknown)) paths.insert(entry->path().string());
  }
}

class Everywhere {
 public:
  Everywhere(Workspace& workspace, std::string identity) : workspace_(workspace), identity_(std::move(identity)) {
    for (const auto& analysis : workspace.analyses()) {
      if (analysis && analysis->find(identity_)) found_.push_back(analysis);
    }
    for (const std::string& path : sources_below(workspace.roots())) {
      File file{path, workspace.texts().identity(path), *compiler::kind_by_name(path), {}};
      reach(path, file.reached);
      files_.push_back(std::move(file));
    }
  }

  std::vector<std::shared_ptr<Analysis>> run() {
    for (const Kind kind : {Kind::scenario, Kind::plant, Kind::program}) {
      for (const File& file : files_) {
        const bool concerned = file.kind == kind && file.reached.contains(identity_) && !is_found(file);
        if (concerned && is_root(file)) add({{file.path}, kind != Kind::scenario});
      }
    }
    for (const File& file : files_) {
      const bool names_no_plant =
          file.kind == Kind::program || file.kind == Kind::properties || file.kind == Kind::monitors;
      if (names_no_plant && !is_found(file)) add_with_plants(file);
    }
    return std::move(found_);
  }

 private:
  struct File {
    std::string path;
    std::string id;
    Kind kind;
    std::set<std::string> reached;  ///< by identity, itself too
  };

  void reach(const std::string& path, std::set<std::string>& reached) {
    if (!reached.insert(workspace_.texts().identity(path)).second) return;
    for (const std::string& next : workspace_.references().of(path)) reach(next, reached);
  }

  bool is_found(const File& file) const {
    return std::any_of(found_.begin(), found_.end(), [&](const auto& a) { return a->find(file.id).has_value(); });
  }

  /// Whether no file of its language imports it.
  bool is_root(const File& file) const {
    return std::none_of(files_.begin(), files_.end(), [&](const File& user) {
      return &user != &file && user.kind == file.kind && user.reached.contains(file.id);
    });
  }

  std::shared_ptr<Analysis> analysed(Unit unit) const {
    try {
      return std::make_shared<Analysis>(std::move(unit), workspace_.texts());
    } catch (const base::InputError&) {
      return nullptr;  // a file that cannot be read uses nothing
    }
  }

  void add(Unit unit) {
    if (auto analysis = analysed(std::move(unit))) found_.push_back(std::move(analysis));
  }

  void add_with_plants(const File& file) {
    const auto folder_of = [](const File& of) { return std::filesystem::path(of.path).parent_path(); };
    std::vector<std::pair<bool, std::shared_ptr<Analysis>>> fitting;  // whether the plant lies beside
    for (const File& plant : files_) {
      if (plant.kind != Kind::plant || !plant.reached.contains(identity_) || !is_root(plant)) continue;
      if (++pairs_ > most_pairs) break;
      auto analysis = analysed({{plant.path, file.path}, true});
      if (!analysis) continue;
      const auto& told = analysis->diagnostics();
      const bool wrong = std::any_of(told.begin(), told.end(), [](const grammar::Diagnostic& diagnostic) {
        return diagnostic.severity == grammar::Severity::error;
      });
      if (!wrong) fitting.emplace_back(folder_of(plant) == folder_of(file), std::move(analysis));
    }
    const bool beside = std::any_of(fitting.begin(), fitting.end(), [](const auto& one) { return one.first; });
    for (auto& [is_beside, analysis] : fitting) {
      if (is_beside || !beside) found_.push_back(std::move(analysis));
    }
  }

  Workspace& workspace_;
  std::string identity_;
  std::vector<File> files_;
  std::size_t pairs_ = 0;
  std::vector<std::shared_ptr<Analysis>> found_;
};

}  // namespace

std::set<std::string> sources_below(const std::vector<std::string>& roots) {
  std::set<std::string> paths;
  for (const std::string& root : roots) add_below(root, paths);
  return paths;
}

std::vector<std::shared_ptr<Analysis>> analyses_with(Workspace& workspace, const std::string& identity) {
  return Everywhere(workspace, identity).run();
}

}  // namespace rmpl::tools
