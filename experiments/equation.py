# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Equation (1) of Nakane et al., and reversed."""

from experiments.laboratory import Claim

LIMIT = 8.0  # of 2^-52: a dozen roundings


def table(lab):
    lab.results.mkdir(parents=True, exist_ok=True)
    report = lab.json([lab.tool("optics_table"), "--csv", lab.results / "equation1.csv", "--limit", LIMIT], accept=(0, 2))
    yield Claim(f"equation (1), {report['rows']} rows", report["worst"], LIMIT, "x 2^-52")
    yield Claim("the same in reverse", report["worst_reverse"], LIMIT, "x 2^-52")
