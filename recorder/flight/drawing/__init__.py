"""The pictures of a report: each function draws one part into axes that it is given."""
