# `cmake --install` and the packages: what goes where. Two components, two packages: the programs with all that people use
# beside them, and the libraries for people who build upon them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # installs what is built: tests need not be
set(RMPL_PROGRAMS rmplc rmpl-run tcca-check)

# Programs, and what the shells are told about them.
install(TARGETS ${RMPL_PROGRAMS} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
function(rmpl_completion program shell file destination)
  set(script ${CMAKE_BINARY_DIR}/completions/${file})
  add_custom_command(
    OUTPUT ${script}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/completions
    COMMAND ${program} --completion ${shell} > ${script}
    DEPENDS ${program}
    VERBATIM)
  install(FILES ${script} DESTINATION ${destination} COMPONENT programs)
  set_property(GLOBAL APPEND PROPERTY RMPL_COMPLETIONS ${script})
endfunction()
foreach(program ${RMPL_PROGRAMS})
  rmpl_completion(${program} bash ${program} ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  rmpl_completion(${program} zsh _${program} ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  rmpl_completion(${program} fish ${program}.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endforeach()
get_property(completions GLOBAL PROPERTY RMPL_COMPLETIONS)
add_custom_target(completions ALL DEPENDS ${completions})

# Data and documentation.
install(DIRECTORY grammar/schema/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rmpl/schema COMPONENT programs
        FILES_MATCHING PATTERN "*.schema.json" PATTERN "*.xsd")
install(DIRECTORY grammar/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rmpl/grammar COMPONENT programs
        FILES_MATCHING PATTERN "*.ebnf" PATTERN ast EXCLUDE PATTERN editor EXCLUDE PATTERN parse EXCLUDE PATTERN schema EXCLUDE
        PATTERN source EXCLUDE)
if(EXISTS ${CMAKE_SOURCE_DIR}/editors)
  install(DIRECTORY editors/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rmpl/editors COMPONENT programs)
endif()
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT programs)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT programs
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.y*ml" PATTERN development.md EXCLUDE PATTERN architecture.md EXCLUDE
        PATTERN "house.*" EXCLUDE PATTERN site EXCLUDE)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT programs
        PATTERN CMakeLists.txt EXCLUDE PATTERN fly EXCLUDE PATTERN check EXCLUDE)

# The libraries: find_package(rmpl), targets rmpl::automata, …
set(RMPL_LIBRARIES base automata grammar language lint_codes lint diagram format import compiler reasoning telemetry executive report verifier)
install(TARGETS ${RMPL_LIBRARIES} rmpl_cadical rmpl_bliss EXPORT rmpl
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/rmpl COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rmpl)
foreach(folder base automata grammar compiler runtime verifier)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rmpl COMPONENT development
          FILES_MATCHING PATTERN "*.hpp" PATTERN schema EXCLUDE)
endforeach()
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/rmpl)
install(EXPORT rmpl NAMESPACE rmpl:: FILE rmplTargets.cmake DESTINATION ${config} COMPONENT development)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/rmplConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/rmplConfig.cmake ${CMAKE_BINARY_DIR}/rmplConfigVersion.cmake DESTINATION ${config}
        COMPONENT development)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/librmpl-dev RENAME copyright COMPONENT development)
