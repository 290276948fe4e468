# Warnings are errors, for the project's own code. Assertions stay on in release.
add_library(rmpl_warnings INTERFACE)
target_compile_options(rmpl_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
