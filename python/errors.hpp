// What goes wrong, as exceptions of Python; and long calculations that Ctrl-C ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <string>

#include "grammar/source/findings.hpp"

namespace rmpl::python {

/// An input that has errors: its diagnostics, for people and as JSON.
struct Rejected {
  std::string text;
  std::string diagnostics;
};

/// Throws Rejected.
[[noreturn]] void reject(const grammar::Findings& findings);

/// From now on what the libraries throw, and Rejected, arrives in Python as the exceptions of rmpl.errors.
void translate_exceptions();

/// Calls `work(stop)` on a thread of its own without the lock of the interpreter, which other threads of Python may
/// have meanwhile. Signals are noticed within a twentieth of a second: their handlers run, and where one throws, as
/// that of Ctrl-C does, `stop` is set and the exception goes on once the work has ended.
template <class Work>
auto run_interruptibly(const Work& work) {
  constexpr auto pace = std::chrono::milliseconds(50);
  std::atomic<bool> stop = false;
  bool raised = false;
  std::future<decltype(work(stop))> result;
  {
    const pybind11::gil_scoped_release released;
    result = std::async(std::launch::async, [&] { return work(stop); });
    while (!raised && result.wait_for(pace) != std::future_status::ready) {
      const pybind11::gil_scoped_acquire held;
      if (PyErr_CheckSignals() == 0) continue;
      stop = raised = true;
    }
    result.wait();
  }
  if (raised) throw pybind11::error_already_set();
  return result.get();
}

}  // namespace rmpl::python
