# Writes files as constants of a C++ source: OUT from FRAME, STYLE and SCRIPTS.
# SPDX-License-Identifier: MIT
#
# A compiler must take no more than 64 KiB in one literal, so each script is one of its own.
function(literal file out)
  file(READ "${file}" text)
  string(LENGTH "${text}" length)
  if(length GREATER 65000)
    message(FATAL_ERROR "${file}: too long for one literal; split the file")
  endif()
  set(${out} "R\"part(${text})part\"" PARENT_SCOPE)
endfunction()

literal("${FRAME}" frame)
literal("${STYLE}" style)
set(scripts "")
foreach(file IN LISTS SCRIPTS)
  literal("${file}" script)
  string(APPEND scripts "\n    ${script},")
endforeach()
file(WRITE "${OUT}" "#include \"runtime/report/page_parts.hpp\"

namespace rmpl::runtime {

const std::string_view page_frame = ${frame};
const std::string_view page_style = ${style};

namespace {
constexpr std::string_view scripts[] = {${scripts}};
}  // namespace

const std::span<const std::string_view> page_scripts = scripts;

}  // namespace rmpl::runtime
")
