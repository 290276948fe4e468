# `cpack --config build/release/CPackConfig.cmake`: two Debian packages, rmpl and librmpl-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rmpl)
set(CPACK_PACKAGE_CONTACT "the rmpl maintainers <maintainers@rmpl.invalid>")
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME rmpl)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS graphviz) # rmplc diagram lays out SVG with it
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION
    "timed model-based programming: compile, verify, fly
Compiler, verifier and executive for control programs in RMPL and plant
models that are timed concurrent constraint automata.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librmpl-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libcadical-dev, libbliss-dev, libgmp-dev, libpugixml-dev, nlohmann-json3-dev, libboost-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "timed model-based programming: the libraries
Static libraries, headers and a CMake package of the toolchain.")
include(CPack)
