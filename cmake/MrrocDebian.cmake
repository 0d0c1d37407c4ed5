# `make package`: build/mrroc_*.deb, build/libmrroc-dev_*.deb. Component runtime becomes mrroc, development becomes libmrroc-dev.
set(debian ${CMAKE_SOURCE_DIR}/cmake/debian)
set(made ${CMAKE_BINARY_DIR}/debian)

# a package contains the date of its source, not of its build
execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} log -1 --format=%cD RESULT_VARIABLE no_git OUTPUT_VARIABLE date ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(no_git OR date STREQUAL "")
  set(date "Thu, 01 Jan 1970 00:00:00 +0000")
endif()
set(CPACK_PACKAGE_CONTACT "MRROC++ maintainers <maintainers@mrroc.invalid>")
file(READ ${MRROC_RUCKIG}/LICENSE ruckig_licence)
string(STRIP "${ruckig_licence}" ruckig_licence)
string(REGEX REPLACE "\n\n" "\n.\n" ruckig_licence "${ruckig_licence}")
string(REGEX REPLACE "\n" "\n " ruckig_licence "${ruckig_licence}")
file(READ ${MRROC_MCAP}/LICENSE mcap_licence)
string(STRIP "${mcap_licence}" mcap_licence)
string(REGEX REPLACE "\n\n" "\n.\n" mcap_licence "${mcap_licence}")
string(REGEX REPLACE "\n" "\n " mcap_licence "${mcap_licence}")
configure_file(${debian}/copyright.in ${made}/copyright @ONLY)
configure_file(${debian}/changelog.in ${made}/changelog @ONLY)
execute_process(COMMAND gzip -9nkf ${made}/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(package mrroc libmrroc-dev)
  install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION share/doc/${package} COMPONENT ${package}_documents EXCLUDE_FROM_ALL)
endforeach()
install(FILES ${debian}/limits.conf DESTINATION /etc/security/limits.d RENAME mrroc.conf COMPONENT mrroc_limits EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mrroc)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime mrroc_documents mrroc_limits development libmrroc-dev_documents)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_MRROC_PACKAGE_NAME mrroc)
set(CPACK_DEBIAN_MRROC_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MRROC_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_MRROC_PACKAGE_DEPENDS "adduser, libgl1-mesa-dri")  # Mesa draws pictures without a screen
set(CPACK_DEBIAN_MRROC_PACKAGE_SUGGESTS "can-utils, openssh-client, graphviz")
set(CPACK_DEBIAN_MRROC_PACKAGE_CONTROL_EXTRA ${debian}/conffiles ${debian}/postinst ${debian}/postrm)
set(CPACK_DEBIAN_MRROC_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_LIBMRROC-DEV_PACKAGE_NAME libmrroc-dev)
set(CPACK_DEBIAN_LIBMRROC-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBMRROC-DEV_PACKAGE_DEPENDS
  "mrroc (= ${PROJECT_VERSION}), cmake, g++, cyclonedds-dev, libcli11-dev, libeigen3-dev, libssl-dev, libtinyxml2-dev, libzstd-dev")

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Programming several robots and their sensors as one system")
set(CPACK_DEBIAN_MRROC_DESCRIPTION "Tasks written in C++ command robots and read sensors by two instructions, Move
and Wait, and run as processes over Cyclone DDS: on real drives, or in MuJoCo.

This package has the command mrroc, the processes of its robots and sensors, and
tasks with their scenes.")
set(CPACK_DEBIAN_LIBMRROC-DEV_DESCRIPTION "Headers, static libraries and the CMake package mrroc, with which tasks,
robots and sensors are built in a project of their own.")

include(CPack)
cpack_add_component_group(mrroc)
cpack_add_component_group(libmrroc-dev)
cpack_add_component(runtime GROUP mrroc)
cpack_add_component(mrroc_documents GROUP mrroc)
cpack_add_component(mrroc_limits GROUP mrroc)
cpack_add_component(development GROUP libmrroc-dev)
cpack_add_component(libmrroc-dev_documents GROUP libmrroc-dev)
