# Every third-party library that the project uses, each as one imported target. `scripts/install_dependencies` installs them.
# Libraries of a single sensor type are in its folder.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(CycloneDDS 0.10 REQUIRED)
# src/links/cyclone replaces functions of this version by name (docs/explanation/cyclone.md)
set(MRROC_CYCLONE_VERSION 0.10.2)
option(MRROC_ANY_CYCLONE "Build with a version of Cyclone DDS that src/links/cyclone was not written for" OFF)
if(NOT CycloneDDS_VERSION VERSION_EQUAL MRROC_CYCLONE_VERSION AND NOT MRROC_ANY_CYCLONE)
  message(FATAL_ERROR "Cyclone DDS ${CycloneDDS_VERSION} found, expected ${MRROC_CYCLONE_VERSION}: src/links/cyclone replaces functions of that version. "
    "-DMRROC_ANY_CYCLONE=ON builds with this one; run links_test and system_security_test before you use it.")
endif()
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto SSL) # of `mrroc keys`; Cyclone's security plug-ins stand on it too
find_package(CLI11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(PNG REQUIRED)
if(MRROC_PANEL)
  # Debian's export names a program of a package that it does not depend on (civetweb)
  find_library(CIVETWEB civetweb REQUIRED)
  add_library(mrroc_civetweb INTERFACE)
  target_link_libraries(mrroc_civetweb INTERFACE ${CIVETWEB})
endif()
find_package(tinyxml2 REQUIRED)
find_package(assimp 5.2 REQUIRED)
find_package(orocos_kdl REQUIRED) # sets variables only
add_library(mrroc_kdl INTERFACE)
target_link_libraries(mrroc_kdl INTERFACE ${orocos_kdl_LIBRARIES} Eigen3::Eigen)

set(OpenGL_GL_PREFERENCE GLVND)
find_package(OpenGL REQUIRED COMPONENTS EGL)
find_package(mujoco 2.2.2 REQUIRED)
# Debian's export names a folder of a package that it does not depend on (libqhull-dev)
set_target_properties(mujoco::mujoco PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")

find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)

set(MRROC_RUCKIG ${CMAKE_SOURCE_DIR}/.deps/ruckig-0.19.4)
if(NOT EXISTS ${MRROC_RUCKIG}/CMakeLists.txt)
  message(FATAL_ERROR "Ruckig is missing: run scripts/install_dependencies")
endif()
set(BUILD_CLOUD_CLIENT OFF CACHE BOOL "" FORCE)
set(BUILD_EXAMPLES OFF CACHE BOOL "" FORCE)
set(BUILD_TESTS OFF CACHE BOOL "" FORCE)
set(BUILD_SHARED_LIBS OFF CACHE BOOL "" FORCE)
add_subdirectory(${MRROC_RUCKIG} ${CMAKE_BINARY_DIR}/ruckig EXCLUDE_FROM_ALL SYSTEM)

# the writer and reader of recordings: headers of Foxglove, compiled once
set(MRROC_MCAP ${CMAKE_SOURCE_DIR}/.deps/baglab_mcap_backend-1.1.0/third_party/mcap_repo)
if(NOT EXISTS ${MRROC_MCAP}/cpp/mcap/include/mcap/writer.hpp)
  message(FATAL_ERROR "MCAP is missing: run scripts/install_dependencies")
endif()
find_library(ZSTD zstd REQUIRED)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/mcap.cpp
  CONTENT "#define MCAP_IMPLEMENTATION\n#include <mcap/reader.hpp>\n#include <mcap/writer.hpp>\n")
add_library(mrroc_mcap STATIC ${CMAKE_BINARY_DIR}/mcap.cpp)
set_target_properties(mrroc_mcap PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_definitions(mrroc_mcap PUBLIC MCAP_COMPRESSION_NO_LZ4)
target_include_directories(mrroc_mcap SYSTEM PUBLIC $<BUILD_INTERFACE:${MRROC_MCAP}/cpp/mcap/include>)
target_link_libraries(mrroc_mcap PUBLIC $<BUILD_INTERFACE:${ZSTD}> $<INSTALL_INTERFACE:zstd>)

# reference for our own kinematics in tests and benchmarks
if(MRROC_TESTS OR MRROC_BENCH)
  find_package(urdfdom REQUIRED)
endif()
if(MRROC_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()
if(MRROC_BENCH)
  find_package(benchmark REQUIRED)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  # with these, and GCC's -fpch-preprocess, it caches sources that include a precompiled header; otherwise it caches
  # nothing
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)
endif()
