// Which figures there are, what their names stand for, and how many levels are opened.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/figures.hpp"

#include <gmock/gmock.h>

#include "compiler/diagram/blocks.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* model = R"(
component Switch { input cmd : { none, on }; initial off; mode off; mode on; fault stuck;
  off -> on when cmd = on; any -> stuck with 0.1; }
module Pair { input cmd : { none, on }; a : Switch; b : Switch; cmd = a.cmd; cmd = b.cmd; }
plant Board { left : Pair; right : Pair; main : Switch; control main.cmd default none; left.cmd = right.cmd; }
)";

class FiguresOf : public Workspace {
 protected:
  Compilation compiled(const std::string& text) {
    return compile_text("model.tcca", text, {.main = "", .types_suffice = true});
  }
  static Strings described(const std::vector<Figure>& figures) {
    Strings result;
    for (const Figure& figure : figures) result.push_back(std::string(to_string(figure.kind)) + " " + figure.name);
    return result;
  }
};

TEST_F(FiguresOf, APlantAreItsTypesModulesAndInstances) {
  const Compilation compilation = compiled(model);
  ASSERT_TRUE(compilation.ok());
  const auto figures = figures_of(compilation.document());
  EXPECT_THAT(described(figures),
              ElementsAre("plant Board", "component Switch", "module left", "module right", "instance left.a",
                          "instance left.b", "instance right.a", "instance right.b", "instance main"));
  EXPECT_THAT(described(main_figures(figures)), ElementsAre("plant Board"));
  EXPECT_THAT(described(named(figures, "left")), ElementsAre("module left"));
  EXPECT_THAT(described(named(figures, "nothing")), IsEmpty());
}

TEST_F(FiguresOf, TypesNeedNoPlant) {
  const std::string text(model);
  const Compilation compilation = compiled(text.substr(0, text.find("plant")));
  ASSERT_TRUE(compilation.ok());
  const auto figures = figures_of(compilation.document());
  EXPECT_THAT(described(main_figures(figures)), ElementsAre("component Switch"));
  EXPECT_THAT(described(named(figures, "Pair")), ElementsAre("module Pair"));
  EXPECT_THAT(to_dot(named(figures, "Switch").front(), {}), HasSubstr("cmd = on"));
}

TEST_F(FiguresOf, AnEmptyFileAreNone) { EXPECT_THAT(findings(compiled("")), ElementsAre("RMPL0207 model.tcca:1:1")); }

TEST_F(FiguresOf, AProgramComeBeforeWhatIsCalledTheSame) {
  const std::vector<std::string> paths{write("main.rmpl", "main() :: { left.a = on }"), write("model.tcca", model)};
  const Compilation compilation = compile_files(paths);
  ASSERT_TRUE(compilation.ok());
  EXPECT_THAT(described(named(figures_of(compilation.document()), "main")), ElementsAre("program main"));
}

TEST_F(FiguresOf, APlantWithAModelProgramIsItsPartsToo) {
  write("heat.rmpl", "domain S = { off, on }; variable power, hot : S; model Heat() :: { always hot = off }");
  const Compilation compilation = compiled(R"(import "heat.rmpl";
component Mains { output power : S; initial live; mode live { power = on }; fault dead; live -> dead with 0.1; }
module Half { mains : Mains; heat : model Heat; heat.power = mains.power; }
plant House { left : Half; main : Mains; observe main.power; })");
  ASSERT_TRUE(compilation.ok());
  const auto figures = figures_of(compilation.document(), compilation.plants_with_models());
  EXPECT_THAT(described(figures), ElementsAre("plant House", "component Mains", "module left", "component Heat",
                                              "instance left.mains", "instance main", "instance left.heat"));
  EXPECT_THAT(described(main_figures(figures)), ElementsAre("plant House"));
  EXPECT_THAT(to_dot(figures.front(), {}), HasSubstr("model Heat"));
  EXPECT_THAT(to_dot(named(figures, "left").front(), {}), HasSubstr("model Heat"));
  EXPECT_THAT(to_dot(named(figures, "Heat").front(), {}), HasSubstr("hot = off"));
  EXPECT_EQ(to_dot(named(figures, "Heat").front(), {}), to_dot(named(figures, "left.heat").front(), {}));
}

TEST_F(FiguresOf, ModulesAreFoldedAtADepth) {
  const Compilation compilation = compiled(model);
  const Figure plant = figures_of(compilation.document()).front();
  const std::string folded = to_dot(plant, 0);
  EXPECT_THAT(folded, HasSubstr("2 components"));
  EXPECT_THAT(folded, Not(HasSubstr("subgraph")));
  EXPECT_THAT(to_dot(plant, 1), HasSubstr("subgraph"));
  EXPECT_EQ(to_dot(plant, 1), to_dot(plant, {}));
}

TEST_F(FiguresOf, ManyBlocksAreFoldedUnasked) {
  std::string text(model);
  text.resize(text.find("plant"));
  text += "plant Board { main : Switch;";
  for (std::size_t m = 0; m < legible_blocks / 2; ++m) text += " p" + std::to_string(m) + " : Pair;";
  const Compilation compilation = compiled(text + " }");
  ASSERT_TRUE(compilation.ok());
  const Figure plant = figures_of(compilation.document()).front();
  EXPECT_EQ(to_dot(plant, {}), to_dot(plant, 0));
  EXPECT_NE(to_dot(plant, {}), to_dot(plant, 1));
}

}  // namespace
}  // namespace rmpl::compiler
