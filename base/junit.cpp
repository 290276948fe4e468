// JUnit XML: the subset that readers agree on.
// SPDX-License-Identifier: MIT
#include "base/junit.hpp"

#include <algorithm>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/xml_text.hpp"

namespace rmpl::base {

namespace {

constexpr const char* requirement_property = "requirement";

void append(pugi::xml_node& suites, const TestSuite& suite) {
  using Outcome = TestCase::Outcome;
  const auto count = [&](Outcome outcome) {
    return std::count_if(suite.cases.begin(), suite.cases.end(),
                         [&](const TestCase& c) { return c.outcome == outcome; });
  };
  pugi::xml_node node = suites.append_child("testsuite");
  node.append_attribute("name") = xml_text(suite.name).c_str();
  node.append_attribute("tests") = suite.cases.size();
  node.append_attribute("failures") = count(Outcome::failure);
  node.append_attribute("errors") = count(Outcome::error);
  node.append_attribute("skipped") = count(Outcome::skipped);
  for (const TestCase& one : suite.cases) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", one.seconds);
    pugi::xml_node test = node.append_child("testcase");
    test.append_attribute("name") = xml_text(one.name).c_str();
    test.append_attribute("classname") = xml_text(one.classname).c_str();
    test.append_attribute("time") = seconds;
    if (!one.file.empty()) test.append_attribute("file") = xml_text(one.file).c_str();
    if (one.line > 0) test.append_attribute("line") = one.line;
    if (!one.requirements.empty()) {
      pugi::xml_node properties = test.append_child("properties");
      for (const std::string& requirement : one.requirements) {
        pugi::xml_node property = properties.append_child("property");
        property.append_attribute("name") = requirement_property;
        property.append_attribute("value") = xml_text(requirement).c_str();
      }
    }
    if (one.outcome == Outcome::success || one.outcome == Outcome::warning) {
      // Of what has passed services show nothing else.
      const bool warns = one.outcome == Outcome::warning;
      const std::string shown = (warns ? one.message + "\n" + one.text : "") + one.notes;
      if (!shown.empty()) test.append_child("system-out").text().set(xml_text(shown).c_str());
      continue;
    }
    pugi::xml_node child = test.append_child(one.outcome == Outcome::failure ? "failure"
                                             : one.outcome == Outcome::error ? "error"
                                                                             : "skipped");
    child.append_attribute("message") = xml_text(one.message).c_str();
    child.text().set(xml_text(one.text + one.notes).c_str());
  }
}

}  // namespace

TestCase no_answer(std::string name, std::string classname, const std::string& reason) {
  return {std::move(name), std::move(classname), 0, TestCase::Outcome::error, reason.substr(0, reason.find('\n')),
          reason};
}

std::string to_junit(const std::vector<TestSuite>& suites) {
  pugi::xml_document document;
  pugi::xml_node header = document.append_child(pugi::node_declaration);
  header.append_attribute("version") = "1.0";
  header.append_attribute("encoding") = "UTF-8";
  pugi::xml_node node = document.append_child("testsuites");
  for (const TestSuite& suite : suites) append(node, suite);
  std::ostringstream out;
  document.save(out, "  ");
  return std::move(out).str();
}

std::vector<TestSuite> read_junit(const std::string& text) {
  using Outcome = TestCase::Outcome;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  const pugi::xml_node root = document.child("testsuites");
  if (!parsed || !root) throw InputError(std::string("JUnit XML: ") + (parsed ? "no suites" : parsed.description()));
  std::vector<TestSuite> suites;
  for (const pugi::xml_node node : root.children("testsuite")) {
    TestSuite& suite = suites.emplace_back();
    suite.name = node.attribute("name").value();
    for (const pugi::xml_node test : node.children("testcase")) {
      TestCase one{.name = test.attribute("name").value(),
                   .classname = test.attribute("classname").value(),
                   .seconds = test.attribute("time").as_double(),
                   .outcome = Outcome::success,
                   .message = {},
                   .text = {},
                   .notes = test.child("system-out").text().get(),
                   .file = test.attribute("file").value(),
                   .line = test.attribute("line").as_uint(),
                   .requirements = {}};
      for (const pugi::xml_node property : test.child("properties").children("property")) {
        if (property.attribute("name").value() != std::string(requirement_property)) continue;
        one.requirements.emplace_back(property.attribute("value").value());
      }
      for (const auto& [name, outcome] : {std::pair{"failure", Outcome::failure}, std::pair{"error", Outcome::error},
                                          std::pair{"skipped", Outcome::skipped}}) {
        const pugi::xml_node child = test.child(name);
        if (!child) continue;
        one.outcome = outcome;
        one.message = child.attribute("message").value();
        one.text = child.text().get();
      }
      suite.cases.push_back(std::move(one));
    }
  }
  return suites;
}

std::string to_junit(const std::string& suite, const std::vector<TestCase>& cases) {
  return to_junit(std::vector<TestSuite>{{suite, cases}});
}

}  // namespace rmpl::base
