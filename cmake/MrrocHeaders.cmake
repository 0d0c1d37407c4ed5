# The headers of a package, as they are included: "mrroc/move.hpp", "config/table.hpp", "robots/irb6/irb6_model.hpp".
# Folders named include/ are public as a whole; of the framework's own folders these headers are.
set(MRROC_PUBLIC_HEADERS
  edp/driver.hpp
  edp/hardware.hpp
  edp/shell.hpp
  src/clock/wall/package_clock.hpp
  src/config/resources.hpp
  src/config/robot_files.hpp
  src/config/robot_parameters_file.hpp
  src/config/table.hpp
  src/process/picture_memory.hpp
  vsp/driver.hpp
  vsp/noise.hpp
  vsp/parameters.hpp
  vsp/reading_error.hpp
  vsp/shell.hpp
  vsp/source.hpp
  vsp/virtual_sensor.hpp
  vsp/wrench_source.hpp
)

# Headers that the public ones include: not for users, they may move. `headers` of ctest compares this list with the
# sources.
set(MRROC_INCLUDED_HEADERS
  edp/robot_clock.hpp
  edp/safety/fault.hpp
  src/clock/clock.hpp
  src/clock/emergency_stop.hpp
  src/clock/group_stops.hpp
  src/clock/gate.hpp
  src/clock/wall/monotonic.hpp
  src/config/deployment.hpp
  src/config/entries/errors_entry.hpp
  src/config/entries/program_behaviours.hpp
  src/config/key_values.hpp
  src/core/lockfree/sequence_lock.hpp
  src/core/lockfree/shared_slot.hpp
  src/core/shared_memory.hpp
  src/core/shared_ring.hpp
  src/faults/fault.hpp
  src/faults/fault_plan.hpp
  src/links/exchange/operator_requester.hpp
  src/links/trajectory/trajectory_receiver.hpp
  src/links/exchange/requester.hpp
  src/links/exchange/responder.hpp
  src/links/exchange/robot_requester.hpp
  src/links/exchange/robot_responder.hpp
  src/links/exchange/sensor_requester.hpp
  src/links/exchange/task_subordinate.hpp
  src/links/exchange/task_superior.hpp
  src/links/telemetry/status_publisher.hpp
  src/links/transport/domain.hpp
  src/links/transport/endpoint.hpp
  src/links/transport/header.hpp
  src/links/transport/network_interface.hpp
  src/links/transport/reader.hpp
  src/links/transport/writer.hpp
  src/links/wire/operator_messages.hpp
  src/links/wire/process_status.hpp
  src/links/wire/task_messages.hpp
  src/plugin/plugin.hpp
  src/process/arguments.hpp
  src/process/dialogue.hpp
  src/process/exit_code.hpp
  src/process/faulty_robot_link.hpp
  src/process/mailbox.hpp
  src/process/process.hpp
  src/process/record/encoded_step.hpp
  src/process/record/shared_black_box.hpp
  src/process/record/step_reporter.hpp
  src/process/record/step_ring.hpp
  src/process/status_board.hpp
  src/recording/recorded_step.hpp
  src/process/fibers.hpp
  src/process/task_process.hpp
  src/process/task_trajectories.hpp
  src/world/world_memory.hpp
  vsp/raw_reading.hpp
)

file(GLOB type_headers robots/*/include sensors/*/include)
list(TRANSFORM type_headers APPEND /)
install(DIRECTORY include/ mp/include/ ecp/include/ testing/include/ ${type_headers} DESTINATION include/mrroc COMPONENT development
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY robots DESTINATION include/mrroc COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN include EXCLUDE PATTERN description EXCLUDE)
foreach(header ${MRROC_PUBLIC_HEADERS} ${MRROC_INCLUDED_HEADERS})
  cmake_path(GET header PARENT_PATH folder)
  string(REGEX REPLACE "^src/" "" folder ${folder})
  install(FILES ${header} DESTINATION include/mrroc/${folder} COMPONENT development)
endforeach()
