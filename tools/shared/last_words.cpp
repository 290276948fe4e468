// The last words of a program, in the memory that it has.
// SPDX-License-Identifier: MIT
#include "tools/shared/last_words.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <pugixml.hpp>
#include <system_error>

#include "base/output_file.hpp"
#include "tools/shared/exit_status.hpp"

namespace rmpl::tools {
namespace {

std::atomic<bool> ours = false;

[[noreturn]] void end(ExitStatus status, const char* before, const char* reason) {
  std::fprintf(stderr, "%s: %s%s\n", program_invocation_short_name, before, reason);
  base::remove_unfinished_files();
  std::_Exit(static_cast<int>(status));
}

/// What operator new calls before it gives up. Nothing is unwound: a solver that lacked memory half-way may not be
/// destroyed, and a string stream would go on with half a text.
[[noreturn]] void on_lack_of_memory() { end(ExitStatus::undecided, "", "out of memory"); }

[[noreturn]] void on_terminate() {
  constexpr const char* internal = "internal error, so there is no result: ";
  try {
    if (const auto reason = std::current_exception()) std::rethrow_exception(reason);
  } catch (const std::exception& error) {
    if (tells_lack_of_memory(error)) on_lack_of_memory();
    end(ExitStatus::internal_error, internal, error.what());
  } catch (...) {
    end(ExitStatus::internal_error, internal, "an exception that nobody caught");
  }
  end(ExitStatus::internal_error, internal, "terminated");
}

/// Libraries exit by themselves for lack of memory alone.
void on_exit() {
  if (!ours) on_lack_of_memory();
}

/// Where pugixml gets none, it leaves out what it was to add, and goes on.
void* allocate_for_xml(std::size_t size) noexcept {
  void* const memory = std::malloc(size);
  if (memory == nullptr) on_lack_of_memory();
  return memory;
}

/// Abort and segmentation fault as they were before.
struct sigaction abort_before = {}, fault_before = {};

/// A library that goes on with the null pointer of an allocation, as bliss does, fails an assertion of its own or reads
/// what is not there. Anything else keeps its signal, and its core.
extern "C" void on_failure(int signal, siginfo_t* about, void*) {
  constexpr std::uintptr_t null_page = 1U << 16;
  const bool null = signal == SIGABRT || reinterpret_cast<std::uintptr_t>(about->si_addr) < null_page;
  if (errno == ENOMEM && null) on_lack_of_memory();
  sigaction(signal, signal == SIGABRT ? &abort_before : &fault_before, nullptr);
  if (about->si_code <= 0) std::raise(signal);  // it was sent; else what failed is tried again, and fails
}

/// Before the constructors of all that is static, which have no priority of their own.
__attribute__((constructor(101))) void choose_last_words() noexcept {
  std::set_terminate(on_terminate);
  std::set_new_handler(on_lack_of_memory);
  pugi::set_memory_management_functions(allocate_for_xml, std::free);
  struct sigaction action = {};
  action.sa_sigaction = on_failure;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGABRT, &action, &abort_before);
  sigaction(SIGSEGV, &action, &fault_before);
}

}  // namespace

bool tells_lack_of_memory(const std::exception& error) noexcept {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && system->code() == std::errc::not_enough_memory;
}

void exit_is_a_failure() noexcept { std::atexit(on_exit); }

void exit_is_ours() noexcept { ours = true; }

}  // namespace rmpl::tools
