# find_package(rmpl): the libraries, and what they stand on.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(nlohmann_json 3.11)
find_dependency(pugixml)
find_dependency(Boost 1.74)
include(${CMAKE_CURRENT_LIST_DIR}/rmplTargets.cmake)
