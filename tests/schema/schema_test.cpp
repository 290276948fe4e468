// Every JSON that the programs print, validated against its schema in grammar/schema.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>
#include "tests/paths.hpp"

namespace {

using nlohmann::json;

const std::filesystem::path schemas = std::filesystem::path(rmpl::paths::source()) / "grammar/schema";

json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return json::parse(file);
}

class Schema {
 public:
  explicit Schema(const std::string& name) : text_(read_json(schemas / (name + ".schema.json"))) {
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(text_), schema_);
  }

  /// Why a value does not fit; empty where it does.
  [[nodiscard]] std::string reject(const json& value) const {
    valijson::ValidationResults results;
    const valijson::adapters::NlohmannJsonAdapter target(value);
    if (valijson::Validator().validate(schema_, target, &results)) return {};
    std::string reasons;
    for (const auto& error : results) {
      for (const std::string& step : error.context) reasons += step;
      reasons += ": " + error.description + "\n";
    }
    return reasons;
  }

 private:
  json text_;
  valijson::Schema schema_;
};

struct Output {
  std::string name;
  std::string command;  ///< {examples} stands for the folder; run by the shell, its standard output is the JSON
  std::string schema;
  bool lines = false;  ///< JSON Lines
};

std::ostream& operator<<(std::ostream& out, const Output& output) { return out << output.command; }

std::string run(std::string command) {
  const std::string place = "{examples}";
  for (std::size_t at; (at = command.find(place)) != std::string::npos;)
    command.replace(at, place.size(), rmpl::paths::source() + "/examples");
  // A folder of its own: the tests run beside each other.
  const auto folder = std::filesystem::path(testing::TempDir()) / ("rmpl-schema-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  command = "cd '" + folder.string() + "' && PATH='" + rmpl::paths::programs() + "':$PATH && " + command;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t read; (read = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) > 0;)
    text.append(buffer.data(), read);
  pipe.reset();
  std::filesystem::remove_all(folder);
  return text;
}

const std::vector<Output> outputs = {
    {"DocumentOfAProgramAndAPlant",
     "rmplc compile {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca", "document"},
    {"DocumentOfScenarios", "rmplc compile {examples}/propulsion/burn.scn", "document"},
    {"DocumentOfALongProgram", "rmplc compile {examples}/mars-edl/mars_edl.rmpl", "document"},
    {"DocumentOfAModelProgram", "rmplc compile {examples}/rover-camera/rover_camera.rmpl", "document"},
    {"Diagnostics", "echo 'plant P { }' > wrong.tcca; rmplc compile --format json wrong.tcca 2>&1", "diagnostics"},
    {"Sarif",
     "echo 'P() :: { x = a; { y = b; z = c, u = d }; always v = e; w = f }' > p.rmpl; rmplc lint --format sarif p.rmpl",
     "sarif"},
    {"SarifOfNothing", "rmplc lint --format sarif {examples}/propulsion/burn.scn", "sarif"},
    {"SarifOfAnError", "echo 'plant P { }' > wrong.tcca; rmplc lint --format sarif wrong.tcca", "sarif"},
    {"Codes", "rmplc explain --list --format json", "codes"},
    {"OneCode", "rmplc explain 100 --format json", "codes"},
    {"ReachabilityHolds",
     "tcca-check reachability {examples}/propulsion/propulsion.tcca --target 'engine = heating' --format json",
     "verdict"},
    {"SafetyHolds", "tcca-check safety {examples}/propulsion/propulsion.tcca --never 'engine = failed' --format json",
     "verdict"},
    {"SafetyIsViolated",
     "tcca-check safety {examples}/propulsion/propulsion.tcca --never 'engine = failed' --faults 1 --format json",
     "verdict"},
    {"Undecided",
     "tcca-check reachability {examples}/propulsion/propulsion.tcca --target 'engine = firing' --max-states 1 --format "
     "json",
     "verdict"},
    {"CutSetsThatALimitLeaves",
     "tcca-check safety {examples}/propulsion/propulsion.tcca --never 'engine = failed' --cut-sets 2 --max-states 12 "
     "--format json",
     "verdict"},
    {"ProbabilityOfAPlant",
     "tcca-check probability {examples}/power/power.tcca --target 'relay_a = closed & battery_a = dead' --within '1 "
     "min' --time 1s --format json",
     "probability"},
    {"FaultTree",
     "tcca-check fault-tree {examples}/power/power.tcca --top 'battery_a = dead' --within '1 h' --format json",
     "fault_tree"},
    {"Hazards",
     "tcca-check check {examples}/power/power.tcca {examples}/power/hazards.props {examples}/power/power.rmpl --format "
     "json",
     "verdicts"},
    {"FailureModes", "tcca-check fmea {examples}/power/power.rmpl {examples}/power/power.tcca --format json", "fmea"},
    {"ModelProgramHolds",
     "tcca-check safety {examples}/rover-camera/rover_camera.rmpl --never 'software = corrupt & software = running' "
     "--format json",
     "verdict"},
    {"ModelProgramIsViolated",
     "tcca-check safety {examples}/rover-camera/rover_camera.rmpl --never 'report = blank' --by 4 --faults 2 --format "
     "json",
     "verdict"},
    {"ProgramHolds",
     "tcca-check program {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca --format json",
     "program_verdict"},
    {"ProgramIsViolated",
     "tcca-check program {examples}/propulsion/burn.rmpl {examples}/propulsion/propulsion.tcca --faults 1 --time 0.5s "
     "--check all --eventually 'engine = firing within 1 min' --finally 'pde = off' --format json",
     "program_verdict"},
    {"ProgramIsUndecided",
     "tcca-check program {examples}/propulsion/burn.rmpl {examples}/propulsion/propulsion.tcca --max-states 3 --format "
     "json",
     "program_verdict"},
    {"CutSetsOfAProgramThatALimitLeaves",
     "tcca-check program {examples}/propulsion/burn.rmpl {examples}/propulsion/propulsion.tcca --never 'engine = "
     "failed' "
     "--cut-sets 2 --max-states 20 --format json",
     "program_verdict"},
    {"TableThatALimitLeaves",
     "tcca-check program {examples}/propulsion/burn.rmpl {examples}/propulsion/propulsion.tcca --each-fault --finally "
     "'engine.temp = low | engine.temp = nominal' --max-states 60 --format json",
     "program_verdict"},
    {"EachFault",
     "tcca-check program {examples}/propulsion/burn.rmpl {examples}/propulsion/propulsion.tcca --each-fault --format "
     "json",
     "program_verdict"},
    {"Verdicts",
     "tcca-check check {examples}/propulsion/propulsion.tcca {examples}/propulsion/propulsion.props --format json",
     "verdicts"},
    {"VerdictsOnAProgram",
     "tcca-check check {examples}/power/power.tcca {examples}/power/power.props {examples}/power/power.rmpl --format "
     "json",
     "verdicts"},
    {"CutSetsUnderAProgram",
     "tcca-check program {examples}/power/power.rmpl {examples}/power/power.tcca --check no-plan --never 'bus = "
     "powered' --after 'bus = powered within 1 s payload = on' --cut-sets 2 --format json",
     "program_verdict"},
    {"UndecidedVerdicts",
     "tcca-check check {examples}/propulsion/propulsion.tcca {examples}/propulsion/propulsion.props --max-states 1 "
     "--format json",
     "verdicts"},
    {"Plan", "rmpl-run plan {examples}/propulsion/propulsion.tcca --goal 'engine = firing' --format json", "plan"},
    {"Policies", "rmpl-run plan {examples}/propulsion/propulsion.tcca --policy --format json", "policy"},
    {"Strategy",
     "rmpl-run plan {examples}/propulsion/propulsion.tcca --goal 'engine = standby' --strategy --format json",
     "strategy"},
    {"NothingToDo", "rmpl-run plan {examples}/propulsion/propulsion.tcca --goal 'engine = off' --format json", "plan"},
    {"Diagnoses",
     "rmpl-run diagnose {examples}/propulsion/propulsion.tcca --observe 'engine.thrust = zero' --format json",
     "diagnoses"},
    {"DiagnosesOfAModel",
     "rmpl-run diagnose {examples}/rover-camera/rover.tcca --observe 'power.current = none' --format json",
     "diagnoses"},
    {"ScenarioResult", "rmpl-run scenario {examples}/propulsion/burn.scn --format json", "scenario_result"},
    {"Coverage",
     "rmpl-run scenario {examples}/propulsion/burn.scn -q --coverage coverage.json > story.txt; cat coverage.json",
     "coverage"},
    {"CoverageOfProperties",
     "tcca-check check {examples}/propulsion/propulsion.props --coverage coverage.json > table.txt 2> warnings.txt; "
     "cat "
     "coverage.json",
     "coverage"},
    {"Baseline",
     "echo 'component C { initial a; mode a; mode b; } plant P { c : C; }' > p.tcca && rmplc lint p.tcca "
     "--write-baseline known.json && cat known.json",
     "lint_baseline"},
    {"ProjectThatPasses", "rmplc new -q demo && rmplc test demo --format json", "project_test"},
    {"ProjectThatFails",
     "rmplc new -q bad && sed -i 's/within 30 s/within 3 s/' bad/scenarios/fill.scn && rmplc test bad --format json",
     "project_test"},
    {"ProjectThatIsWrong", "rmplc new -q worse && echo x > worse/scenarios/x.scn && rmplc test worse --format json",
     "project_test"},
    {"CoverageOfAProject", "rmplc new -q whole && rmplc test whole -q --coverage all.json > summary.txt; cat all.json",
     "coverage"},
    {"Trace",
     "rmpl-run scenario {examples}/propulsion/burn.scn --only 'fire and stop' --trace trace.jsonl > story.txt; cat "
     "trace.jsonl",
     "trace", true},
    {"TraceOfALivePlant",
     "rmpl-run execute {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca -q --clock "
     "lock-step --cycle 10s --duration 3h --exec 'python3 {examples}/../tests/torture/mad_plant.py 1' --trace "
     "live.jsonl --trace-detail cycles > summary.txt; cat live.jsonl",
     "trace", true},
    {"ResultOfALivePlant",
     "rmpl-run execute {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca --clock lock-step "
     "--duration 60 --exec 'python3 -u {examples}/live/lander.py' --format json",
     "live_result"},
    {"CommandsToALivePlant",
     "rmpl-run execute {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca -q --clock "
     "lock-step --duration 60 --exec 'tee commands.jsonl | python3 -u {examples}/live/lander.py' > summary.txt; cat "
     "commands.jsonl",
     "live_command", true},
    {"AnswersOfALivePlant",
     "rmpl-run execute {examples}/mars-entry/mars_entry.rmpl {examples}/mars-entry/mars_lander.tcca -q --clock "
     "lock-step --duration 60 --exec 'python3 -u {examples}/live/lander.py | tee answers.jsonl' > summary.txt; cat "
     "answers.jsonl",
     "live_answer", true},
    {"TraceOfBeliefs",
     "rmpl-run scenario {examples}/propulsion/burn.scn --only 'fire and stop' --trace trace.jsonl --trace-detail "
     "beliefs > story.txt; cat trace.jsonl",
     "trace", true},
    {"Beliefs",
     "echo '{\"time\": 1, \"command\": {\"pde.cmd\": \"on\"}}' | rmpl-run estimate "
     "{examples}/propulsion/propulsion.tcca --log -",
     "trace", true},
    {"HistoriesOfAPlant",
     "echo '{\"time\": 1, \"command\": {\"pde.cmd\": \"on\"}}' | rmpl-run estimate "
     "{examples}/propulsion/propulsion.tcca --log - --window 2 -k 2",
     "trace", true},
    {"ModelProgramDrawn",
     "rmpl-run scenario {examples}/rover-camera/rover_camera.rmpl --commands {examples}/rover-camera/steps.jsonl "
     "--seed 3",
     "trace", true},
    {"HistoriesOfAModelProgram",
     "rmpl-run estimate {examples}/optical-navigation/optical_navigation.rmpl --log "
     "{examples}/optical-navigation/corrupted_image.jsonl --window 3 -k 2",
     "trace", true},
    {"Markings",
     "printf '{\"time\":0,\"estimate\":{\"engine\":\"off\"}}\\n{\"time\":1,\"estimate\":{\"engine\":\"standby\"}}\\n' "
     "| "
     "rmpl-run sequence {examples}/mars-entry/mars_entry.rmpl --log -",
     "trace", true},
};

class JsonOutput : public testing::TestWithParam<Output> {};

TEST_P(JsonOutput, FitsItsSchema) {
  const std::string text = run(GetParam().command);
  ASSERT_FALSE(text.empty()) << "nothing on standard output";
  const Schema schema(GetParam().schema);
  std::istringstream lines(text);
  if (!GetParam().lines) {
    EXPECT_EQ(schema.reject(json::parse(text)), "") << text.substr(0, 2000);
    return;
  }
  for (std::string line; std::getline(lines, line);) ASSERT_EQ(schema.reject(json::parse(line)), "") << line;
}

INSTANTIATE_TEST_SUITE_P(Programs, JsonOutput, testing::ValuesIn(outputs),
                         [](const auto& output) { return output.param.name; });

/// A schema that takes anything tests nothing.
TEST(Schemas, RefuseWhatIsNone) {
  for (const auto& entry : std::filesystem::directory_iterator(schemas)) {
    if (entry.path().extension() != ".json") continue;
    const std::string file = entry.path().filename().string();
    const Schema schema(file.substr(0, file.find('.')));
    EXPECT_NE(schema.reject(json::parse("{\"no such key\": 1}")), "") << file;
    EXPECT_NE(schema.reject(json(3)), "") << file;
  }
}

TEST(Schemas, AreAllUsed) {
  std::set<std::string> used{"junit.xsd"};  // by the test `ci`
  for (const Output& output : outputs) used.insert(output.schema + ".schema.json");
  for (const auto& entry : std::filesystem::directory_iterator(schemas))
    EXPECT_TRUE(used.contains(entry.path().filename().string())) << entry.path();
}

}  // namespace
