# Everything that a user of an install space needs. In a catkin workspace the folders are catkin's.

if(COBOT_CORE_ONLY)
  include(GNUInstallDirs)
  set(libraries ${CMAKE_INSTALL_LIBDIR})
  set(programs ${CMAKE_INSTALL_BINDIR})
  set(headers ${CMAKE_INSTALL_INCLUDEDIR}/cobot_command)
  set(share ${CMAKE_INSTALL_DATADIR}/cobot_command)
else()
  set(libraries ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(programs ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(headers ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
  set(share ${CATKIN_PACKAGE_SHARE_DESTINATION})
  catkin_install_python(PROGRAMS examples/pick_and_place.py examples/tour.py rviz/fleet_rviz.py DESTINATION ${programs})
  install(DIRECTORY config launch rviz DESTINATION ${share})
endif()

get_property(installed_libraries GLOBAL PROPERTY COBOT_INSTALLED_LIBRARIES)
get_property(installed_programs GLOBAL PROPERTY COBOT_INSTALLED_PROGRAMS)
# All that is installed, and no test.
add_custom_target(rooms_and_programs DEPENDS ${installed_libraries} ${installed_programs})
install(
  TARGETS ${installed_libraries} ${installed_programs}
  ARCHIVE DESTINATION ${libraries}
  LIBRARY DESTINATION ${libraries}
  RUNTIME DESTINATION ${programs})
install(DIRECTORY include/cobot_command/ DESTINATION ${headers})
install(DIRECTORY urdf DESTINATION ${share})
