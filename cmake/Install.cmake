# `cmake --install`: the three programs and their pages.
include(GNUInstallDirs)
install(TARGETS rmplc rmpl-run tcca-check RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
