# For the project's own code only: not available to users of find_package(mrroc).

# Warnings and sanitizers of our own code; third-party headers come as SYSTEM.
set(MRROC_WARNINGS -Wall -Wextra -Wconversion -Wshadow -Werror)
if(MRROC_FUZZ)
  set(MRROC_WARNINGS) # GCC judges: clang's are others
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(MRROC_SANITIZE) # GCC 12 misjudges code that it instruments, such as std::regex and joined strings; other builds judge
  list(APPEND MRROC_WARNINGS -Wno-array-bounds -Wno-maybe-uninitialized -Wno-stringop-overflow)
endif()
add_library(mrroc_flags INTERFACE)
target_compile_options(mrroc_flags INTERFACE ${MRROC_WARNINGS})
if(MRROC_SANITIZE)
  add_compile_options(-fsanitize=${MRROC_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MRROC_SANITIZE})
endif()

# Headers of most sources, precompiled: parsing them takes longer than compiling many sources. Only in unity builds: a
# build of single sources finds missing includes.
if(CMAKE_UNITY_BUILD)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/headers.cpp CONTENT "")
  add_library(mrroc_headers OBJECT ${CMAKE_BINARY_DIR}/headers.cpp)
  set_target_properties(mrroc_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(mrroc_headers PRIVATE Eigen3::Eigen)
  target_precompile_headers(mrroc_headers PRIVATE <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <functional>
    <map> <memory> <optional> <sstream> <string> <variant> <vector>)
  # of a library or program: position-independent code for both, as in the precompiled header
  function(mrroc_reuse_headers name)
    target_precompile_headers(${name} REUSE_FROM mrroc_headers)
    get_target_property(type ${name} TYPE)
    if(type STREQUAL EXECUTABLE)
      target_compile_options(${name} PRIVATE -fPIC)
    endif()
  endfunction()
endif()

# mrroc_add_subfolders(): every folder here with a CMakeLists.txt, in alphabetical order.
function(mrroc_add_subfolders)
  file(GLOB parts RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS */CMakeLists.txt)
  list(SORT parts)
  foreach(part ${parts})
    cmake_path(GET part PARENT_PATH folder)
    add_subdirectory(${folder})
  endforeach()
endfunction()

# mrroc_own_program(NAME FOLDER SOURCES ... [LINKS ...] [ROOMS ...]): one program of the project's own,
# build/FOLDER/NAME, not in any package: benches, fuzzers, the task programs of tests. It includes the headers of ROOMS,
# folders of the source tree.
function(mrroc_own_program name folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;ROOMS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${folder})
  list(TRANSFORM ARG_ROOMS PREPEND ${PROJECT_SOURCE_DIR}/)
  target_include_directories(${name} PRIVATE ${ARG_ROOMS})
  target_compile_definitions(${name} PRIVATE MRROC_SOURCE_DIR="${PROJECT_SOURCE_DIR}" MRROC_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_link_libraries(${name} PRIVATE mrroc_flags ${ARG_LINKS})
  if(COMMAND mrroc_reuse_headers)
    mrroc_reuse_headers(${name})
  endif()
endfunction()

# GCC takes twice the time for GoogleTest's macros with -O3; the tested code is compiled with the libraries. Three
# warnings of GCC 12 are wrong about std::string and Eigen at -O1; the libraries are compiled with them.
set(MRROC_TEST_OPTIMISATION -O1 -Wno-array-bounds -Wno-maybe-uninitialized -Wno-stringop-overflow)

# Headers of most tests, precompiled: otherwise parsing them takes a third of the whole build.
function(mrroc_test_headers)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
  add_library(mrroc_test_headers OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
  target_compile_options(mrroc_test_headers PRIVATE ${MRROC_TEST_OPTIMISATION})
  target_link_libraries(mrroc_test_headers PRIVATE mrroc_flags GTest::gtest rapidcheck Eigen3::Eigen)
  target_precompile_headers(mrroc_test_headers PRIVATE <gtest/gtest.h> <rapidcheck.h> <Eigen/Geometry>)
endfunction()

# mrroc_test_chain(CHAIN NAME...): tests that run one after the other, and therefore early.
function(mrroc_test_chain chain)
  set_tests_properties(${ARGN} PROPERTIES RESOURCE_LOCK ${chain} COST 10000)
endfunction()

# mrroc_describe_test(NAME [SLOW] [SERIAL] [TIMEOUT s] [SLOTS n] [LABELS ...]): the properties of a test in ctest, the
# same for all kinds.
#   SLOW     label slow, else fast; a test with the label system (whole deployments) is slow: `make check` runs the fast ones
#   SERIAL   needs real time: never together with another SERIAL test; it mostly waits, so that other tests can run
#   SLOTS    of `ctest -j`, six for two processors: 2, of a SERIAL test 1
# Tests that run one after the other start first, then those with a long TIMEOUT.
function(mrroc_describe_test name)
  cmake_parse_arguments(ARG "ALONE;SLOW;SERIAL" "TIMEOUT;SLOTS;SHARDS" "LABELS;SOURCES;LINKS;COMMAND" ${ARGN}) # also of the callers
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(cost ${ARG_TIMEOUT})
  if(MRROC_SANITIZE)
    math(EXPR ARG_TIMEOUT "4 * ${ARG_TIMEOUT}") # a minute becomes ten with the thread sanitizer
  endif()
  if(NOT ARG_SLOTS)
    set(ARG_SLOTS $<IF:$<BOOL:${ARG_SERIAL}>,1,2>)
  endif()
  set(speed fast)
  if(ARG_SLOW OR "system" IN_LIST ARG_LABELS)
    set(speed slow)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} COST ${cost} PROCESSORS ${ARG_SLOTS} LABELS "${ARG_LABELS};${speed}")
  # robot types that the user has added are not those of the tests
  set_tests_properties(${name} PROPERTIES ENVIRONMENT_MODIFICATION "XDG_DATA_HOME=set:${CMAKE_BINARY_DIR}/tests/user_data")
  if(ARG_SERIAL)
    mrroc_test_chain(real_time ${name})
  endif()
endfunction()

# builds what the fast tests need
add_custom_target(fast_tests)

# Compile options of the tests' sources.
function(mrroc_compile_as_test name)
  target_link_libraries(${name} PRIVATE mrroc_flags GTest::gtest)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/testing/include)
  target_compile_definitions(${name} PRIVATE MRROC_SOURCE_DIR="${PROJECT_SOURCE_DIR}" MRROC_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_compile_options(${name} PRIVATE ${MRROC_TEST_OPTIMISATION})
  if(NOT TARGET mrroc_test_headers)
    mrroc_test_headers()
  endif()
  target_precompile_headers(${name} REUSE_FROM mrroc_test_headers)
endfunction()

# mrroc_shared_tests(NAME SOURCES ... [LINKS ...]): test cases of several test executables, compiled once; they have NAME among their LINKS.
function(mrroc_shared_tests name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} OBJECT ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  mrroc_compile_as_test(${name})
endfunction()

# mrroc_test_executable(NAME SOURCES ... [LINKS ...]): build/tests/NAME, a GoogleTest executable without a ctest entry.
function(mrroc_test_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests LINKER_LANGUAGE CXX)
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest_main)
  mrroc_compile_as_test(${name})
endfunction()

# mrroc_test_group(NAME): the tests that follow in this folder are compiled together into build/tests/NAME_tests: a source
# that shares its unit with others takes a third of the time, most of which GCC spends on templates of Eigen that all of
# them use. Each source of the group has a namespace of its own. Apart are tests that count allocations, tests of
# SHARDS, tests with objects of other targets, and those that are ALONE: their GoogleTest environment is for all tests
# of an executable.
function(mrroc_test_group name)
  set_property(DIRECTORY PROPERTY MRROC_TEST_GROUP ${name}_tests)
  cmake_language(DEFER CALL mrroc_end_test_group)
endfunction()

function(mrroc_end_test_group)
  get_property(group DIRECTORY PROPERTY MRROC_TEST_GROUP)
  get_property(sources DIRECTORY PROPERTY MRROC_TEST_GROUP_SOURCES)
  get_property(links DIRECTORY PROPERTY MRROC_TEST_GROUP_LINKS)
  list(REMOVE_DUPLICATES sources)
  list(REMOVE_DUPLICATES links)
  add_executable(${group} ${sources} ${PROJECT_SOURCE_DIR}/tests/main.cpp)
  set_target_properties(${group} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${group} PRIVATE ${links})
  mrroc_compile_as_test(${group})
endfunction()

# Adds a test to the group of its folder: build/tests/NAME runs the test cases of its sources.
function(mrroc_test_of_group group name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  foreach(source ${ARG_SOURCES})
    file(STRINGS ${source} environments REGEX AddGlobalTestEnvironment)
    if(environments)
      message(FATAL_ERROR "${name}: ${source} has a GoogleTest environment, which would be of all tests of ${group}: add ALONE")
    endif()
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY MRROC_TEST_GROUP_SOURCES ${ARG_SOURCES})
  set_property(DIRECTORY APPEND PROPERTY MRROC_TEST_GROUP_LINKS ${ARG_LINKS})
  list(FILTER ARG_SOURCES INCLUDE REGEX "_test\\.cpp$")
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  list(TRANSFORM ARG_SOURCES PREPEND "--of=${folder}/")
  list(JOIN ARG_SOURCES " " files)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/tests/${name} @ONLY
    CONTENT "#!/bin/sh\nexec \"\$(dirname \"\$0\")/${group}\" ${files} \"\$@\"\n")
  file(CHMOD ${CMAKE_BINARY_DIR}/tests/${name} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
  add_custom_target(${name})
  add_dependencies(${name} ${group})
endfunction()

# mrroc_test(NAME SOURCES ... LINKS ... [SHARDS n] [LABELS ...] [TIMEOUT s] [SLOTS n] [SLOW] [SERIAL]): build/tests/NAME, GoogleTest, one ctest entry;
# with SHARDS its test cases are distributed over the entries NAME_1 ... NAME_n, which run side by side.
function(mrroc_test name)
  cmake_parse_arguments(ARG "ALONE;SLOW;SERIAL" "TIMEOUT;SLOTS;SHARDS" "SOURCES;LINKS;LABELS" ${ARGN})
  get_property(group DIRECTORY PROPERTY MRROC_TEST_GROUP)
  if(group AND NOT ARG_ALONE AND NOT ARG_SHARDS AND NOT "allocation_count" IN_LIST ARG_LINKS AND NOT "${ARG_SOURCES}" MATCHES "\\$<")
    mrroc_test_of_group(${group} ${name} SOURCES ${ARG_SOURCES} LINKS ${ARG_LINKS})
  else()
    mrroc_test_executable(${name} SOURCES ${ARG_SOURCES} LINKS ${ARG_LINKS})
  endif()
  if(NOT ARG_SHARDS)
    add_test(NAME ${name} COMMAND ${CMAKE_BINARY_DIR}/tests/${name})
    mrroc_describe_test(${name} ${ARGN})
  else()
    foreach(shard RANGE 1 ${ARG_SHARDS})
      math(EXPR index "${shard} - 1")
      add_test(NAME ${name}_${shard} COMMAND ${name})
      mrroc_describe_test(${name}_${shard} ${ARGN})
      set_tests_properties(${name}_${shard} PROPERTIES ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${index}")
    endforeach()
  endif()
  if(NOT ARG_SLOW AND NOT "system" IN_LIST ARG_LABELS)
    add_dependencies(fast_tests ${name})
  endif()
endfunction()

# mrroc_script_test(NAME COMMAND ... [LABELS ...] [TIMEOUT s] [SLOW] [SERIAL] [SLOTS n]): one ctest entry that runs a command.
function(mrroc_script_test name)
  cmake_parse_arguments(ARG "SLOW;SERIAL" "TIMEOUT;SLOTS" "COMMAND;LABELS" ${ARGN})
  add_test(NAME ${name} COMMAND ${ARG_COMMAND} COMMAND_EXPAND_LISTS)
  mrroc_describe_test(${name} ${ARGN})
endfunction()

# mrroc_socket_test(NAME TIMEOUT s COMMAND ... [SLOTS n] [VARIABLES N=V ...] [LABELS ...] [ENVIRONMENT ...]): one ctest entry
# whose command, with these environment variables, has the CAN interfaces can0 and can1: in a guest if this kernel has
# none. Not with a sanitizer, because a guest's processes have no room for its shadow memory. One guest at a time: all
# of them run on the last processor.
function(mrroc_socket_test name)
  if(MRROC_SANITIZE)
    return()
  endif()
  cmake_parse_arguments(ARG "" "TIMEOUT;SLOTS" "COMMAND;VARIABLES;LABELS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_SLOTS)
    set(ARG_SLOTS 2)
  endif()
  list(TRANSFORM ARG_VARIABLES PREPEND "--env;")
  math(EXPR longest "${ARG_TIMEOUT} + 60")
  add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/can/with_can --timeout ${ARG_TIMEOUT} ${ARG_VARIABLES} -- ${ARG_COMMAND})
  mrroc_describe_test(${name} SLOW TIMEOUT ${longest} SLOTS ${ARG_SLOTS} LABELS ${ARG_LABELS})
  set_tests_properties(${name} PROPERTIES RESOURCE_LOCK can_guest ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()
