# Shared by the scripts of this folder that run a program on a simulated robot: master, simulated controller and command node. Source it
# after setup.sh, when the build is in use.

# start_robot [argument of bringup.launch...]: on free ports; it ends with the script at the latest. `log` is the file of its output.
start_robot() {
  export ROS_MASTER_URI="http://localhost:$(free_port)" ROS_HOSTNAME=localhost
  log=$(mktemp)
  say "Starting master, simulated TM5-900 and command node (log: $log)"
  roslaunch -p "${ROS_MASTER_URI##*:}" cobot_command bringup.launch sim:=true rviz:=false \
    script_port:="$(free_port)" status_port:="$(free_port)" "$@" >"$log" 2>&1 &
  launch=$!
  trap end_robot EXIT
}

# start_cell <file of the cell> <artifact> [argument of cell.launch...]: starts its robots, supervisor and monitor in the same way.
start_cell() {
  local cell=$1 artifact=$2
  shift 2
  export ROS_MASTER_URI="http://localhost:$(free_port)" ROS_HOSTNAME=localhost
  log=$(mktemp)
  say "Starting master, simulated controllers, command nodes, supervisor and monitor (log: $log)"
  roslaunch -p "${ROS_MASTER_URI##*:}" cobot_command cell.launch cell_file:="$cell" artifact:="$artifact" "$@" >"$log" 2>&1 &
  launch=$!
  trap end_robot EXIT
}

# Ends the launch and waits for it, so that a recording is closed.
end_robot() {
  kill -INT "$launch" 2>/dev/null || true
  wait "$launch" 2>/dev/null || true
}

# wait_for_robot <command>...: until the command succeeds. Fails as soon as the launch has failed.
wait_for_robot() {
  local tries
  for tries in {1..120}; do
    kill -0 "$launch" 2>/dev/null || return 1
    "$@" && return
    sleep 0.5
  done
  return 1
}

nodes_are_up() {
  rosnode list 2>/dev/null | grep -q command_node
}

cell_is_up() {
  rosnode list 2>/dev/null | grep -q cell_supervisor
}

show_log() {
  echo "The last lines of the log:"
  tail -n 40 "$log"
}
