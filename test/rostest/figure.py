"""What a test measures on the side: a line that scripts/figures makes a table of. Printed and not asserted, as on a loaded machine a
wall clock proves nothing; the same as test/support/figure.h."""


def print_figure(goal, what, values, unit, limit):
    """`limit`: of the goal, for 99 % of the values."""
    values = sorted(values)
    median, late = (values[(len(values) * percent + 99) // 100 - 1] for percent in (50, 99))
    print(f"figure: | {goal} | {what} | {len(values)} | {median:.4g} | {late:.4g} | {values[-1]:.4g} | {unit} | 99 % {limit:g} | "
          f"{'holds' if late <= limit else 'OVER'} |", flush=True)
