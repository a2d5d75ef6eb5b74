#!/usr/bin/env python3
"""A controller that is not obeyed is told, once each time that another is."""

import unittest

import package_of_tree  # noqa: F401
import twinbus

ME, OTHER, ACTIVE, STANDBY, STOPPED = 5, 9, 2, 4, 6


def heard(role, controller_id):
    status = twinbus.source_status_t()
    status.role, status.controller_id = role, controller_id
    return "SOURCE_STATUS", status.encode()


class Obedience(unittest.TestCase):
    def setUp(self):
        self.obedience = twinbus.Obedience(ME)

    def test_who_is_obeyed_hears_nothing(self):
        for messages in ([heard(ACTIVE, 0)], [heard(ACTIVE, ME)], [heard(STOPPED, ME)], [], [("STATE", b"x")], [("SOURCE_STATUS", b"damaged")]):
            self.assertIsNone(self.obedience.problem(messages))

    def test_a_source_that_stands_by_says_nothing_of_the_robot(self):
        self.assertIsNone(self.obedience.problem([heard(STANDBY, OTHER)]))

    def test_another_controller_is_told_once_with_the_remedy(self):
        said = self.obedience.problem([heard(ACTIVE, OTHER), heard(ACTIVE, OTHER)])
        self.assertIn("NOT OBEYED, another controller (id 9)", said)
        self.assertIn("./twinbus clear", said)
        self.assertIsNone(self.obedience.problem([heard(STOPPED, OTHER)]))
        self.assertIsNone(self.obedience.problem([heard(ACTIVE, ME)]))
        self.assertIsNotNone(self.obedience.problem([heard(ACTIVE, OTHER)]))


if __name__ == "__main__":
    unittest.main()
