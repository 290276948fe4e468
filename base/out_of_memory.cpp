// The last words of a program, in the memory that it has.
// SPDX-License-Identifier: MIT
#include "base/out_of_memory.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "base/check.hpp"

namespace rmpl::base {

void end_for_lack_of_memory(const char* program) noexcept {
  constexpr int limit_hit = 3;
  constexpr int internal_error = 4;
  try {
    if (const auto reason = std::current_exception()) std::rethrow_exception(reason);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory\n", program);
    std::_Exit(limit_hit);
  } catch (const InternalError& error) {
    std::fprintf(stderr, "%s: internal error, nothing is claimed: %s\n", program, error.what());
    std::_Exit(internal_error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
  } catch (...) {
    std::fprintf(stderr, "%s: an exception that nobody caught\n", program);
  }
  std::abort();
}

}  // namespace rmpl::base
