# What the house stands on, all from Debian; and the one way a folder becomes a library.
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost REQUIRED COMPONENTS program_options)
find_package(Threads REQUIRED)
find_package(pugixml REQUIRED)
find_package(SQLite3 REQUIRED)
find_library(CADICAL_LIBRARY cadical REQUIRED)
find_path(CADICAL_INCLUDE_DIR cadical.hpp REQUIRED)
add_library(rmpl_cadical INTERFACE)
target_link_libraries(rmpl_cadical INTERFACE $<BUILD_INTERFACE:${CADICAL_LIBRARY}> $<INSTALL_INTERFACE:cadical>)
target_include_directories(rmpl_cadical SYSTEM INTERFACE $<BUILD_INTERFACE:${CADICAL_INCLUDE_DIR}>)
find_library(BLISS_LIBRARY bliss REQUIRED)
find_path(BLISS_INCLUDE_DIR bliss/graph.hh REQUIRED)
# Debian's bliss counts in GMP's integers: what includes its headers must, too.
find_library(GMP_LIBRARY gmp REQUIRED)
add_library(rmpl_bliss INTERFACE)
target_link_libraries(rmpl_bliss INTERFACE $<BUILD_INTERFACE:${BLISS_LIBRARY}> $<BUILD_INTERFACE:${GMP_LIBRARY}>
                                           $<INSTALL_INTERFACE:bliss> $<INSTALL_INTERFACE:gmp>)
target_compile_definitions(rmpl_bliss INTERFACE BLISS_USE_GMP)
target_include_directories(rmpl_bliss SYSTEM INTERFACE $<BUILD_INTERFACE:${BLISS_INCLUDE_DIR}>)

# rmpl_folder(<name> [links…]): every .cpp below this folder, as one static library.
# A folder sees another only through a link named here; the test `arrows` checks the includes against the links.
function(rmpl_folder name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>)
  target_link_libraries(${name} PUBLIC ${ARGN} PRIVATE $<BUILD_INTERFACE:rmpl_warnings>)
endfunction()

# rmpl_program(<name> <links…>): one command-line program, of every .cpp right in this folder.
function(rmpl_program name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_executable(${name} ${sources})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARGN} CLI11::CLI11 rmpl_warnings)
  target_compile_definitions(${name} PRIVATE RMPL_VERSION="${PROJECT_VERSION}")
endfunction()
