# Manual pages from their scdoc sources, where scdoc is present; compressed, as they are read.
include(GNUInstallDirs)
find_program(SCDOC_PROGRAM scdoc)
if(SCDOC_PROGRAM)
  foreach(page rmplc.1 rmpl-run.1 tcca-check.1 rmpl.5 tcca.5 scn.5 props.5 mon.5 rmpl.ini.5 rmpl.toml.5)
    set(source ${CMAKE_SOURCE_DIR}/man/${page}.scd)
    set(manual ${CMAKE_BINARY_DIR}/man/${page})
    string(REGEX MATCH "[0-9]$" section ${page})
    add_custom_command(
      OUTPUT ${manual}.gz
      COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/man
      COMMAND ${SCDOC_PROGRAM} < ${source} > ${manual}
      COMMAND gzip --best --no-name --keep --force ${manual}
      DEPENDS ${source}
      VERBATIM)
    list(APPEND manuals ${manual}.gz)
    install(FILES ${manual}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section} COMPONENT programs)
  endforeach()
  add_custom_target(man ALL DEPENDS ${manuals})
endif()
