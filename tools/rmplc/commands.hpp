// The subcommands of rmplc: each adds itself to the program, with its options.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/shared/program.hpp"

namespace rmpl::tools {

void add_compile(Program& program);
void add_check(Program& program);
void add_lint(Program& program);
void add_import(Program& program);
void add_explain(Program& program);
void add_diagram(Program& program);
void add_format(Program& program);
void add_server(Program& program);
void add_new(Program& program);
void add_test(Program& program);

/// `-o`: where a result goes.
void add_output(Command& command, std::string& output, const char* name, const char* description);
/// `--format`: text or JSON, of diagnostics.
void add_diagnostics_format(Command& command, Common& common);
/// To a file, or without one, or with `-`, to standard output.
void write_result(const std::string& output, const std::string& text);

}  // namespace rmpl::tools
