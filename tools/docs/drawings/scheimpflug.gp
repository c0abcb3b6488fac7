# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# A lens with f = 1, tilted by 20 degrees, its film 1.25 behind it: film, lens plane and plane of sharp focus meet
# in one line; the hinge line lies J = f / sin(tilt) below the lens.
load "common.gp"
eval sideview
f = 1.0; s = 1.25; tilt = 20
kz = cos(tilt)/f - 1/s; ky = -sin(tilt)/f
plane(z) = (1 - kz*z)/ky
J = f/sin(tilt); low = -s/tan(tilt)
set xrange [-2.4:8.6]; set yrange [-4.4:2]
set arrow from -2.4,0 to 8.4,0 nohead lc rgb grey dt 3
set label "axis" at 8.5,0.2 right tc rgb grey
set arrow from -s,-4.3 to -s,1.4 nohead lc rgb film lw 1 dt 2
set arrow from -s,-0.75 to -s,0.75 nohead lc rgb film lw 5
set label "film" at -s-0.12,1.0 right tc rgb film
set arrow from 4.4*sin(-tilt)/cos(tilt)*0.86,-4.4*0.86 to 1.7*tan(tilt),1.7 nohead lc rgb glass dt 2
set arrow from -0.75*sin(tilt),-0.75*cos(tilt) to 0.75*sin(tilt),0.75*cos(tilt) nohead lc rgb glass lw 5
set label "lens plane" at 0.8,1.55 tc rgb glass
set arrow from 0,0 to 1.5*cos(tilt),-1.5*sin(tilt) lc rgb glass
set label "t" at 1.5*cos(tilt)+0.1,-1.5*sin(tilt)-0.05 tc rgb glass font "Helvetica-Bold,13"
set arrow from 0,-4 to 0,1.4 nohead lc rgb grey dt 3
set label "plane of sharp focus" at 4.6,plane(4.6)-0.35 tc rgb sharp
set object 1 circle at 0,-J size 0.07 fc rgb sharp fs solid front
set label "hinge line" at 0.18,-J-0.25 tc rgb sharp front
set arrow from 0.22,-0.1 to 0.22,-J+0.1 heads lc rgb grey
set label "J = f / sin tilt" at 0.34,-1.7 tc rgb grey
set object 2 circle at -s,low size 0.07 fc rgb "black" fs solid front
set label "Scheimpflug's line" at -s+0.12,low-0.4
set arrow from -s,0.2 to 0,0.2 heads lc rgb grey
set label "s" at -s/2,0.42 center tc rgb grey
Pz = 7.0; Py = plane(Pz)
Qz = 3.2; Qy = plane(Qz)
do for [i=1:2] {
  Z = i == 1 ? Pz : Qz; Y = i == 1 ? Py : Qy
  set arrow from Z,Y to -s,-Y*s/Z nohead lc rgb "#b8860b" lw 1
}
plot (x > -s && x < 8.4 ? plane(x) : NaN) lc rgb sharp lw 2
