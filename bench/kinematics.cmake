mrroc_kinematics_loader(kinematics_robots)
mrroc_bench(kinematics
  SOURCES kinematics/main.cpp kinematics/chain_twin.cpp kinematics/contest.cpp kinematics/kdl_kinematics.cpp kinematics/postures.cpp
          kinematics/urdf_chain.cpp ${kinematics_robots_SOURCE}
  LINKS ${kinematics_robots_LIBRARIES} mrroc_arm_tools mrroc_kdl urdfdom::urdfdom_model)
