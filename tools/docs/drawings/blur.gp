# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# A lens of 50 mm at f/2 focused at 2 m, film 36 mm wide, picture 1280 pixels wide: the blur of a point on the axis
# against its distance, and against the inverse of its distance, where it is a straight line.
load "common.gp"
f = 0.05; N = 2.0; Z0 = 2.0; film_width = 0.036; pixels = 1280.0
s = 1/(1/f - 1/Z0)
blur(v) = (f/N)*s*(v - 1/Z0)*pixels/film_width
limit = film_width/pixels/((f/N)*s)
near = 1/(1/Z0 + limit); far = 1/(1/Z0 - limit)
set multiplot layout 1,2
set grid lc rgb "#dddddd"
set border 3; set tics nomirror
set ylabel "blur, pixels"
set xlabel "distance, m"
set xrange [0.8:12]; set yrange [-25:40]; set logscale x
set xtics (1, 2, 5, 10)
set arrow from near,-25 to near,0 nohead lc rgb grey dt 2
set arrow from far,-25 to far,0 nohead lc rgb grey dt 2
set label sprintf("sharp to a pixel:\n%.2f m to %.2f m", near, far) at far*1.08,-19 tc rgb grey
unset key
plot blur(1/x) lc rgb sharp lw 2, 0 lc rgb grey
unset logscale; unset label; unset arrow
set xlabel "1 / distance, 1/m"
set xrange [0:1.25]; set xtics 0.25
set label "infinity" at 0.09,blur(0)+1 tc rgb grey
set label "the focus" at 1/Z0+0.02,-3 tc rgb grey
plot blur(x) lc rgb sharp lw 2, 0 lc rgb grey
unset multiplot
