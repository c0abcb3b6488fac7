# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Equation (1) of the paper by Nakane et al.: tan(theta_L) = f_p tan(theta_F) / (U + f_p).
load "common.gp"
set border 3; set tics nomirror; set grid lc rgb "#dddddd"
set xlabel "turn of the plane of sharp focus, degrees"
set ylabel "tilt of the lens, degrees"
set xrange [0:89]; set yrange [0:20]
set xtics 15
set arrow from 0,8.5 to 89,8.5 nohead lc rgb grey dt 2
set label "as far as most real lenses go" at 1,8.9 tc rgb grey
set key top left title "U / f_p" samplen 2 Left reverse
array R = [5, 10, 20, 40, 80]
plot for [i=1:5] atan(tan(x)/(R[i] + 1)) lw 2 title sprintf("%d", R[i])
