"""Which moment of one list is which of another, where each list may lack some of the other's."""

LEFT, RIGHT, BOTH = range(3)


def pairs(left, right, near):
    """(index, index) of as many as can be paired in their order and at most `near` apart; of those with the least between them. Both are sorted."""
    found = []
    for (i, i_end), (j, j_end) in clusters(left, right, near):
        found += [(i + a, j + b) for a, b in paired(left[i:i_end], right[j:j_end], near)]
    return found


def clusters(left, right, near):
    """Stretches of both, as ranges, with more than `near` around each: nothing of one belongs to something of another."""
    marked = sorted([(time, 0) for time in left] + [(time, 1) for time in right])
    begins, ends = [0, 0], [0, 0]
    for index, (time, side) in enumerate(marked):
        if index and time - marked[index - 1][0] > near:
            yield (begins[0], ends[0]), (begins[1], ends[1])
            begins = list(ends)
        ends[side] += 1
    yield (begins[0], ends[0]), (begins[1], ends[1])


def paired(left, right, near):
    """Of one stretch: the best of its beginnings, each made of the best of a shorter one."""
    if len(left) == len(right) and all(abs(a - b) <= near for a, b in zip(left, right)):
        return [(i, i) for i in range(len(left))]  # there is one way only to pair all
    row = [(0, 0.0)] * (len(right) + 1)  # (pairs, less the time between them) of so many of the left and the first of the right
    choices = []
    for a in left:
        before, row, chosen = row, [row[0]], bytearray([LEFT])
        for j, b in enumerate(right):
            count, cost = before[j]
            apart = abs(a - b)
            best = max((before[j + 1], LEFT), (row[j], RIGHT), ((count + 1, cost - apart) if apart <= near else (-1, 0.0), BOTH))
            row.append(best[0])
            chosen.append(best[1])
        choices.append(chosen)
    return list(walked_back(choices, len(right)))[::-1]


def walked_back(choices, j):
    i = len(choices)
    while i > 0 and j > 0:
        choice = choices[i - 1][j]
        if choice == BOTH:
            yield i - 1, j - 1
        i -= choice != RIGHT
        j -= choice != LEFT
