# mrroc_robot_loader(NAME TEMPLATE LINE): a source from the file TEMPLATE, in NAME_SOURCE, and its libraries, in
# NAME_LIBRARIES. @includes@ are the headers of every type of robots/ with a class of its own: it has a parameter file
# TYPE.toml, and TYPE_model.hpp declares load_TYPE(). @loads@ is LINE for each of them, TYPE being its name.
function(mrroc_robot_loader variable template line)
  set(robots_folder ${PROJECT_SOURCE_DIR}/robots)
  file(GLOB parts RELATIVE ${robots_folder} CONFIGURE_DEPENDS ${robots_folder}/*/CMakeLists.txt)
  list(SORT parts)
  foreach(part ${parts})
    cmake_path(GET part PARENT_PATH name)
    if(NOT EXISTS ${robots_folder}/${name}/${name}.toml)
      continue()
    endif()
    string(APPEND includes "#include \"robots/${name}/${name}_model.hpp\"\n")
    string(REPLACE TYPE ${name} load "${line}")
    string(APPEND loads "${load}\n")
    list(APPEND libraries mrroc_robot_${name})
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${variable}.cpp)
  configure_file(${template} ${source} @ONLY)
  set(${variable}_SOURCE ${source} PARENT_SCOPE)
  set(${variable}_LIBRARIES ${libraries} PARENT_SCOPE)
endfunction()

# mrroc_kinematics_loader(NAME): one with load_robots() (bench/kinematics/robots.hpp).
function(mrroc_kinematics_loader variable)
  mrroc_robot_loader(${variable} ${PROJECT_SOURCE_DIR}/bench/kinematics/robots.cpp.in "      load_TYPE(),")
  set(${variable}_SOURCE ${${variable}_SOURCE} PARENT_SCOPE)
  set(${variable}_LIBRARIES ${${variable}_LIBRARIES} PARENT_SCOPE)
endfunction()
