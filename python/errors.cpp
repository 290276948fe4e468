// Exceptions of C++ to those of Python, each to its own.
// SPDX-License-Identifier: MIT
#include "python/errors.hpp"

#include <exception>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "grammar/source/render.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::python {
namespace {

template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  const pybind11::object type = pybind11::module_::import("rmpl.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

}  // namespace

void reject(const grammar::Findings& findings) {
  throw Rejected{grammar::render_text(findings, false), grammar::render_json(findings)};
}

void translate_exceptions() {
  pybind11::register_local_exception_translator(
      [](std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): as pybind11 has it
        try {
          if (thrown) std::rethrow_exception(thrown);
        } catch (const Rejected& error) {
          raise("Rejected", error.text, error.diagnostics);
        } catch (const base::InputError& error) {
          raise("InputError", error.what());
        } catch (const base::LimitError& error) {
          raise("LimitError", error.what());
        } catch (const runtime::TooManyStates& error) {
          raise("LimitError", error.what());
        } catch (const runtime::MemorySpent& error) {
          raise("LimitError", error.what());
        } catch (const base::InternalError& error) {
          raise("InternalError", error.what());
        }
      });
}

}  // namespace rmpl::python
