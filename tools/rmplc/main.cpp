// rmplc: compiles control programs, plant models and scenarios; explains diagnostics; draws; lays sources out.
// SPDX-License-Identifier: MIT
#include "base/output_file.hpp"
#include "tools/rmplc/commands.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* main_notes = R"(Exit status:
  0  done; lint found nothing
  1  lint found something; format --check, --diff: a file would change
  2  the command line or an input is wrong; nothing was written
  3  out of memory, or interrupted; nothing was written
  4  an internal error; nothing is claimed

Examples:
  rmplc compile mars_entry.rmpl mars_lander.tcca -o mars_entry.json
  rmplc compile --main EntrySequence edl.rmpl
  rmplc diagram mars_entry.rmpl -o mars_entry.svg
  rmplc explain RMPL0301
  rmplc format --check mars_entry.rmpl)";

}  // namespace

void add_output(Command& command, std::string& output, const char* name, const char* description) {
  command.add_option("-o,--output", output, description).option_text(name);
}

void add_diagnostics_format(Command& command, Common& common) {
  add_choice<Format>(command, "--format", common.format, {{"text", Format::text}, {"json", Format::json}},
                     "the format of diagnostics (default: text)");
}

void write_result(const std::string& output, const std::string& text) {
  if (output.empty() || output == "-") return print_file(text);
  base::write_file(output, text);
}

}  // namespace rmpl::tools

int main(int count, char** arguments) {
  using namespace rmpl::tools;
  Program program("rmplc", RMPL_VERSION,
                  "The RMPL compiler: control programs, plant models and scenarios become automata.", main_notes);
  add_compile(program);
  add_check(program);
  add_lint(program);
  add_import(program);
  add_explain(program);
  add_diagram(program);
  add_format(program);
  add_server(program);
  add_new(program);
  add_test(program);
  return program.run(count, arguments);
}
