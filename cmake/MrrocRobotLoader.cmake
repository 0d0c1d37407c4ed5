# mrroc_robot_loader(NAME): a source with load_robots() (bench/kinematics/robots.hpp), in NAME_SOURCE, and its
# libraries, in NAME_LIBRARIES. Every folder of robots/ is included automatically: robots/NAME/NAME_model.hpp declares
# load_NAME().
function(mrroc_robot_loader variable)
  set(robots_folder ${PROJECT_SOURCE_DIR}/robots)
  file(GLOB parts RELATIVE ${robots_folder} CONFIGURE_DEPENDS ${robots_folder}/*/CMakeLists.txt)
  list(SORT parts)
  foreach(part ${parts})
    cmake_path(GET part PARENT_PATH name)
    string(APPEND includes "#include \"robots/${name}/${name}_model.hpp\"\n")
    string(APPEND loads "      load_${name}(),\n")
    list(APPEND libraries mrroc_robot_${name})
  endforeach()
  set(robots ${CMAKE_CURRENT_BINARY_DIR}/${variable}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/bench/kinematics/robots.cpp.in ${robots} @ONLY)
  set(${variable}_SOURCE ${robots} PARENT_SCOPE)
  set(${variable}_LIBRARIES ${libraries} PARENT_SCOPE)
endfunction()
