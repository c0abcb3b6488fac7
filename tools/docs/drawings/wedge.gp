# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# What is blurred by less than a given amount: between two planes parallel to the film for an ordinary lens, in a
# wedge with its edge in the hinge line for a tilted one. f = 1, f/2, s as needed, blur 0.02 on the film.
load "common.gp"
set terminal svg size 640,520
set multiplot layout 2,1
eval sideview
f = 1.0; N = 2.0; blur = 0.02
set xrange [-2:14]; set yrange [-3.2:2.8]
do for [i=1:2] {
  unset arrow; unset label; unset object
  tilt = i == 1 ? 0 : 20
  kz = i == 1 ? 1/5.5 : 0.10
  s = 1/(cos(tilt)/f - kz)
  d = blur/(f/N*s)
  set arrow from -2,0 to 13.8,0 nohead lc rgb grey dt 3
  set arrow from -0.7*sin(tilt),-0.7*cos(tilt) to 0.7*sin(tilt),0.7*cos(tilt) nohead lc rgb glass lw 5
  set arrow from -s,-0.6 to -s,0.6 nohead lc rgb film lw 4
  if (i == 1) {
    near = 1/(kz + d); far = 1/(kz - d)
    set object 1 rect from near,-2.4 to far,2.4 fc rgb "#f5d0ca" fs solid noborder behind
    set arrow from 1/kz,-2.4 to 1/kz,2.4 nohead lc rgb sharp lw 2
    set label "near limit" at near,2.65 center tc rgb sharp
    set label "far limit" at far,2.65 center tc rgb sharp
    set label "lens parallel to the film" at -1.9,2.4
    plot NaN
  } else {
    plane(z, k) = -(1 - k*z)*f/sin(tilt)
    set arrow from 0,-3.1 to 0,0.9 nohead lc rgb grey dt 3
    set object 1 circle at 0,-f/sin(tilt) size 0.09 fc rgb sharp fs solid front
    set label "hinge line" at 0.2,-f/sin(tilt)-0.25 tc rgb sharp front
    set label "near limit" at 8.2,plane(8.2,kz+d)+0.65 right tc rgb sharp front
    set label "far limit" at 13,plane(13,kz-d)-0.4 right tc rgb sharp front
    set label "tilted lens" at -1.9,2.4
    inside(x) = x > 0 && x < 13.5
    plot "+" using 1:(inside($1) ? plane($1,kz+d) : NaN):(plane($1,kz-d)) with filledcurves fc rgb "#f5d0ca", \
         (inside(x) ? plane(x, kz) : NaN) lc rgb sharp lw 2
  }
}
unset multiplot
