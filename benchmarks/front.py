# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fronts: the least CPU time of a program for each error, over all of its settings."""

import math


def pareto(points):
    """(seconds, error) pairs that no other pair beats in both (Pareto front), the fastest first."""
    front = []
    for seconds, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((seconds, error))
    return front


def seconds_for(points, error):
    """CPU seconds for an error, on straight lines of logarithms between settings. The fastest setting's time if it
    is already better; None if no setting is as good."""
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
    """The error after some CPU time, interpolated alike. None if the fastest setting takes longer; the slowest
    setting's error, an upper bound, if it takes less."""
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
