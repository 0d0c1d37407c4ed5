# The package for find_package(mrroc): in the build folder directly, and in an installation (`cmake --install build
# --prefix ...`). Both have the same layout: bin/, lib/cmake/mrroc/, lib/mrroc/ (archives), include/mrroc/,
# share/mrroc/; an installation also has libexec/mrroc/.
include(CMakePackageConfigHelpers)

# linked into our own libraries and installed privately: the system may have others
install(TARGETS ruckig mrroc_mcap EXPORT mrroc ARCHIVE DESTINATION lib/mrroc COMPONENT development)

set(package ${CMAKE_BINARY_DIR}/lib/cmake/mrroc)
configure_file(cmake/mrrocConfig.cmake ${package}/mrrocConfig.cmake COPYONLY)
configure_file(cmake/MrrocTargets.cmake ${package}/MrrocTargets.cmake COPYONLY)
configure_file(cmake/MrrocSensorClass.cmake ${package}/MrrocSensorClass.cmake COPYONLY)
write_basic_package_version_file(${package}/mrrocConfigVersion.cmake COMPATIBILITY SameMajorVersion)
export(EXPORT mrroc NAMESPACE mrroc:: FILE ${package}/mrrocLibraries.cmake)

install(EXPORT mrroc NAMESPACE mrroc:: FILE mrrocLibraries.cmake DESTINATION lib/cmake/mrroc COMPONENT development)
install(FILES ${package}/mrrocConfig.cmake ${package}/MrrocTargets.cmake ${package}/MrrocSensorClass.cmake
  ${package}/mrrocConfigVersion.cmake DESTINATION lib/cmake/mrroc COMPONENT development)

include(MrrocHeaders)

install(DIRECTORY tasks DESTINATION share/mrroc COMPONENT runtime
  PATTERN "*.[ch]pp" EXCLUDE PATTERN CMakeLists.txt EXCLUDE PATTERN "*.py" EXCLUDE PATTERN "*.gp" EXCLUDE PATTERN demo EXCLUDE)
