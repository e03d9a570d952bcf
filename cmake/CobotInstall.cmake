# Everything that a user of an install space needs. In a catkin workspace the folders are catkin's.
# Another project finds the rooms as targets (doc/architecture.md): with catkin in the install space and in the devel space,
# in the file that catkin itself writes; without it in the install space.

if(COBOT_CORE_ONLY)
  include(GNUInstallDirs)
  set(libraries ${CMAKE_INSTALL_LIBDIR})
  set(programs ${CMAKE_INSTALL_BINDIR})
  set(headers ${CMAKE_INSTALL_INCLUDEDIR}/cobot_command)
  set(share ${CMAKE_INSTALL_DATADIR}/cobot_command)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/cobot_command)
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(cobot_commandConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cobot_commandConfigVersion.cmake DESTINATION ${package})
  install(FILES cmake/cobot_command-rooms.cmake DESTINATION ${package} RENAME cobot_commandConfig.cmake)
else()
  set(libraries ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(programs ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(headers ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
  set(share ${CATKIN_PACKAGE_SHARE_DESTINATION})
  set(package ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
  catkin_install_python(PROGRAMS examples/exchange_configuration.py examples/interrupt.py examples/jog.py examples/load_path.py examples/pick_and_place.py examples/run_cell.py examples/simulated_mechanism.py examples/tour.py launch/cell_movers.py recorder/flight_record.py recorder/flight_replay.py recorder/flight_report.py rviz/fleet_rviz.py DESTINATION ${programs})
  # The programs look for their modules beside themselves.
  install(DIRECTORY recorder/flight DESTINATION ${programs} FILES_MATCHING PATTERN *.py)
  install(DIRECTORY config launch rviz DESTINATION ${share})
endif()

get_property(exported_libraries GLOBAL PROPERTY COBOT_EXPORTED_LIBRARIES)
get_property(libraries_of_nodes GLOBAL PROPERTY COBOT_LIBRARIES_OF_NODES)
get_property(installed_programs GLOBAL PROPERTY COBOT_INSTALLED_PROGRAMS)
# They find the libraries wherever the prefix is.
file(RELATIVE_PATH from_programs_to_libraries /${programs} /${libraries})
set_target_properties(${installed_programs} PROPERTIES INSTALL_RPATH $ORIGIN/${from_programs_to_libraries})
install(
  TARGETS ${exported_libraries}
  EXPORT cobot_commandTargets
  ARCHIVE DESTINATION ${libraries}
  LIBRARY DESTINATION ${libraries})
if(NOT COBOT_CORE_ONLY)
  export(EXPORT cobot_commandTargets NAMESPACE cobot_command::
         FILE ${CATKIN_DEVEL_PREFIX}/share/cobot_command/cmake/cobot_commandTargets.cmake)
endif()
install(EXPORT cobot_commandTargets NAMESPACE cobot_command:: DESTINATION ${package})
install(
  TARGETS ${libraries_of_nodes} ${installed_programs}
  ARCHIVE DESTINATION ${libraries}
  LIBRARY DESTINATION ${libraries}
  RUNTIME DESTINATION ${programs})
# Those of the nodes are of no use without their libraries, which are not exported.
install(DIRECTORY include/cobot_command/ DESTINATION ${headers} PATTERN ros EXCLUDE)
install(DIRECTORY urdf DESTINATION ${share})
