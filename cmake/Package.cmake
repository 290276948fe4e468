# `cpack --config build/release/CPackConfig.cmake`: Debian packages: rmpl, librmpl-dev, and python3-rmpl where the module is built.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rmpl)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # else it would stand before that of each package
set(CPACK_PACKAGE_HOMEPAGE_URL "${RMPL_HOMEPAGE}")
set(CPACK_PACKAGE_CONTACT "the rmpl maintainers <maintainers@rmpl.invalid>")
set(CPACK_COMPONENTS_ALL programs development)
if(RMPL_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
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

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-rmpl)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
if(RMPL_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor})")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, graphviz") # frames, and drawings
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "timed model-based programming: the Python module
Compile, fly, estimate, plan, diagnose and check models from Python and
notebooks, with the answers of the programs as plain dictionaries.")
include(CPack)
