# The warnings of the project's own code. They are errors where RMPL_WERROR is on, as in tests/run: a compiler to come has
# warnings that this one has not, and they should stop nobody who only wants to build.
option(RMPL_WERROR "Warnings are errors" OFF)
add_library(rmpl_warnings INTERFACE)
# Files that are compiled as one see each other's local names, so that parameters shadow them.
target_compile_options(rmpl_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion $<$<NOT:$<BOOL:${RMPL_UNITY}>>:-Wshadow> $<$<BOOL:${RMPL_WERROR}>:-Werror>)
