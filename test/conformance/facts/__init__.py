"""The facts, a file for each section of doc/tm-robot.md."""
