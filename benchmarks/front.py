# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import math


def pareto(points):
    front = []
    for seconds, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((seconds, error))
    return front


def seconds_for(points, error):
    """On straight lines of logarithms. None if no setting is as good; at least the fastest setting's time."""
    front = pareto(points)
    if not front or front[-1][1] > error:
        return None
    if front[0][1] <= error:
        return front[0][0]
    for (fast, rough), (slow, fine) in zip(front, front[1:]):
        if fine <= error:
            share = math.log(rough / error) / math.log(rough / fine) if fine > 0 else 1.0
            return fast * (slow / fast) ** share
    raise AssertionError("a front that ends below the error crosses it")


def error_after(points, seconds):
    """None before the fastest setting; after the slowest one, its error, an upper bound."""
    front = pareto(points)
    if not front or front[0][0] > seconds:
        return None
    for (fast, rough), (slow, fine) in zip(front, front[1:]):
        if seconds <= slow:
            return rough * (fine / rough) ** (math.log(seconds / fast) / math.log(slow / fast))
    return front[-1][1]


def geometric_mean(values):
    values = list(values)
    return math.exp(sum(map(math.log, values)) / len(values)) if values else None
