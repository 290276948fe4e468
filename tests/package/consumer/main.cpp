// Compiles a plant from memory with the installed libraries, and tells what it holds.
// SPDX-License-Identifier: MIT
#include <iostream>
#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"

int main() {
  rmpl::compiler::Memory memory;
  memory.put("tap.tcca", R"(component Valve {
  input cmd : { none, open };
  initial closed;
  mode closed;
  mode opened;
  closed -> opened when cmd = open;
}
plant Tap {
  valve : Valve;
  control valve.cmd default none;
})");
  const std::vector<std::string> paths{"tap.tcca"};
  const rmpl::compiler::Compilation compilation = rmpl::compiler::compile(paths, {}, memory);
  if (!compilation.ok()) {
    std::cout << rmpl::grammar::render_json(compilation.findings());
    return 1;
  }
  for (const auto& plant : compilation.document().plants) {
    std::cout << plant.name << ": " << plant.components.size() << " component\n";
  }
}
