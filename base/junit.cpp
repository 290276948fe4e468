// JUnit XML: the subset that readers agree on.
// SPDX-License-Identifier: MIT
#include "base/junit.hpp"

#include <algorithm>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

#include "base/xml_text.hpp"

namespace rmpl::base {

namespace {

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
  node.append_attribute("skipped") = 0;
  for (const TestCase& one : suite.cases) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", one.seconds);
    pugi::xml_node test = node.append_child("testcase");
    test.append_attribute("name") = xml_text(one.name).c_str();
    test.append_attribute("classname") = xml_text(one.classname).c_str();
    test.append_attribute("time") = seconds;
    if (one.outcome == Outcome::success || one.outcome == Outcome::warning) {
      // Of what has passed services show nothing else.
      const bool warns = one.outcome == Outcome::warning;
      const std::string shown = (warns ? one.message + "\n" + one.text : "") + one.notes;
      if (!shown.empty()) test.append_child("system-out").text().set(xml_text(shown).c_str());
      continue;
    }
    pugi::xml_node child = test.append_child(one.outcome == Outcome::failure ? "failure" : "error");
    child.append_attribute("message") = xml_text(one.message).c_str();
    child.text().set(xml_text(one.text + one.notes).c_str());
  }
}

}  // namespace

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

std::string to_junit(const std::string& suite, const std::vector<TestCase>& cases) {
  return to_junit(std::vector<TestSuite>{{suite, cases}});
}

}  // namespace rmpl::base
