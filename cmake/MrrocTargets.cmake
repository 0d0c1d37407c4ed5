include(${CMAKE_CURRENT_LIST_DIR}/MrrocSensorClass.cmake)

# The framework's few kinds of target, for its own folders and, after find_package(mrroc), for those of its users. Programs go to
# bin/ and data to share/mrroc/ of the build folder: `mrroc run` finds them there. In an installation bin/ contains only
# the commands, and libexec/mrroc/ the programs that `mrroc run` starts. Components of an installation: runtime,
# development.

# mrroc_library(NAME SOURCES ... [LINKS ...] [PRIVATE_LINKS ...] [INTERNAL]): one static library. Includes read "folder/file.hpp";
# the folder's include/ is public too. INTERNAL: of our own programs only, not part of the package.
function(mrroc_library name)
  cmake_parse_arguments(ARG "INTERNAL" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  string(REGEX REPLACE "^mrroc_" "" short_name ${name})
  add_library(mrroc::${short_name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${short_name} POSITION_INDEPENDENT_CODE ON)
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include)
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
  endif()
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_compile_options(${name} PRIVATE ${MRROC_WARNINGS})
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(COMMAND mrroc_reuse_headers)
    mrroc_reuse_headers(${name})
  endif()
  if(NOT ARG_INTERNAL)
    install(TARGETS ${name} EXPORT ${PROJECT_NAME} ARCHIVE DESTINATION lib/mrroc COMPONENT development)
  endif()
endfunction()

# mrroc_program(NAME [COMMAND] SOURCES ... LINKS ...): one program, in bin/; COMMAND: typed by users, other programs are
# installed in libexec/mrroc/.
function(mrroc_program name)
  cmake_parse_arguments(ARG "COMMAND" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
  target_compile_options(${name} PRIVATE ${MRROC_WARNINGS})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS})
  if(COMMAND mrroc_reuse_headers)
    mrroc_reuse_headers(${name})
  endif()
  install(TARGETS ${name} RUNTIME DESTINATION $<IF:$<BOOL:${ARG_COMMAND}>,bin,libexec/mrroc> COMPONENT runtime)
endfunction()

# mrroc_data(KIND NAME): makes this folder's data files part of share/mrroc/<kind>/<name>, as an installation would.
function(mrroc_data kind name)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/mrroc/${kind})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/share/mrroc/${kind}/${name} SYMBOLIC)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION share/mrroc/${kind}/${name} COMPONENT runtime
    PATTERN "*.[ch]pp" EXCLUDE PATTERN CMakeLists.txt EXCLUDE PATTERN include EXCLUDE PATTERN description EXCLUDE PATTERN "*.py" EXCLUDE)
endfunction()

# mrroc_add_robot(NAME SOURCES ... [LINKS ...] [EDP edp_main.cpp] [DEMO demo.cpp [SENSORS type ...]]): a robot's folder. The library
# mrroc_robot_NAME (model and typed class, public headers in include/), its data files in share/mrroc/robots/NAME, with EDP its driver
# process NAME_edp and its simulated drives on a CAN bus NAME_drives, and with DEMO the ECP program NAME_demo that NAME's demo.toml runs, linked with the sensors that it uses.
function(mrroc_add_robot name)
  cmake_parse_arguments(ARG "" "EDP;DEMO" "SOURCES;LINKS;SENSORS" ${ARGN})
  mrroc_library(mrroc_robot_${name} SOURCES ${ARG_SOURCES} LINKS mrroc::language mrroc::config ${ARG_LINKS})
  mrroc_data(robots ${name})
  if(ARG_EDP)
    mrroc_program(${name}_edp SOURCES ${ARG_EDP} LINKS mrroc::robot_${name} mrroc::edp_shell)
    mrroc_program(${name}_drives SOURCES ${ARG_EDP} LINKS mrroc::robot_${name} mrroc::drives_shell)
  endif()
  if(ARG_DEMO)
    list(TRANSFORM ARG_SENSORS PREPEND mrroc::sensor_)
    mrroc_program(${name}_demo SOURCES ${ARG_DEMO} LINKS mrroc::ecp_shell mrroc::robot_${name} ${ARG_SENSORS})
  endif()
endfunction()

# mrroc_add_sensor(TYPE [CLIENT ...] [SOURCES ...] [EXECUTABLE main.cpp] [WRENCH wrench.cpp]): a sensor type's folder. The class that a task program declares is
# made from the channels in TYPE.toml: <mrroc/sensors/TYPE.hpp>; a folder that writes that header itself (in include/, for conditions
# and the like) gets the base class from <mrroc/sensors/TYPE_channels.hpp>. CLIENT are further sources of
# mrroc_sensor_TYPE, which a task program links; SOURCES those of mrroc_sensor_TYPE_vsp, its aggregating function, which
# tests link; its data files are in share/mrroc/sensors/TYPE. EXECUTABLE is main() of its process TYPE_vsp, with the
# aggregating function where there are no SOURCES. WRENCH: a source with MRROC_WRENCH_SOURCE, which makes the plug-in
# lib/mrroc/sensors/TYPE.so of SOURCES, for the EDP of a robot whose force sensor is of this type.
function(mrroc_add_sensor type)
  cmake_parse_arguments(ARG "" "EXECUTABLE;WRENCH" "CLIENT;SOURCES" ${ARGN})
  set(made ${CMAKE_CURRENT_BINARY_DIR}/include)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include/mrroc/sensors/${type}.hpp)
    mrroc_sensor_class(${type} ${CMAKE_CURRENT_SOURCE_DIR}/${type}.toml ${made} Channels _channels)
  else()
    mrroc_sensor_class(${type} ${CMAKE_CURRENT_SOURCE_DIR}/${type}.toml ${made} "" "")
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${type}_class.cpp CONTENT "#include \"mrroc/sensors/${type}.hpp\"\n")
    list(APPEND ARG_CLIENT ${CMAKE_CURRENT_BINARY_DIR}/${type}_class.cpp)
  endif()
  mrroc_library(mrroc_sensor_${type} SOURCES ${ARG_CLIENT} LINKS mrroc::language)
  target_include_directories(mrroc_sensor_${type} PUBLIC $<BUILD_INTERFACE:${made}>)
  install(DIRECTORY ${made}/ DESTINATION include/mrroc COMPONENT development)
  mrroc_data(sensors ${type})
  if(ARG_SOURCES)
    mrroc_library(mrroc_sensor_${type}_vsp SOURCES ${ARG_SOURCES} LINKS mrroc::vsp)
    list(APPEND ARG_EXECUTABLE_LINKS mrroc::sensor_${type}_vsp)
  endif()
  if(ARG_EXECUTABLE)
    mrroc_program(${type}_vsp SOURCES ${ARG_EXECUTABLE} LINKS ${ARG_EXECUTABLE_LINKS} mrroc::vsp_shell)
  endif()
  if(ARG_WRENCH)
    mrroc_plugin(mrroc_wrench_${type} sensors ${type} ${CMAKE_BINARY_DIR} SOURCES ${ARG_WRENCH} LINKS mrroc::sensor_${type}_vsp)
  endif()
endfunction()

# mrroc_plugin(TARGET KIND NAME INTO SOURCES ... LINKS ...): a shared library that programs load, INTO/lib/mrroc/KIND/NAME.so. Its
# classes are invisible outside, so two of them may have the same names.
function(mrroc_plugin target kind name into)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${target} MODULE ${ARG_SOURCES})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} PREFIX "" CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${into}/lib/mrroc/${kind})
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_options(${target} PRIVATE ${MRROC_WARNINGS})
  target_link_libraries(${target} PRIVATE mrroc::config mrroc::plugin mrroc::world_memory ${ARG_LINKS})
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL -Wl,--no-undefined)
  if(COMMAND mrroc_reuse_headers)
    mrroc_reuse_headers(${target})
  endif()
  if(TARGET mrroc_drivers)
    add_dependencies(mrroc_drivers ${target})
  endif()
  if(into STREQUAL CMAKE_BINARY_DIR)
    install(TARGETS ${target} LIBRARY DESTINATION lib/mrroc/${kind} COMPONENT runtime
      PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  endif()
endfunction()

# mrroc_add_driver(NAME SOURCES ... [LINKS ...]): a driver's folder, of robots or of sensors: the plug-in
# lib/mrroc/drivers/NAME.so, with its declaration NAME.toml in share/mrroc/drivers/NAME. With the variable MRROC_DRIVERS_INTO they are in that folder, and in no package.
function(mrroc_add_driver name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  set(into ${CMAKE_BINARY_DIR})
  if(MRROC_DRIVERS_INTO)
    set(into ${MRROC_DRIVERS_INTO})
  endif()
  mrroc_plugin(mrroc_driver_${name} drivers ${name} ${into} SOURCES ${ARG_SOURCES} LINKS mrroc::edp ${ARG_LINKS})
  if(MRROC_DRIVERS_INTO)
    file(MAKE_DIRECTORY ${into}/share/mrroc/drivers)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${into}/share/mrroc/drivers/${name} SYMBOLIC)
  else()
    mrroc_data(drivers ${name})
  endif()
endfunction()

# mrroc_add_driver_test(NAME DRIVER driver TYPE type [PARAMETERS file] SOURCES ... [LINKS ...]): the conformance test of a driver, a program
# with MRROC_DRIVER_TEST (<mrroc/testing/driver.hpp>) for a robot of that type, and its entry in ctest. Needs enable_testing().
function(mrroc_add_driver_test name)
  cmake_parse_arguments(ARG "" "DRIVER;TYPE;PARAMETERS" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  # its malloc and pthread_mutex_lock are those of the driver's library, too
  set_target_properties(${name} PROPERTIES ENABLE_EXPORTS ON)
  target_compile_options(${name} PRIVATE ${MRROC_WARNINGS})
  target_link_libraries(${name} PRIVATE mrroc::driver_test mrroc::robot_${ARG_TYPE} ${ARG_LINKS})
  add_test(NAME ${name} COMMAND ${name} ${ARG_DRIVER} ${ARG_TYPE} ${ARG_PARAMETERS})
  if(DEFINED mrroc_PREFIX)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "MRROC_PLUGINS=${CMAKE_BINARY_DIR}/lib/mrroc:${mrroc_PREFIX}/lib/mrroc;MRROC_SHARE=${CMAKE_BINARY_DIR}/share/mrroc:${mrroc_PREFIX}/share/mrroc;MRROC_PROGRAMS=${CMAKE_BINARY_DIR}/bin:${mrroc_PREFIX}/libexec/mrroc:${mrroc_PREFIX}/bin")
  endif()
endfunction()

# mrroc_add_task(NAME [MP mp.cpp ...] [ECP ecp.cpp ...] [ROBOTS type ...] [SENSORS type ...]): a task's programs NAME_mp and
# NAME_ecp, linked with the robots and sensors that they use. The stock programs replace those that are left out.
function(mrroc_add_task name)
  cmake_parse_arguments(ARG "" "" "MP;ECP;ROBOTS;SENSORS" ${ARGN})
  list(TRANSFORM ARG_ROBOTS PREPEND mrroc::robot_)
  list(TRANSFORM ARG_SENSORS PREPEND mrroc::sensor_)
  if(ARG_MP)
    mrroc_program(${name}_mp SOURCES ${ARG_MP} LINKS mrroc::mp_shell ${ARG_ROBOTS} ${ARG_SENSORS})
  endif()
  if(ARG_ECP)
    mrroc_program(${name}_ecp SOURCES ${ARG_ECP} LINKS mrroc::ecp_shell ${ARG_ROBOTS} ${ARG_SENSORS})
  endif()
endfunction()

# mrroc_add_task_test(NAME SOURCES ... [TIMEOUT s]): a GoogleTest program on <mrroc/testing.hpp>, which runs deployments with the
# project's bin/mrroc and injects faults into them. Needs enable_testing() and find_package(GTest).
function(mrroc_add_task_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${MRROC_WARNINGS})
  target_compile_definitions(${name} PRIVATE MRROC_COMMAND="${CMAKE_BINARY_DIR}/bin/mrroc"
    MRROC_TEST_FOLDER="${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE mrroc::testing GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
  if(ARG_TIMEOUT)
    set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  endif()
endfunction()
