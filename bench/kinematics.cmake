# Every folder of robots/ takes part by itself: robots/NAME/NAME_model.hpp declares load_NAME().
function(mrroc_bench_kinematics)
  set(robots_folder ${PROJECT_SOURCE_DIR}/robots)
  file(GLOB parts RELATIVE ${robots_folder} CONFIGURE_DEPENDS ${robots_folder}/*/CMakeLists.txt)
  list(SORT parts)
  foreach(part ${parts})
    cmake_path(GET part PARENT_PATH name)
    string(APPEND includes "#include \"robots/${name}/${name}_model.hpp\"\n")
    string(APPEND loads "      load_${name}(),\n")
    list(APPEND libraries mrroc_robot_${name})
  endforeach()
  set(robots ${CMAKE_CURRENT_BINARY_DIR}/kinematics_robots.cpp)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/kinematics/robots.cpp.in ${robots} @ONLY)
  mrroc_bench(kinematics
    SOURCES kinematics/main.cpp kinematics/contest.cpp kinematics/kdl_kinematics.cpp kinematics/postures.cpp
            kinematics/urdf_chain.cpp ${robots}
    LINKS ${libraries} mrroc_kdl urdfdom::urdfdom_model)
endfunction()
mrroc_bench_kinematics()
