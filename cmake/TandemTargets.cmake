# tandem_library, tandem_program, tandem_test, tandem_bench: the only way a target of ours is made, so that warnings,
# include root and optimisation are the same everywhere.

set(TANDEM_SANITIZER "" CACHE STRING "Value of -fsanitize=, empty for none")

# Asserts stay on in every build: a robot stops when in doubt. Eigen's own checks are for development only.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DEIGEN_NO_DEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")

# tandem_precompile(target header ...): parses large outside headers once for all sources of a target.
function(tandem_precompile target)
  list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>" OUTPUT_VARIABLE headers)
  target_precompile_headers(${target} PRIVATE ${headers})
  target_compile_options(${target} PRIVATE -fpch-preprocess)
endfunction()

function(tandem_target_defaults name)
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)
  if(TANDEM_SANITIZER)
    target_compile_options(${name} PUBLIC -fsanitize=${TANDEM_SANITIZER} -fno-omit-frame-pointer)
    target_link_options(${name} PUBLIC -fsanitize=${TANDEM_SANITIZER})
  endif()
endfunction()

# tandem_library(name SOURCES a.cpp ... LINKS lib ...): a library; without sources, a header-only one.
function(tandem_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    tandem_target_defaults(${name})
    target_link_libraries(${name} PUBLIC ${ARG_LINKS})
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${CMAKE_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${ARG_LINKS})
  endif()
endfunction()

# Everything a user runs, without the tests: what `./run demo` builds.
add_custom_target(all_programs)

# tandem_program(tandem-name PACKAGE robot SOURCES main.cpp ... LINKS lib ...): lands in build/bin/, and in the package
# tandem-robot: `tandem` itself for everyone's use, the services where only the service manager looks.
function(tandem_program name)
  cmake_parse_arguments(ARG "" "PACKAGE" "SOURCES;LINKS" ${ARGN})
  if(NOT ARG_PACKAGE MATCHES "^(common|robot|laptop|sim|tools)$")
    message(FATAL_ERROR "tandem_program(${name}): say in which PACKAGE it is shipped")
  endif()
  add_executable(${name} ${ARG_SOURCES})
  tandem_target_defaults(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  add_dependencies(all_programs ${name})
  if(name STREQUAL "tandem")
    install(TARGETS ${name} DESTINATION usr/bin COMPONENT ${ARG_PACKAGE})
  else()
    install(TARGETS ${name} DESTINATION usr/lib/tandem COMPONENT ${ARG_PACKAGE})
  endif()
endfunction()

# tandem_test(name SOURCES a_test.cpp ... LINKS lib ... [LABEL l] [TIMEOUT s] [SERIAL]): each TEST is a ctest test.
# One label alone: a list would swallow the properties behind it on its way through gtest_discover_tests.
# Programs that a test starts are named in PROGRAMS, so that they are built before it.
function(tandem_test name)
  cmake_parse_arguments(ARG "SERIAL" "TIMEOUT;LABEL" "SOURCES;LINKS;PROGRAMS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tandem_test(${name}) does not know: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  add_executable(${name} ${ARG_SOURCES})
  tandem_target_defaults(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    TANDEM_SOURCE_DIR="${CMAKE_SOURCE_DIR}" TANDEM_BINARY_DIR="${CMAKE_BINARY_DIR}")
  if(ARG_PROGRAMS)
    add_dependencies(${name} ${ARG_PROGRAMS})
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  set(properties TIMEOUT ${ARG_TIMEOUT})
  if(ARG_LABEL)
    list(APPEND properties LABELS ${ARG_LABEL})
  endif()
  if(ARG_SERIAL)
    list(APPEND properties RUN_SERIAL TRUE)
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()

# tandem_bench(name SOURCES ... LINKS ...): built on demand by `./run bench`, never part of the tests.
function(tandem_bench name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  tandem_target_defaults(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
endfunction()
