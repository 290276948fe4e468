// One line a stream, one stream for all lines.
// SPDX-License-Identifier: MIT
#include "python/estimator.hpp"

#include <utility>

#include "base/error.hpp"
#include "compiler/session/contents.hpp"

namespace rmpl::python {

Estimator::Estimator(ModelPointer model, const runtime::LogEstimatorOptions& options, bool beam)
    : model_(std::move(model)), stats_(options.stats) {
  if (!compiler::is_model_program(model_->document())) {
    if (beam) throw base::InputError(model_->paths() + ": beam is about model programs, and this is none");
    reader_.emplace(input_, "update", model_->plant());
    plant_.emplace(model_->plant(), options);
    if (plant_->starts()) return;
    throw base::InputError(model_->paths() +
                           ": no initial state is possible: the initial modes contradict the interconnections");
  }
  if (is_about_plants(options)) {
    throw base::InputError(model_->paths() +
                           ": thesis, ranks, all_clocks, deadline and max_memory are about plants, and this is a model "
                           "program");
  }
  const automata::ModelProgram& program = model_->model_program();
  reader_.emplace(input_, "update", program);
  markings_.emplace(program, marking_options(options, beam));
  if (!markings_->starts()) compiler::refuse_start(program, model_->paths());
  variables_.emplace();
  for (const automata::Variable& variable : program.variables) variables_->push_back(variable.name);
}

const std::string& Estimator::update(const std::string& line) {
  if (spent_) throw base::InputError("this estimator ended with an error: make another one");
  input_.clear();
  input_.str(line);
  std::optional<runtime::LogLine> read = reader_->next();
  json_.clear();
  if (!read) return json_.text();
  // A plant is where it is at a time; each line of a model program's log is a step.
  if (plant_ && !read->timed && (plant_->account().updates > 0 || read->commanded)) {
    throw base::InputError("update: expected a 'time'");
  }
  line_ = *std::move(read);
  spent_ = true;  // unless this ends well
  answer();
  spent_ = false;
  return json_.text();
}

void Estimator::answer() {
  if (plant_) {
    writer_.write(json_, plant_->answer(line_), model_->plant(), [] {});
  } else {
    write(json_, markings_->answer(line_), model_->model_program(), stats_);
  }
}

}  // namespace rmpl::python
