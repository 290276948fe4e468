// Netlists as plants: both readers, their errors, and that what is written compiles.
// SPDX-License-Identifier: MIT
#include "compiler/import/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "automata/error.hpp"
#include "compiler/compiler.hpp"

namespace compiler {
namespace {

constexpr const char* adder = R"(# half an adder
INPUT(a)
INPUT(b)
OUTPUT(sum)
OUTPUT(carry)
sum = XOR(a, b)
carry = AND(a, b)
)";

std::string error_of(std::string_view text) {
  try {
    read_bench(text, "x.bench");
  } catch (const automata::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Import, ReadsBench) {
  const Netlist netlist = read_bench(adder, "x.bench");
  ASSERT_EQ(netlist.gates.size(), 2u);
  EXPECT_EQ(netlist.gates[0].name, "sum");
  EXPECT_EQ(netlist.gates[0].function, GateFunction::exclusive);
  EXPECT_EQ(netlist.gates[1].inputs, netlist.gates[0].inputs);
  EXPECT_EQ(netlist.inputs.size(), 2u);
  EXPECT_EQ(netlist.outputs.size(), 2u);
}

TEST(Import, ErrorsHaveTheirLine) {
  using testing::HasSubstr;
  EXPECT_THAT(error_of("INPUT(a)\nx = FOO(a)\n"), HasSubstr("x.bench:2:1: error: unknown gate 'FOO'"));
  EXPECT_THAT(error_of("INPUT(a)\nx = NOT(a, a)\n"), HasSubstr("wrong number of inputs"));
  EXPECT_THAT(error_of("INPUT(a)\nx = NOT(b)\n"), HasSubstr("x.bench:2:1: error: nothing drives the net 'b'"));
  EXPECT_THAT(error_of("INPUT(a)\na = NOT(a)\n"), HasSubstr("driven twice"));
  EXPECT_THAT(error_of("INPUT a\n"), HasSubstr("expected INPUT"));
  EXPECT_THAT(error_of("x =\n"), HasSubstr("expected a gate"));
  EXPECT_THAT(error_of(""), HasSubstr("without gates"));
}

TEST(Import, ReadsACatalogue) {
  const auto connection = [](const std::string& a, const std::string& b) {
    return "<connection><c1>" + a + "</c1><c2>" + b + "</c2></connection>";
  };
  const auto component = [](const std::string& name, const std::string& type) {
    return "<component><name>" + name + "</name><componentType>" + type + "</componentType></component>";
  };
  const std::string text = "<systemCatalog><systems><system><systemName>tiny</systemName><components>" +
                           component("i1", "port") + component("i2", "port") + component("o1", "port") +
                           component("g", "nand2") + component("g.o", "wire") + "</components><connections>" +
                           connection("g.i1", "i1") + connection("g.i2", "i2") + connection("g.o", "z1") +
                           connection("o1", "z1") + "</connections></system></systems></systemCatalog>";
  const Netlist netlist = read_catalogue(text, "tiny.xml");
  EXPECT_EQ(netlist.name, "tiny");
  ASSERT_EQ(netlist.gates.size(), 1u);
  EXPECT_EQ(netlist.gates[0].inputs.size(), 2u);
  ASSERT_EQ(netlist.outputs.size(), 1u);
  EXPECT_EQ(netlist.outputs[0].net, netlist.gates[0].output);
  EXPECT_THROW(read_catalogue("<a/>", "tiny.xml"), automata::InputError);
  EXPECT_THROW(read_catalogue("no xml", "tiny.xml"), automata::InputError);
}

TEST(Import, NamesBecomeIdentifiers) {
  const std::string text =
      to_tcca(read_bench("INPUT(1)\nOUTPUT(and)\nand = nand(1, 1)\n", "x.bench"), FaultModel::weak);
  EXPECT_THAT(text, testing::HasSubstr("input    N1 : Bit;"));
  EXPECT_THAT(text, testing::HasSubstr("and_.i1 = N1;"));
  EXPECT_THROW(to_tcca(read_bench("INPUT(1)\nINPUT(N1)\ng = AND(1, N1)\n", "x.bench"), FaultModel::weak),
               automata::InputError);
}

TEST(Import, WhatIsWrittenCompiles) {
  for (const FaultModel faults : {FaultModel::weak, FaultModel::strong}) {
    const std::string path = testing::TempDir() + "/import_test.tcca";
    std::ofstream(path) << to_tcca(read_bench(adder, "x.bench"), faults);
    const std::vector<std::string> paths{path};
    const Compilation compiled = compile(paths);
    ASSERT_TRUE(compiled.ok()) << compiled.diagnostics(DiagnosticFormat::text, false);
    const automata::Plant& plant = compiled.document().plants.front();
    EXPECT_EQ(plant.components.size(), 2u);
    EXPECT_EQ(plant.observables.size(), 4u);
    EXPECT_EQ(plant.components[0].modes.size(), faults == FaultModel::weak ? 2u : 4u);
  }
}

}  // namespace
}  // namespace compiler
