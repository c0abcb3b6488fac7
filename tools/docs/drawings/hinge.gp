# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The same lens focused at five distances (five film distances s): the plane of sharp focus swings about the hinge line.
load "common.gp"
eval sideview
f = 1.0; tilt = 20; J = f/sin(tilt)
plane(z, s) = -(1 - (cos(tilt)/f - 1/s)*z)*f/sin(tilt)
set xrange [-1.8:9.4]; set yrange [-3.6:2.6]
set arrow from -1.8,0 to 9.2,0 nohead lc rgb grey dt 3
set arrow from 0,-3.5 to 0,1.2 nohead lc rgb grey dt 3
set arrow from -0.6*sin(tilt),-0.6*cos(tilt) to 0.6*sin(tilt),0.6*cos(tilt) nohead lc rgb glass lw 5
set label "lens" at 0.3,0.9 tc rgb glass
array S = [1.09, 1.13, 1.19, 1.28, 1.42]
do for [i=1:5] {
  set arrow from -S[i],-0.6 to -S[i],0.6 nohead lc rgb film lw 1.5
}
set label "film: near ... far" at -1.7,-0.95 tc rgb film
set object 1 circle at 0,-J size 0.07 fc rgb sharp fs solid front
set label "hinge line" at 0.18,-J-0.3 tc rgb sharp front
set label "far" at 9.3,plane(9.0,S[1])-0.25 right tc rgb sharp
set label "near" at 6.6,plane(6.6,S[5])+0.3 right tc rgb sharp
plot for [i=1:5] (x > 0 && x < 9.2 ? plane(x, S[i]) : NaN) lc rgb sharp lw 1.2
