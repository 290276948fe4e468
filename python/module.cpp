// The names that the Python of `rmpl` calls; their arguments are checked there.
// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>

#include "python/errors.hpp"
#include "python/estimator.hpp"
#include "python/flight.hpp"
#include "python/model.hpp"
#include "python/questions.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace rmpl::python {
namespace {

runtime::LogEstimatorOptions estimator_options(bool exact, std::optional<std::size_t> k,
                                               std::optional<std::size_t> window, const std::string& deadline,
                                               std::optional<std::size_t> bytes, bool thesis, bool ranks,
                                               bool all_clocks, bool stats) {
  using Engine = runtime::LogEstimatorOptions::Engine;
  runtime::LogEstimatorOptions options;
  options.engine = exact ? Engine::exact : Engine::k_best;
  options.k = k;
  options.window = window;
  if (!deadline.empty()) options.deadline = duration(deadline, "deadline");
  options.bytes = bytes;
  options.thesis = thesis;
  options.ranks = ranks;
  options.all_clocks = all_clocks;
  options.stats = stats;
  return options;
}

runtime::ScenarioOptions flight_options(bool exact, std::size_t k, bool one_step, std::optional<std::uint64_t> seed) {
  using Options = runtime::ScenarioOptions;
  Options options;
  options.engine = exact ? Options::Engine::exact : Options::Engine::k_best;
  options.k = k;
  options.recovery = one_step ? Options::Recovery::one_step : Options::Recovery::planner;
  options.seed = seed;
  return options;
}

void define_model(py::module_& module) {
  py::class_<Model, std::shared_ptr<Model>>(module, "Model")
      .def(py::init<const std::vector<std::string>&, const std::map<std::string, std::string>&, const std::string&>(),
           py::call_guard<py::gil_scoped_release>())
      .def("diagnostics", &Model::diagnostics)
      .def("names", &Model::names)
      .def("text", &Model::text)
      .def("dot", &Model::dot);
}

void define_estimator(py::module_& module) {
  py::class_<Estimator>(module, "Estimator")
      .def(py::init([](const std::shared_ptr<Model>& model, bool exact, std::optional<std::size_t> k,
                       std::optional<std::size_t> window, const std::string& deadline, std::optional<std::size_t> bytes,
                       bool thesis, bool ranks, bool all_clocks, bool stats, bool beam) {
        return std::make_unique<Estimator>(
            model, estimator_options(exact, k, window, deadline, bytes, thesis, ranks, all_clocks, stats), beam);
      }))
      .def("update", &Estimator::update)
      .def("variables", &Estimator::variables);
}

void define_flight(py::module_& module) {
  using runtime::TraceDetail;
  py::enum_<TraceDetail>(module, "TraceDetail")
      .value("changes", TraceDetail::changes)
      .value("cycles", TraceDetail::cycles)
      .value("beliefs", TraceDetail::beliefs);
  py::class_<Flight>(module, "Flight")
      .def(py::init([](const std::shared_ptr<Model>& model, const std::optional<std::string>& scenario, bool exact,
                       std::size_t k, bool one_step, std::optional<std::uint64_t> seed, TraceDetail detail) {
        return std::make_unique<Flight>(model, scenario, flight_options(exact, k, one_step, seed), detail);
      }))
      .def("result", &Flight::result)
      .def("trace", &Flight::trace)
      .def("story", &Flight::story)
      .def("csv", &Flight::csv)
      .def("vcd", &Flight::vcd)
      .def("mcap", [](const Flight& flight) { return py::bytes(flight.mcap()); })
      .def("program_dot", &Flight::program_dot)
      .def("plant_dot", &Flight::plant_dot)
      .def("html", &Flight::html);
}

void define_questions(py::module_& module) {
  module.def("plan", [](const std::shared_ptr<Model>& model, const std::string& from, const std::string& goal,
                        bool one_step, const std::string& cycle) {
    return run_interruptibly([&](const std::atomic<bool>&) { return plan(model, from, goal, one_step, cycle); });
  });
  module.def("diagnose", [](const std::shared_ptr<Model>& model, const std::string& observe, const std::string& modes,
                            std::size_t k, double ratio, bool all_minimal, bool first, bool count) {
    return run_interruptibly(
        [&](const std::atomic<bool>&) { return diagnose(model, observe, modes, k, ratio, all_minimal, first, count); });
  });
  module.def("check",
             [](const std::shared_ptr<Model>& model, const std::string& properties,
                const std::optional<std::string>& text, const std::vector<std::string>& only,
                std::optional<std::size_t> states, const std::string& timeout, std::optional<std::size_t> bytes) {
               Budget budget{states, std::nullopt, bytes};
               if (!timeout.empty()) budget.time = duration(timeout, "timeout");
               return check(model, properties, text, only, budget);
             });
  module.def("campaign",
             [](const std::shared_ptr<Model>& model, const std::optional<std::string>& scenario, std::uint64_t runs,
                std::uint64_t faults, std::uint64_t seed, unsigned jobs,
                bool unmodelled) { return campaign(model, scenario, runs, faults, seed, jobs, unmodelled); });
}

}  // namespace
}  // namespace rmpl::python

PYBIND11_MODULE(_rmpl, module) {
  module.attr("version") = RMPL_VERSION;
  rmpl::python::translate_exceptions();
  rmpl::python::define_model(module);
  rmpl::python::define_estimator(module);
  rmpl::python::define_flight(module);
  rmpl::python::define_questions(module);
}
