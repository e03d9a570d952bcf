"""The facts, a file for each section of the fact sheet."""
