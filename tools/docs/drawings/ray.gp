# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The ray through one lens point l for three places of the focus: in front (w > 0), at infinity (w = 0), behind the
# camera (w < 0). D is the chief ray; the ray starts at l and has the direction D - w l.
load "common.gp"
set terminal svg size 640,520
set multiplot layout 3,1
eval sideview
tilt = 15
lz = 0.75*sin(tilt); ly = 0.75*cos(tilt)
Dz = 2.2; Dy = 0.5
array W = [0.42, 0.0, -0.42]
array T = ["w > 0: toward the focus D / w in front of the lens", "w = 0: parallel to D", \
           "w < 0: away from D / w behind the camera"]
do for [i=1:3] {
  unset arrow; unset label; unset object
  w = W[i]
  set xrange [-6.2:7.2]; set yrange [-1.5:1.9]
  set arrow from -6,0 to 7,0 nohead lc rgb grey dt 3
  set arrow from -lz,-ly to lz,ly nohead lc rgb glass lw 5
  set arrow from -1.2,-1.1 to -1.2,1.1 nohead lc rgb film lw 4
  set arrow from -1.2,-1.2*Dy/Dz to 3*Dz,3*Dy nohead lc rgb grey lw 1
  set arrow from 0,0 to Dz,Dy lc rgb "black" lw 1.5
  set label "D" at Dz,Dy-0.22 font "Helvetica-Bold,13"
  set arrow from lz,ly to lz+Dz-w*lz,ly+Dy-w*ly lc rgb sharp lw 1.5
  set arrow from lz,ly to lz+3*(Dz-w*lz),ly+3*(Dy-w*ly) nohead lc rgb sharp lw 1
  set label "l" at lz-0.2,ly+0.1 right tc rgb glass font "Helvetica-Bold,13"
  if (w != 0) {
    set object 1 circle at Dz/w,Dy/w size 0.08 fc rgb sharp fs solid front
    set label "D / w" at Dz/w,Dy/w+(w > 0 ? -0.32 : 0.38) center tc rgb sharp
  }
  if (w < 0) {
    set arrow from lz,ly to Dz/w,Dy/w nohead lc rgb sharp lw 1 dt 2
    set arrow from 0,0 to Dz/w,Dy/w nohead lc rgb grey lw 1 dt 2
  }
  set label T[i] at -6,1.6
  plot NaN
}
unset multiplot
