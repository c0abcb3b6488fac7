# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
from tests.stress import results


def measure(setup, log2_samples=20):
    tool = setup.tool("stress_sampler")
    return results.once(setup.work("sampler"), str(log2_samples), [tool], lambda: results.output([tool, log2_samples]), faults)


def faults(result):
    found = []
    for row in result["projections"]:
        own = row["pair"] in ("lens u, lens v", "pixel x, pixel y")
        found += [f"{row['pair']}: t = {t} at 2^{m} samples" for m, t in row["t"].items() if t > (0 if own else 3 if int(m) <= 14 else 5)]
    if any(result["repeated"]) or result["overflow_faults"]:
        found.append(f"repeated {result['repeated']}, at the ends of the index {result['overflow_faults']}")
    for row in result["discrepancy"]:
        if row["worst"] > row["bound"] or row["worst"] > row["random"]:
            found.append(f"star discrepancy: {row}")
        if abs(row["hammersley"] - row["hammersley_known"]) > 1e-9:
            found.append(f"the discrepancy of Hammersley's points is wrong: {row}")
    # one of 27 correlations exceeds 4.5 standard errors with a chance of 2e-4
    for row in result["correlation"]:
        found += [
            f"neighbours {where}: {row[where]:.1f} standard errors at {row['samples']} samples"
            for where in ("right", "below", "diagonal")
            if row[where] > 4.5
        ]
    return found
