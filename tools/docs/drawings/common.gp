# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# What all drawings share: the form of the file, and the colours. "output" is set by make.py.
set encoding utf8
set terminal svg size 640,360 font "Helvetica,13" background "#ffffff" linewidth 1
set output output
film  = "#1f4e9c"
glass = "#0b8a6d"
sharp = "#c0392b"
grey  = "#777777"
set angles degrees
set samples 120
# A side view: no axes, same scale in both directions.
sideview = "unset border; unset xtics; unset ytics; unset key; set size ratio -1; set margins 1,1,1,1"
