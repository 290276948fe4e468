// rmplc diagram: a program, a component type or a plant as a picture.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "base/error.hpp"
#include "compiler/diagram/figures.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/graphviz.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using compiler::Figure;

enum class Picture { unsaid, dot, svg, png, pdf };

/// The forms, by their names and the ends of names of files.
const std::vector<std::pair<std::string, Picture>> pictures = {
    {"dot", Picture::dot}, {"svg", Picture::svg}, {"png", Picture::png}, {"pdf", Picture::pdf}};

struct DiagramOptions {
  std::vector<std::string> files;
  std::string output;
  std::string main;
  std::string of;
  std::optional<std::size_t> depth;
  Picture format = Picture::unsaid;
};

constexpr const char* diagram_notes =
    R"(A program is drawn as its hierarchy of locations, a component type as its modes and
transitions, a plant or a module in it as a block diagram; in a model program, a
choose is a diamond, with a dot for each of its transition functions. Of several
figures --of names one: a program, a plant, a component type, the path of a module
(mes.fuel) or of a component. A file with component types alone will do.

SVG, PNG and PDF are laid out by Graphviz: its program dot must be there. DOT needs
nothing, and the same input gives the same bytes.

Without --depth a program is drawn with all that is in it, and of a plant as many
levels of modules are opened as make no more than 30 boxes.

Examples:
  rmplc diagram mars_entry.rmpl -o mars_entry.svg
  rmplc diagram mars_lander.tcca --of Engine -o engine.svg
  rmplc diagram newmaap.tcca --of mes.fuel --format dot | dot -Tpdf > fuel.pdf)";

/// `program 'Burn', plant 'Propulsion'`.
std::string listed(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& figure : figures) {
    text += (text.empty() ? "" : ", ") + std::string(to_string(figure.kind)) + " '" + figure.name + "'";
  }
  return text;
}

/// The figures that were asked for; of those that look alike the first.
std::vector<Figure> asked_for(const std::vector<Figure>& figures, const DiagramOptions& options) {
  if (options.of.empty()) return compiler::main_figures(figures);
  std::vector<Figure> found = compiler::named(figures, options.of);
  if (found.empty()) {
    std::set<std::string_view> names;
    for (const Figure& figure : figures) {
      if (figure.kind != Figure::Kind::instance) names.insert(figure.name);
    }
    throw base::InputError("--of: there is no program, component type or plant called '" + options.of + "'" +
                           suggestion_or_list(options.of, {names.begin(), names.end()}));
  }
  return found;
}

std::string drawn(const std::vector<Figure>& figures, const DiagramOptions& options) {
  const std::vector<Figure> asked = asked_for(figures, options);
  if (asked.empty()) throw base::InputError("there is nothing to draw: no program, plant or component type");
  std::string graph = to_dot(asked.front(), options.depth);
  const bool alike = std::all_of(asked.begin() + 1, asked.end(),
                                 [&](const Figure& other) { return to_dot(other, options.depth) == graph; });
  if (alike) return graph;
  if (options.of.empty()) throw base::InputError("there are several figures; choose one with --of: " + listed(asked));
  throw base::InputError("--of: '" + options.of + "' is the name of " + std::to_string(asked.size()) +
                         " different figures; give only the files of one of them");
}

/// The name of the form that was asked for, or that the name of the output tells: no end is DOT. Throws
/// base::InputError for another end, whose readers would find no picture there.
std::string form_of(const DiagramOptions& options) {
  const std::string end = std::filesystem::path(options.output).extension().string();
  for (const auto& [name, picture] : pictures) {
    if (options.format == Picture::unsaid ? end == "." + name : options.format == picture) return name;
  }
  if (end.empty() || end == ".gv") return "dot";
  throw base::InputError(options.output + ": expected a name that ends in .dot, .gv, .svg, .png or .pdf, or --format");
}

ExitStatus run(const DiagramOptions& options, const Common& common) {
  const std::string form = form_of(options);
  const compiler::Compilation result = load(options.files, common, {.main = options.main, .types_suffice = true});
  constexpr std::string_view way_out = "install the package 'graphviz', or write DOT with --format dot";
  const std::string graph = drawn(compiler::figures_of(result.document(), result.plants_with_models()), options);
  write_result(options.output, form == "dot" ? graph : picture_of(graph, form, way_out));
  return ExitStatus::done;
}

}  // namespace

void add_diagram(Program& program) {
  Command command = program.add_command("diagram", "draw a program, a component type or a plant");
  const auto options = std::make_shared<DiagramOptions>();
  command.add_option("FILE", options->files, "sources and compiled documents").required();
  add_output(command, options->output, "OUT", "write the picture to this file");
  add_choice<Picture>(command, "--format", options->format, pictures,
                      "the format of the picture (default: by the ending of OUT, else dot)");
  command.add_option("--of", options->of, "what to draw").option_text("NAME");
  add_whole_number(command, "--depth", options->depth, 0, 1000, "how many levels of boxes are opened");
  command.add_option("--main", options->main, "start the control program at this definition").option_text("NAME");
  Common& common = program.common();
  command.footer(diagram_notes);
  program.add({command, [options, &common] { return run(*options, common); }});
}

}  // namespace rmpl::tools
