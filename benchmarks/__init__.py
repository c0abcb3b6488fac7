# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Run time against error, and how batches scale. `benchmarks/run` builds the programs and runs `benchmark`."""
