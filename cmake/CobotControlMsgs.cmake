# For the tests: the messages of the action follow_joint_trajectory, and a command node that serves it, also where there is
# no package control_msgs. Then both are made beside what is installed: cobot_control_msgs (headers),
# COBOT_CONTROL_MSGS_PYTHON (a folder, or nothing), COBOT_TRAJECTORY_NODE (the name of the program).
add_library(cobot_control_msgs INTERFACE)
target_compile_definitions(cobot_control_msgs INTERFACE COBOT_HAS_CONTROL_MSGS)
if(control_msgs_FOUND)
  target_include_directories(cobot_control_msgs SYSTEM INTERFACE ${control_msgs_INCLUDE_DIRS})
  add_dependencies(cobot_control_msgs ${control_msgs_EXPORTED_TARGETS})
  set(COBOT_CONTROL_MSGS_PYTHON "")
  set(COBOT_TRAJECTORY_NODE command_node)
  return()
endif()

set(sources ${PROJECT_SOURCE_DIR}/test/control_msgs)
set(folder ${PROJECT_BINARY_DIR}/control_msgs)
set(header ${folder}/devel/include/control_msgs/FollowJointTrajectoryAction.h)
add_custom_command(
  OUTPUT ${header}
  COMMAND ${CMAKE_COMMAND} -S ${sources} -B ${folder} -G${CMAKE_GENERATOR} -DCMAKE_MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}
          -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DPYTHON_EXECUTABLE=${PYTHON_EXECUTABLE} -DCATKIN_ENABLE_TESTING=OFF
  COMMAND ${CMAKE_COMMAND} --build ${folder}
  DEPENDS ${sources}/CMakeLists.txt ${sources}/package.xml ${sources}/msg/JointTolerance.msg
          ${sources}/action/FollowJointTrajectory.action
  COMMENT "Making control_msgs for the tests"
  VERBATIM)
add_custom_target(cobot_control_msgs_made DEPENDS ${header})
add_dependencies(cobot_control_msgs cobot_control_msgs_made)
target_include_directories(cobot_control_msgs SYSTEM INTERFACE ${folder}/devel/include)
set(COBOT_CONTROL_MSGS_PYTHON ${folder}/devel/lib/python3/dist-packages)

# Its own serve() of that one block stands in front of the library's, which serves nobody.
set(COBOT_TRAJECTORY_NODE command_node_with_control_msgs)
set(sources ${PROJECT_SOURCE_DIR}/src)
add_executable(${COBOT_TRAJECTORY_NODE} ${sources}/nodes/command_node.cpp ${sources}/nodes/node_arguments.cpp
                                        ${sources}/nodes/node_names.cpp ${sources}/nodes/unblocked_output.cpp
                                        ${sources}/ros/actions/follow_joint_trajectory.cpp)
target_include_directories(${COBOT_TRAJECTORY_NODE} PRIVATE ${sources}/ros)
target_link_libraries(${COBOT_TRAJECTORY_NODE} PRIVATE cobot_command::ros_command fmt::fmt cobot_warnings cobot_control_msgs)
