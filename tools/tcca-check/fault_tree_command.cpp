// tcca-check fault-tree.
// SPDX-License-Identifier: MIT
#include <memory>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "tools/shared/graphviz.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/safety/tree_report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {
namespace {

struct FaultTreeOptions {
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  std::string model, top, output;
  std::optional<automata::Ticks> within;
  std::optional<std::size_t> listed;
  Freedom freedom;
  verifier::Commands commands = verifier::Commands::one;
  Budget budget;
  bool statistics = false;
};

enum class TreeForm { none, open_psa, svg, dot };

TreeForm form_of(const std::string& path) {
  if (path.empty()) return TreeForm::none;
  if (path.ends_with(".xml")) return TreeForm::open_psa;
  if (path.ends_with(".svg")) return TreeForm::svg;
  if (path.ends_with(".dot")) return TreeForm::dot;
  throw base::InputError("-o " + path + ": expected a name that ends in .xml, .svg or .dot");
}

/// What is drawn is to be looked at.
constexpr std::size_t most_drawn = 500;

std::string written(TreeForm form, const automata::Plant& plant, const verifier::FaultTreeQuestion& question,
                    const verifier::FaultTree& tree, const std::string& asked) {
  if (form == TreeForm::open_psa) return verifier::to_open_psa(plant, question, tree);
  if (tree.sets.size() > most_drawn) {
    throw base::InputError("a drawing of " + std::to_string(tree.sets.size()) +
                           " sets is unreadable; use --list N with at most " + std::to_string(most_drawn));
  }
  const std::string graph = verifier::to_dot(plant, tree, asked);
  return form == TreeForm::dot ? graph : svg_of(graph, "install the package 'graphviz', or write a .dot file");
}

ExitStatus run(const FaultTreeOptions& options, const Common& common) {
  const TreeForm form = form_of(options.output);
  const compiler::Compilation compilation =
      load({options.model}, common, {.main = options.main, .model_is_plant = true});
  const automata::Plant& plant = only_plant(compilation.document(), options.model);
  constexpr unsigned default_order = 2;
  const Freedom& freedom = options.freedom;
  verifier::FaultTreeQuestion question{.top = formula_option(options.top, plant, "--top", common),
                                       .period = freedom.period,
                                       .within = options.within,
                                       .order = freedom.faults.value_or(default_order),
                                       .listed = options.listed,
                                       .commands = options.commands,
                                       .from = assignments_option(freedom.from, plant, "--from", common)};
  if (options.within && options.within->is_infinite()) throw base::InputError("--within inf: expected a finite time");
  verifier::demand_modes(plant, question.from);
  automata::PlantStep step(plant);
  const verifier::FaultTree tree = verifier::fault_tree(step, question, limits(options.budget, common));
  if (form != TreeForm::none && !tree.limit) {
    base::write_file(options.output, written(form, plant, question, tree, options.top));
  }
  print_answer(
      common,
      [&] {
        return verifier::to_text(plant, question, tree, options.top) +
               (options.statistics ? verifier::statistics_text(tree.progress) : "");
      },
      [&] { return verifier::to_json(plant, question, tree, options.top); },
      []() -> std::string { throw base::InputError("--format junit is for verdicts; expected text or json"); });
  return tree.limit ? ExitStatus::undecided : ExitStatus::done;
}

constexpr const char* fault_tree_notes =
    R"(Exit status: 0 the sets are told, 2 the command line or an input is wrong, 3 undecided: a limit or
a signal ended it before all were found, 4 an internal error, and nothing is claimed.)";

}  // namespace

void add_fault_tree(Program& program) {
  Command command = program.add_command(
      "fault-tree",
      "find the minimal sets of faults that cause a formula, their probabilities, and the importance of each fault");
  const auto options = std::make_shared<FaultTreeOptions>();
  add_model(command, options->model, options->main);
  add_text(command, "--top", options->top, "FORMULA", "the top event").required();
  add_text(command, "-o,--output", options->output, "OUT.xml|OUT.svg|OUT.dot",
           "write the sets as a fault tree in the Open-PSA format, or draw it");
  add_read(command, "--within", options->within, duration, "compute probabilities up to this time, from the start")
      .option_text("T");
  constexpr std::uint64_t most = 10'000'000;
  add_whole_number(command, "--list", options->listed, 0, most,
                   "list this number of sets, the likeliest first; all are counted");
  add_freedom(command, options->freedom, false);
  command.option("--faults")
      .description("largest number of faults in a set (default: 2); a plant without dynamics has no such limit");
  add_commands(command, options->commands);
  add_budget(command, options->budget);
  add_answer_form(command, program.common(), options->statistics);
  command.footer(fault_tree_notes);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
