// Reading files and following imports.
// SPDX-License-Identifier: MIT
#include "compiler/session/files.hpp"

#include <algorithm>

#include "automata/json/document.hpp"
#include "base/error.hpp"
#include "compiler/check/vocabulary.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/parse/parse_monitors.hpp"

namespace rmpl::compiler {

using grammar::Code;

namespace {

bool holds_models(const File& file) {
  const auto is_model = [](const grammar::ProgramItem& item) {
    const auto* definition = std::get_if<grammar::Definition>(&item);
    return definition != nullptr && definition->model;
  };
  return file.program && std::any_of(file.program->items.begin(), file.program->items.end(), is_model);
}

const char* name_of(const File& file) {
  switch (file.kind) {
    case Kind::program:
      return holds_models(file) ? "a model program" : "a control program";
    case Kind::plant:
      return "a plant model";
    case Kind::scenario:
      return "a set of scenarios";
    case Kind::properties:
      return "a set of properties";
    case Kind::monitors:
      return "a set of monitors";
    case Kind::document:
      return "a compiled document";
  }
  return "";
}

/// Whether the path leads to what is read once, as a pipe of a shell: its name says nothing of what is in it.
bool is_stream(const std::string& path) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  return type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character ||
         type == std::filesystem::file_type::socket;
}

/// The other scenarios of a file that name the same program or plant, the first of them each by itself.
std::vector<grammar::Note> named_again(const File& from, const grammar::String& path) {
  constexpr std::size_t most = 3;
  std::vector<grammar::Note> notes;
  std::size_t more = 0;
  const auto look = [&](const grammar::String& other) {
    if (other.text != path.text || other.span == path.span) return;
    if (notes.size() == most) ++more;
    if (notes.size() < most) notes.push_back({other.span, "it is named here, too"});
  };
  if (!from.scenarios) return notes;
  for (const grammar::ScenarioDefinition& scenario : from.scenarios->scenarios) {
    for (const grammar::ScenarioItem& item : scenario.items) {
      if (const auto* program = std::get_if<grammar::ProgramPart>(&item)) look(program->path);
      if (const auto* plant = std::get_if<grammar::PlantPart>(&item)) look(plant->path);
    }
  }
  if (more > 0) notes.back().message += ", and " + std::to_string(more) + (more == 1 ? " time more" : " times more");
  return notes;
}

/// The imports of a file in order.
std::vector<const grammar::Import*> imports_of(const File& file) {
  std::vector<const grammar::Import*> imports;
  const auto collect = [&](const auto& items) {
    for (const auto& item : items) {
      if (const auto* import = std::get_if<grammar::Import>(&item)) imports.push_back(import);
    }
  };
  if (file.program) collect(file.program->items);
  if (file.plant) collect(file.plant->items);
  return imports;
}

}  // namespace

/// A file on the way from a root, with the import that led to it.
struct Files::Importing {
  const File* file;
  const grammar::Import* import;  ///< null for a root
};

const File& Files::open(const std::string& path) {
  File& file = find(path, &Provider::read);
  file.named = true;
  return file;
}

File& Files::find(const std::string& path, Reading reading) {
  const std::string id = provider_.identity(path);
  if (const auto known = files_.find(id); known != files_.end()) return known->second;
  return read(path, id, (provider_.*reading)(path));
}

const File* Files::open(const File& from, const grammar::String& path) {
  std::string name = path.text;
  if (!std::filesystem::path(name).is_absolute() && !from.directory.empty()) {
    name = (std::filesystem::path(from.directory) / name).lexically_normal().string();
  }
  try {
    return &find(name, &Provider::read_named);
  } catch (const base::InputError& error) {
    if (!missing_.emplace(from.index, path.text).second) return nullptr;
    diagnostics_.error(Code::import_not_found, path.span, std::string("cannot read ") + error.what()).notes =
        named_again(from, path);
    return nullptr;
  }
}

File& Files::read(const std::string& path, const std::string& id, std::string text) {
  const bool standard_input = path == "-";
  auto kind = kind_by_name(path);
  const bool nameless = standard_input || (!kind && is_stream(path));
  if (nameless) kind = kind_by_content(text);
  if (!kind) throw base::InputError(not_a_model(path));
  File file;
  file.kind = *kind;
  file.directory = nameless ? "" : std::filesystem::path(path).parent_path().string();
  const std::string name = standard_input ? "<stdin>" : path;
  const auto keep = [&](auto parse, auto& tree) {
    file.whole = parse.whole;
    tree = std::move(parse.tree);
  };
  file.index = sources_.add(name, std::move(text));
  switch (file.kind) {
    case Kind::program:
      keep(grammar::parse_program(sources_, file.index, diagnostics_), file.program);
      break;
    case Kind::plant:
      keep(grammar::parse_plant(sources_, file.index, diagnostics_), file.plant);
      break;
    case Kind::scenario:
      keep(grammar::parse_scenarios(sources_, file.index, diagnostics_), file.scenarios);
      break;
    case Kind::properties:
      keep(grammar::parse_properties(sources_, file.index, diagnostics_), file.properties);
      break;
    case Kind::monitors:
      keep(grammar::parse_monitors(sources_, file.index, diagnostics_), file.monitors);
      break;
    case Kind::document:
      file.document = read_document(file.index);
      file.whole = file.document != nullptr;
      break;
  }
  return files_.emplace(id, std::move(file)).first->second;
}

std::unique_ptr<automata::Document> Files::read_document(std::uint32_t index) {
  const std::string_view text = sources_[index].text();
  if (auto plain = automata::read_plain_document(text)) {
    return std::make_unique<automata::Document>(std::move(*plain));
  }
  try {
    const automata::Json json = automata::parse_json(text);
    if (!json.is_object() || !json.contains("format")) {
      auto& error = diagnostics_.error(Code::document_schema, {index, 0, 0},
                                       "this is no compiled document: it does not say its `format`");
      error.suggestion = "`rmplc compile -o FILE.json` writes one";
      return nullptr;
    }
    return std::make_unique<automata::Document>(automata::document_from_json(json));
  } catch (const automata::Json::parse_error& error) {
    const auto at = static_cast<std::uint32_t>(std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0));
    diagnostics_.error(Code::document_schema, {index, at, at}, "the text is no JSON: syntax error here");
  } catch (const automata::Json::exception&) {
    diagnostics_.error(Code::document_schema, {index, 0, 0}, "a number in the text is out of range");
  } catch (const automata::JsonError& error) {
    const automata::JsonPlace place = automata::place_of(text, error.path(), error.blame());
    diagnostics_.error(Code::document_schema,
                       {index, static_cast<std::uint32_t>(place.begin), static_cast<std::uint32_t>(place.end)},
                       error.what());
  }
  return nullptr;
}

FileSet Files::with_imports(const std::vector<const File*>& roots) {
  FileSet set{roots, roots.size(), true};
  for (const File* root : roots) {
    std::vector<Importing> path{{root, nullptr}};
    follow(*root, path, set);
  }
  return set;
}

std::vector<File> Files::take() {
  std::vector<File> files;
  for (auto& [identity, file] : files_) files.push_back(std::move(file));
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.index < b.index; });
  files_.clear();
  return files;
}

void Files::follow(const File& file, std::vector<Importing>& path, FileSet& set) {
  constexpr std::size_t depth_limit = 200;
  const bool imported_never =
      file.kind == Kind::scenario || file.kind == Kind::properties || file.kind == Kind::monitors;
  if (imported_never || !file.whole) set.complete = false;
  if (!file.whole) return;
  for (const grammar::Import* import : imports_of(file)) {
    const File* imported = open(file, import->path);
    if (imported == nullptr) {
      set.complete = false;
      continue;
    }
    const auto on_path = [&](const Importing& step) { return step.file == imported; };
    if (std::any_of(path.begin(), path.end(), on_path)) {
      report_cycle(*imported, path, import->span);
      continue;
    }
    if (imported->kind == Kind::program && file.kind == Kind::plant) {
      set.complete = set.complete && imported->whole;
      if (std::find(set.programs.begin(), set.programs.end(), imported) == set.programs.end()) {
        set.programs.push_back(imported);
      }
      continue;
    }
    if (imported->kind != file.kind) {
      auto& error = diagnostics_.error(Code::import_not_found, import->path.span,
                                       backquoted(import->path.text) + " is " + name_of(*imported) + ", and " +
                                           name_of(file) + " imports others of its kind only");
      if (imported->kind == Kind::plant && holds_models(file)) {
        error.suggestion = "let the plant import the model program: it knows the domains that are declared there";
      }
      continue;
    }
    if (std::find(set.files.begin(), set.files.end(), imported) != set.files.end()) continue;
    if (path.size() >= depth_limit) {
      diagnostics_.error(Code::nesting_too_deep, import->span,
                         "imports nest deeper than " + std::to_string(depth_limit));
      continue;
    }
    set.files.push_back(imported);
    path.push_back({imported, import});
    follow(*imported, path, set);
    path.pop_back();
  }
}

void Files::report_cycle(const File& file, const std::vector<Importing>& path, grammar::Span span) {
  auto step = std::find_if(path.begin(), path.end(), [&](const Importing& s) { return s.file == &file; });
  std::string cycle;
  for (auto s = step; s != path.end(); ++s) cycle += sources_[s->file->index].name() + " -> ";
  auto& error =
      diagnostics_.error(Code::import_cycle, span, "the file imports itself: " + cycle + sources_[file.index].name());
  for (++step; step != path.end(); ++step) {
    error.notes.push_back({step->import->span, backquoted(sources_[step->file->index].name()) + " is imported here"});
  }
}

}  // namespace rmpl::compiler
