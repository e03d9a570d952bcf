#!/usr/bin/env python3
"""Enables the interface with the action `exchange_configuration`, with the steps of the page of SRCI's function block. Prints what the
interface offers, keeps it enabled for some seconds, and disables it. The robot does not move.
Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Exit status: 0 if the interface was enabled and disabled, 1 with the reason if not.
"""
import argparse
import signal
import sys

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, ExchangeConfigurationAction,
                               ExchangeConfigurationGoal, ExchangeOutCmd, ExchangeParCmd)

PERIOD = 0.05  # [s] of one call of the block
PATIENCE = 5.0  # [s] in steps 1 and 2
LINK_TIMEOUT = 30.0  # [s]
INVALID_STEP = 1
TIMEOUT_CMD = 6


class Failed(Exception):
    """The reason why the example failed."""


class ExchangeConfiguration:
    """The block of the page. Call it in every cycle with the wanted state: it goes through its steps."""

    def __init__(self, client, par_cmd):
        self._client = client
        self._goal = ExchangeConfigurationGoal(exec_mode=ExchangeConfigurationGoal.PARALLEL, par_cmd=par_cmd)
        self._handle = None
        self._feedback = None
        self._step = 0
        self._since = rospy.Time()
        self.enabled = False
        self.out_cmd = ExchangeOutCmd()
        self.error_id = 0
        self.error_add_txt = ""

    def call(self, enable):
        self._take_end()
        if self._step not in (0, 1, 2):
            self._fail(INVALID_STEP, f"_stepCmd = {self._step}")
        elif self._step and (rospy.Time.now() - self._since).to_sec() > PATIENCE:
            self._fail(TIMEOUT_CMD, f"_stepCmd = {self._step}")
        elif self._step == 0 and enable != self.enabled and not self.error_id:
            self._go_to(1)
        elif self._step == 1 and not self._is_busy():
            self._request(enable)
            self._go_to(2)
        elif self._step == 2 and not self._is_busy() and self._is_enabled() == enable:
            self.enabled = enable
            self._go_to(0)
        if self._is_enabled():
            self.out_cmd = self._feedback.out_cmd

    def _request(self, enable):
        if enable:
            self._feedback = None
            self._handle = self._client.send_goal(self._goal, feedback_cb=lambda _, feedback: self._take(feedback))
        else:
            self._handle.cancel()

    def _take(self, feedback):
        self._feedback = feedback

    def _is_busy(self):
        if not self._handle:
            return False
        return self._feedback.busy if self._feedback else True

    def _is_enabled(self):
        return bool(self._handle and self._feedback and self._feedback.enabled)

    def _take_end(self):
        if not self._handle or self._handle.get_comm_state() != CommState.DONE:
            return
        result, state = self._handle.get_result(), self._handle.get_terminal_state()
        self._handle = self._feedback = None
        if state != GoalStatus.SUCCEEDED:
            self._fail(result.error_id, result.error_add_txt or result.error_description)

    def _fail(self, error_id, text):
        self.error_id, self.error_add_txt, self.enabled = error_id, text, False
        self._go_to(0)

    def _go_to(self, step):
        self._step, self._since = step, rospy.Time.now()


def client(name, action):
    found = actionlib.ActionClient(name, action)
    if not found.wait_for_server(rospy.Duration(LINK_TIMEOUT)):
        raise Failed(f"no action server {name}: is the command node running?")
    return found


def link():
    """Opens a link and returns its connect goal; None: a link exists already."""
    status = rospy.wait_for_message("command_status", CommandStatus, LINK_TIMEOUT)
    if status.link_state == CommandStatus.READY:
        return None
    handle = client("connect", ConnectAction).send_goal(ConnectGoal(timeout=LINK_TIMEOUT))
    deadline = rospy.Time.now() + rospy.Duration(LINK_TIMEOUT)
    while rospy.wait_for_message("command_status", CommandStatus, LINK_TIMEOUT).link_state != CommandStatus.READY:
        if handle.get_comm_state() == CommState.DONE or rospy.Time.now() > deadline:
            raise Failed("no link: " + (handle.get_result().error_description if handle.get_result() else "no answer"))
        rospy.sleep(PERIOD)
    return handle


def call_until(block, enable):
    while block.enabled != enable:
        block.call(enable)
        if block.error_id:
            raise Failed(f"error {block.error_id}: {block.error_add_txt}")
        rospy.sleep(PERIOD)


def close(own_link):
    own_link.cancel()
    deadline = rospy.Time.now() + rospy.Duration(PATIENCE)
    while own_link.get_comm_state() != CommState.DONE and rospy.Time.now() < deadline:
        rospy.sleep(PERIOD)


def run(options):
    own_link = link()
    try:
        enable_for_a_while(options)
    finally:
        if own_link:
            close(own_link)


def enable_for_a_while(options):
    settings = ExchangeParCmd(log_level=ExchangeParCmd.LOG_INFO, life_sign_time_out=options.life_sign_time_out)
    block = ExchangeConfiguration(client("exchange_configuration", ExchangeConfigurationAction), settings)
    call_until(block, True)
    out = block.out_cmd
    print(f"Enabled: {out.length_acr} commands can be held; tools up to {out.highest_tool_index}, frames up to "
          f"{out.highest_frame_index}, loads up to {out.highest_load_index}", flush=True)
    end = rospy.Time.now() + rospy.Duration(options.seconds)
    while rospy.Time.now() < end:
        block.call(True)
        if block.error_id:
            raise Failed(f"error {block.error_id}: {block.error_add_txt}")
        rospy.sleep(PERIOD)
    call_until(block, False)
    print("Disabled")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=2.0, help="time for which it stays enabled (default: %(default)s)")
    parser.add_argument("--life-sign-time-out", type=int, default=300, help="[ms], 10 to 65535 (default: %(default)s)")
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("exchange_configuration_example", anonymous=True)
    signal.signal(signal.SIGTERM, lambda *_: rospy.signal_shutdown("end requested"))
    try:
        run(options)
    except (Failed, rospy.ROSException) as why:
        print(f"Failed: {why}", flush=True)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
