// Netlists as plants: both readers, their errors, and that what is written compiles.
// SPDX-License-Identifier: MIT
#include "compiler/import/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::compiler {
namespace {

constexpr const char* adder = R"(# half an adder
INPUT(a)
INPUT(b)
OUTPUT(sum)
OUTPUT(carry)
sum = XOR(a, b)
carry = AND(a, b)
)";

struct Read {
  std::optional<Netlist> netlist;
  std::string errors;  ///< as they are printed
};

Read read(std::string text, const std::string& name) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const auto file = sources.add(name, std::move(text));
  auto netlist =
      name.ends_with(".xml") ? read_catalogue(sources, file, diagnostics) : read_bench(sources, file, diagnostics);
  EXPECT_EQ(netlist.has_value(), !diagnostics.has_errors());
  return {std::move(netlist), grammar::render_text(diagnostics.sorted(), sources, false)};
}

Netlist bench(const std::string& text) { return *read(text, "x.bench").netlist; }
std::string error_of(const std::string& text) { return read(text, "x.bench").errors; }

TEST(Import, ReadsBench) {
  const Netlist netlist = bench(adder);
  ASSERT_EQ(netlist.gates.size(), 2u);
  EXPECT_EQ(netlist.gates[0].name, "sum");
  EXPECT_EQ(netlist.gates[0].function, GateFunction::exclusive);
  EXPECT_EQ(netlist.gates[1].inputs, netlist.gates[0].inputs);
  EXPECT_EQ(netlist.inputs.size(), 2u);
  EXPECT_EQ(netlist.outputs.size(), 2u);
}

TEST(Import, ErrorsHaveTheirLine) {
  using testing::HasSubstr;
  EXPECT_THAT(error_of("INPUT(a)\nx = FOO(a)\n"), HasSubstr("unknown gate `FOO`"));
  EXPECT_THAT(error_of("INPUT(a)\nx = FOO(a)\n"), HasSubstr("--> x.bench:2:5"));
  EXPECT_THAT(error_of("INPUT(a)\nx = NOT(a, a)\n"), HasSubstr("has 2 inputs, expected one"));
  EXPECT_THAT(error_of("INPUT(a)\nx = NOT(b)\n"), HasSubstr("nothing drives the net `b`"));
  EXPECT_THAT(error_of("INPUT(a)\nx = NOT(b)\n"), HasSubstr("--> x.bench:2:9"));
  EXPECT_THAT(error_of("INPUT(a)\na = NOT(a)\n"), HasSubstr("driven twice"));
  EXPECT_THAT(error_of("INPUT a\n"), HasSubstr("expected INPUT"));
  EXPECT_THAT(error_of("x =\n"), HasSubstr("expected a gate"));
  EXPECT_THAT(error_of(""), HasSubstr("without gates"));
}

TEST(Import, TellsAllErrorsButNotWithoutEnd) {
  const std::string errors = error_of("INPUT(a)\nb = FOO(a)\nc = AND(b, d)\nINPUT(a)\ne = NOT(b\n");
  for (const char* one : {"unknown gate `FOO`", "net `d`", "net `a` is driven twice", "expected INPUT(…)"}) {
    EXPECT_THAT(errors, testing::HasSubstr(one));
  }
  EXPECT_THAT(errors, testing::Not(testing::HasSubstr("`b`"))) << "a gate of an unknown kind drives its net";
  std::string many = "INPUT(a)\n";
  for (int i = 0; i < 1000; ++i) many += "b" + std::to_string(i) + " = FOO(a)\n";
  const std::string bounded = error_of(many);
  EXPECT_THAT(bounded, testing::HasSubstr("too many errors"));
  EXPECT_THAT(bounded, testing::Not(testing::HasSubstr("b101 ")));
}

TEST(Import, AByteOrderMarkIsSkippedAndAnOutputIsDeclaredOnce) {
  EXPECT_EQ(bench("\xEF\xBB\xBFINPUT(a)\nb = NOT(a)\n").gates.size(), 1u);
  EXPECT_THAT(error_of("INPUT(a)\nOUTPUT(b)\nOUTPUT(b)\nb = NOT(a)\n"), testing::HasSubstr("`b` is declared twice"));
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
  const Read tiny = read(text, "tiny.xml");
  ASSERT_TRUE(tiny.netlist) << tiny.errors;
  const Netlist& netlist = *tiny.netlist;
  EXPECT_EQ(netlist.name, "tiny");
  ASSERT_EQ(netlist.gates.size(), 1u);
  EXPECT_EQ(netlist.gates[0].inputs.size(), 2u);
  ASSERT_EQ(netlist.outputs.size(), 1u);
  EXPECT_EQ(netlist.outputs[0].net, netlist.gates[0].output);
  EXPECT_THAT(read("<a/>", "x.xml").errors, testing::HasSubstr("expected systemCatalog/systems/system"));
  EXPECT_THAT(read("no xml", "x.xml").errors, testing::HasSubstr("no XML"));
  EXPECT_THAT(read("", "x.xml").errors, testing::HasSubstr("no XML"));
}

TEST(Import, NamesBecomeIdentifiers) {
  const std::string text = to_tcca(bench("INPUT(1)\nOUTPUT(and)\nand = nand(1, 1)\n"), FaultModel::weak);
  EXPECT_THAT(text, testing::HasSubstr("input    N1 : Bit;"));
  EXPECT_THAT(text, testing::HasSubstr("and_.i1 = N1;"));
  Netlist odd = bench(adder);
  odd.gates[0].name = "a sum";
  EXPECT_THROW(to_tcca(odd, FaultModel::weak), base::InputError);
  odd = bench(adder);
  odd.name = "half\nadder";
  EXPECT_THAT(to_tcca(odd, FaultModel::weak), testing::StartsWith("// half adder: 2 gates"));
  EXPECT_THROW(to_tcca(bench("INPUT(1)\nINPUT(N1)\ng = AND(1, N1)\n"), FaultModel::weak), base::InputError);
}

TEST(Import, WhatIsWrittenCompiles) {
  for (const FaultModel faults : {FaultModel::weak, FaultModel::strong}) {
    const std::string path = testing::TempDir() + "/import_test-" + std::to_string(::getpid()) + ".tcca";
    std::ofstream(path) << to_tcca(bench(adder), faults);
    const std::vector<std::string> paths{path};
    const Compilation compiled = compile(paths);
    ASSERT_TRUE(compiled.ok()) << grammar::render_text(compiled.findings(), false);
    const automata::Plant& plant = compiled.document().plants.front();
    EXPECT_EQ(plant.components.size(), 2u);
    EXPECT_EQ(plant.observables.size(), 4u);
    EXPECT_EQ(plant.components[0].modes.size(), faults == FaultModel::weak ? 2u : 4u);
  }
}

TEST(Import, AnInputThatIsAnOutputIsOneVariable) {
  const std::string path = testing::TempDir() + "/import_test_through-" + std::to_string(::getpid()) + ".tcca";
  std::ofstream(path) << to_tcca(bench("INPUT(a)\nOUTPUT(a)\nOUTPUT(b)\nb=NOT(a)\n"), FaultModel::weak);
  const std::vector<std::string> paths{path};
  const Compilation compiled = compile(paths);
  ASSERT_TRUE(compiled.ok()) << grammar::render_text(compiled.findings(), false);
  EXPECT_EQ(compiled.document().plants.front().observables.size(), 2u);
}

TEST(Import, AGateOfManyInputsCompiles) {
  constexpr int inputs = 390;
  std::string text, call;
  for (int i = 0; i < inputs; ++i) {
    text += "INPUT(i" + std::to_string(i) + ")\n";
    call += (i == 0 ? "i" : ", i") + std::to_string(i);
  }
  text += "OUTPUT(o)\no = XOR(" + call + ")\n";
  const std::string path = testing::TempDir() + "/import_test_wide-" + std::to_string(::getpid()) + ".tcca";
  std::ofstream(path) << to_tcca(bench(text), FaultModel::weak);
  const std::vector<std::string> paths{path};
  const Compilation compiled = compile(paths);
  EXPECT_TRUE(compiled.ok()) << grammar::render_text(compiled.findings(), false);
}

}  // namespace
}  // namespace rmpl::compiler
