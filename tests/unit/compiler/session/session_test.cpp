// The session: sources from memory and from an editor, and the index of names.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "base/error.hpp"
#include "compiler/session/names.hpp"
#include "compiler/session/provider.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* plant_text = R"(domain Level = { low, high };
component Engine {
  input cmd : { none, on };
  output temp : Level;
  initial off;
  mode off; mode on { temp = high };
  off -> on when cmd = on;
}
plant Lander { engine : Engine; control engine.cmd default none; observe engine.temp; }
)";

class Session : public Workspace {
 protected:
  /// Every mention, as `text line:column of its declaration`.
  static Strings mentions(const Compilation& compilation, const std::string& of_file) {
    const grammar::Sources& sources = compilation.findings().sources;
    Strings found;
    const NameIndex names = compilation.names();
    for (const Mention& mention : names.all()) {
      if (sources[mention.span.file].name() != of_file) continue;
      const grammar::SourceFile& file = sources[mention.declaration.file];
      const grammar::Place place = file.place(mention.declaration.begin);
      found.push_back(std::string(sources.text(mention.span)) + " " + file.name() + ":" + std::to_string(place.line) +
                      ":" + std::to_string(place.column));
    }
    return found;
  }
  Memory memory_;
};

TEST_F(Session, SourcesComeFromMemory) {
  memory_.put("a/p.tcca", "import \"../level.tcca\";\nplant P { v : V; }");
  memory_.put("level.tcca", "component V { mode m; initial m; }");
  const Compilation result = compile(Strings{"a/p.tcca"}, {}, memory_);
  EXPECT_THAT(findings(result), IsEmpty());
  EXPECT_THROW(compile(Strings{"b.tcca"}, {}, memory_), base::InputError);
}

TEST_F(Session, AnOverlayLiesOverTheDisk) {
  const std::string path = write("p.rmpl", "P() :: { x = on }");
  Disk disk;
  Overlay overlay(disk);
  overlay.put(path, "P() :: { x = on; Q() }");
  EXPECT_THAT(findings(compile(Strings{path}, {}, overlay)), ElementsAre("RMPL0100 p.rmpl:1:18"));
  overlay.remove(path);
  EXPECT_THAT(findings(compile(Strings{path}, {}, overlay)), IsEmpty());
}

TEST_F(Session, NamesKnowTheirDeclarations) {
  memory_.put("p.tcca", plant_text);
  memory_.put("p.rmpl", "P(x) :: { x = 0; when x > 1 s & engine.temp = high donext Q() } Q() :: { engine = on }");
  const Compilation result = compile(Strings{"p.tcca", "p.rmpl"}, {"P"}, memory_);
  EXPECT_THAT(mentions(result, "p.rmpl"),
              ElementsAre("P p.rmpl:1:1", "x p.rmpl:1:3", "x p.rmpl:1:3", "x p.rmpl:1:3", "engine p.tcca:9:16",
                          "temp p.tcca:4:10", "high p.tcca:1:23", "Q p.rmpl:1:65", "Q p.rmpl:1:65",
                          "engine p.tcca:9:16", "on p.tcca:6:18"));
  const NameIndex names = result.names();
  const auto temp = names.at(1, 41);
  ASSERT_TRUE(temp);
  EXPECT_EQ(temp->kind, NameKind::attribute);
  EXPECT_EQ(names.of(temp->declaration).size(), 4u);
  EXPECT_FALSE(names.at(1, 30));
}

TEST_F(Session, NamesAreFoundAmongErrors) {
  memory_.put("p.tcca", "component C { input a : { x, y }; mode m; mode n; m -> when a = x; n -> m when a = y; }");
  const Compilation result = compile(Strings{"p.tcca"}, {}, memory_);
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(mentions(result, "p.tcca"), testing::Contains("y p.tcca:1:30").Times(2));
}

TEST_F(Session, SuggestionsAreEdits) {
  memory_.put("p.tcca", plant_text);
  memory_.put("p.rmpl", "P() :: { engin = on }");
  const Compilation result = compile(Strings{"p.tcca", "p.rmpl"}, {}, memory_);
  ASSERT_EQ(result.findings().diagnostics.all().size(), 1u);
  EXPECT_THAT(result.findings().diagnostics.all()[0].fix, ElementsAre(grammar::Edit{{1, 9, 14}, "engine"}));
}

}  // namespace
}  // namespace rmpl::compiler
