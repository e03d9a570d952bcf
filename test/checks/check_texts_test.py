#!/usr/bin/env python3
"""check_texts.py finds what it is for."""
import unittest

import check_texts


def found(text, folder="src/ros"):
    return [statement for _, statement in check_texts.findings(text, check_texts.PLACES[folder])]


class Texts(unittest.TestCase):
    def test_what_is_logged_as_it_came_is_found(self):
        self.assertEqual(len(found('ROS_WARN_STREAM(message.text);\nROS_ERROR_STREAM_THROTTLE(10, "a " << name);')), 2)
        self.assertEqual(len(found('std::cerr << "tm_arm: " << error.what() << "\\n";', "src/tools")), 1)
        self.assertEqual(len(found('fmt::print(stderr, "{}\\n",\n  error.what());', "src/tools")), 1)

    def test_what_fills_a_text_of_a_message_is_found(self):
        self.assertEqual(found("response.message = answer.message;"), ["response.message = answer.message"])
        self.assertEqual(len(found("goal.setRejected(result, *objection);\nstatus.summary(Level::OK, text);")), 2)

    def test_what_goes_through_the_function_is_none(self):
        self.assertEqual(found('ROS_WARN_STREAM(forPeople(message.text));\nresponse.message = quoted(name);'), [])

    def test_our_own_words_are_none(self):
        self.assertEqual(found('ROS_WARN("not connected; (retry");\nresponse.message = kCoreBusy;\n// message = text;'), [])
        self.assertEqual(found("const bool is_so = answer.message == other.message;"), [])


if __name__ == "__main__":
    unittest.main()
