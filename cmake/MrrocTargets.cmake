# The framework's few kinds of target. Users get the same functions from find_package(mrroc).

# Warnings and sanitizers of our own code; third-party headers come as SYSTEM.
add_library(mrroc_flags INTERFACE)
target_compile_options(mrroc_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wconversion -Wshadow -Werror>)
if(MRROC_SANITIZE)
  add_compile_options(-fsanitize=${MRROC_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MRROC_SANITIZE})
endif()

# mrroc_library(NAME SOURCES ... [LINKS ...] [PRIVATE_LINKS ...]): one layer's static library. Includes read "folder/file.hpp".
function(mrroc_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  add_library(mrroc::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE mrroc_flags ${ARG_PRIVATE_LINKS})
endfunction()

# mrroc_data(KIND NAME): makes this folder's data files part of share/mrroc/<kind>/<name>, as an installation would.
function(mrroc_data kind name)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/mrroc/${kind})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/share/mrroc/${kind}/${name} SYMBOLIC)
endfunction()

# mrroc_add_robot(NAME SOURCES ... [LINKS ...] [EDP edp_main.cpp] [DEMO demo.cpp [SENSORS type ...]]): a robot's folder. The library
# mrroc_robot_NAME (model and typed class, public headers in include/), its data files in share/mrroc/robots/NAME, with EDP its driver
# process NAME_edp, and with DEMO the ECP program NAME_demo that NAME's demo.toml runs, linked with the sensors that it uses.
function(mrroc_add_robot name)
  cmake_parse_arguments(ARG "" "EDP;DEMO" "SOURCES;LINKS;SENSORS" ${ARGN})
  mrroc_library(mrroc_robot_${name} SOURCES ${ARG_SOURCES} LINKS mrroc_language mrroc_config ${ARG_LINKS})
  target_include_directories(mrroc_robot_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
  mrroc_data(robots ${name})
  if(ARG_EDP)
    # the EDP's layer comes after the robots: decided when every layer is known
    cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]]
      CALL mrroc_add_edp_ [[${name}]] [[${CMAKE_CURRENT_SOURCE_DIR}/${ARG_EDP}]])")
  endif()
  if(ARG_DEMO)
    cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]]
      CALL mrroc_add_demo_ [[${name}]] [[${CMAKE_CURRENT_SOURCE_DIR}/${ARG_DEMO}]] [[${ARG_SENSORS}]])")
  endif()
endfunction()

# mrroc_add_edp_(NAME SOURCE): of mrroc_add_robot; nothing in a build without EDPs.
function(mrroc_add_edp_ name source)
  if(TARGET mrroc_edp_shell)
    add_executable(${name}_edp ${source})
    target_link_libraries(${name}_edp PRIVATE mrroc_flags mrroc_robot_${name} mrroc_edp_shell)
  endif()
endfunction()

# mrroc_add_demo_(NAME SOURCE SENSORS): of mrroc_add_robot; nothing in a build without ECPs.
function(mrroc_add_demo_ name source sensors)
  if(TARGET mrroc_ecp_shell)
    mrroc_add_task(${name}_demo ECP ${source} ROBOTS ${name} SENSORS ${sensors})
    set_target_properties(${name}_demo_ecp PROPERTIES OUTPUT_NAME ${name}_demo)
  endif()
endfunction()

# mrroc_add_sensor(TYPE CLIENT ... SOURCES ... [EXECUTABLE main.cpp]): a sensor type's folder. CLIENT are the sources of
# mrroc_sensor_TYPE, what a task program links (public headers in include/); SOURCES those of mrroc_sensor_TYPE_vsp, its
# aggregating function; its data files are in share/mrroc/sensors/TYPE. EXECUTABLE is main() of its process TYPE_vsp.
function(mrroc_add_sensor type)
  cmake_parse_arguments(ARG "" "EXECUTABLE" "CLIENT;SOURCES" ${ARGN})
  mrroc_library(mrroc_sensor_${type} SOURCES ${ARG_CLIENT} LINKS mrroc_language)
  target_include_directories(mrroc_sensor_${type} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
  mrroc_library(mrroc_sensor_${type}_vsp SOURCES ${ARG_SOURCES} LINKS mrroc_vsp)
  mrroc_data(sensors ${type})
  if(ARG_EXECUTABLE)
    # the VSP's layer comes after the sensors: decided when every layer is known
    cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]]
      CALL mrroc_add_vsp_ [[${type}]] [[${CMAKE_CURRENT_SOURCE_DIR}/${ARG_EXECUTABLE}]])")
  endif()
endfunction()

# mrroc_add_vsp_(TYPE SOURCE): of mrroc_add_sensor; nothing in a build without the VSP's shell.
function(mrroc_add_vsp_ type source)
  if(TARGET mrroc_vsp_shell)
    add_executable(${type}_vsp ${source})
    target_link_libraries(${type}_vsp PRIVATE mrroc_flags mrroc_sensor_${type}_vsp mrroc_vsp_shell)
  endif()
endfunction()

# mrroc_add_task(NAME [MP mp.cpp ...] [ECP ecp.cpp ...] [ROBOTS type ...] [SENSORS type ...]): a task's programs NAME_mp and
# NAME_ecp, linked with the robots and sensors that they use. What is left out is the stock program's business.
function(mrroc_add_task name)
  cmake_parse_arguments(ARG "" "" "MP;ECP;ROBOTS;SENSORS" ${ARGN})
  list(TRANSFORM ARG_ROBOTS PREPEND mrroc_robot_)
  list(TRANSFORM ARG_SENSORS PREPEND mrroc_sensor_)
  if(ARG_MP)
    add_executable(${name}_mp ${ARG_MP})
    target_link_libraries(${name}_mp PRIVATE mrroc_mp_shell ${ARG_ROBOTS} ${ARG_SENSORS} mrroc_flags)
  endif()
  if(ARG_ECP)
    add_executable(${name}_ecp ${ARG_ECP})
    target_link_libraries(${name}_ecp PRIVATE mrroc_ecp_shell ${ARG_ROBOTS} ${ARG_SENSORS} mrroc_flags)
  endif()
endfunction()

# mrroc_test(NAME SOURCES ... LINKS ... [LABELS ...] [TIMEOUT s] [SERIAL]): one GoogleTest executable, one ctest entry.
function(mrroc_test name)
  cmake_parse_arguments(ARG "SERIAL" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE MRROC_SOURCE_DIR="${PROJECT_SOURCE_DIR}" MRROC_BINARY_DIR="${CMAKE_BINARY_DIR}")
  target_link_libraries(${name} PRIVATE mrroc_flags ${ARG_LINKS} GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}")
  if(ARG_SERIAL)
    set_tests_properties(${name} PROPERTIES RUN_SERIAL ON)
  endif()
endfunction()
