# find_package(mrroc), for a build folder and for an installation: the libraries mrroc::<name>, the functions of
# MrrocTargets.cmake, and the user's own bin/mrroc.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(Eigen3 3.4)
find_dependency(CycloneDDS 0.10)
find_dependency(CLI11)
find_dependency(tinyxml2)
include(${CMAKE_CURRENT_LIST_DIR}/mrrocLibraries.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/MrrocTargets.cmake)

# the same commands in the project's bin/: they find its robots, sensors and programs, then those of the
# framework, then the user's own types
get_filename_component(mrroc_PREFIX ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
foreach(command mrroc mrroc_render)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/bin/${command} @ONLY CONTENT [[#!/bin/sh
export MRROC_PROGRAMS="@CMAKE_BINARY_DIR@/bin:@mrroc_PREFIX@/libexec/mrroc:@mrroc_PREFIX@/bin"
export MRROC_PLUGINS="@CMAKE_BINARY_DIR@/lib/mrroc:@mrroc_PREFIX@/lib/mrroc:${XDG_DATA_HOME:-$HOME/.local/share}/../lib/mrroc"
export MRROC_SHARE="@CMAKE_BINARY_DIR@/share/mrroc:@mrroc_PREFIX@/share/mrroc:${XDG_DATA_HOME:-$HOME/.local/share}/mrroc"
exec "@mrroc_PREFIX@/bin/@command@" "$@"
]])
  file(CHMOD ${CMAKE_BINARY_DIR}/bin/${command} FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
