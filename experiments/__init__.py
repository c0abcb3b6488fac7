# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The experiments of the paper by Nakane et al. (docs/paper.md). `experiments/run` builds the programs and runs `paper`."""
