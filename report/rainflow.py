"""Cycles of tension that tire a tether: rainflow counting after ASTM E1049-85, section 5.4.4."""


def turning_points(series):
    points = []
    for x in series:
        if len(points) >= 2 and (points[-1] - points[-2]) * (x - points[-1]) >= 0.0:
            points[-1] = x
        elif not points or x != points[-1]:
            points.append(x)
    return points


def cycles(series):
    """Pairs of range and count, 1 or 0.5, in the order in which they close."""
    found, stack = [], []
    for x in turning_points(series):
        stack.append(x)
        while len(stack) >= 3:
            newest, before = abs(stack[-1] - stack[-2]), abs(stack[-2] - stack[-3])
            if newest < before:
                break
            if len(stack) == 3:
                found.append((before, 0.5))
                stack.pop(0)
            else:
                found.append((before, 1.0))
                del stack[-3:-1]
    found += [(abs(b - a), 0.5) for a, b in zip(stack, stack[1:])]
    return found
