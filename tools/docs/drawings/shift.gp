# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# A wall seen by a camera that is turned up, and by a level camera whose frame is shifted: only the second film is
# parallel to the wall, so only there upright lines stay parallel.
load "common.gp"
set terminal svg size 640,330
set multiplot layout 1,2
eval sideview
top = 4.2; far = 5.0; s = 1.1; half = 0.4
set xrange [-2.2:6]; set yrange [-2.4:5]
up = atan(top/2/far)
do for [i=1:2] {
  unset arrow; unset label; unset object
  set arrow from -2.2,-1 to 6,-1 nohead lc rgb grey
  set object 1 rect from far,-1 to far+0.5,top+0.3 fc rgb "#e2cfa4" fs solid border lc rgb grey
  turn = i == 1 ? up : 0
  rise = i == 1 ? 0 : s*tan(up)
  # the film's middle and its direction
  Mz = -s*cos(turn); My = -s*sin(turn) - rise
  Uz = -sin(turn); Uy = cos(turn)
  set arrow from Mz-half*Uz,My-half*Uy to Mz+half*Uz,My+half*Uy nohead lc rgb film lw 5
  set arrow from -0.5*Uz,-0.5*Uy to 0.5*Uz,0.5*Uy nohead lc rgb glass lw 5
  do for [j=-1:1:2] {
    Fz = Mz+j*half*Uz; Fy = My+j*half*Uy
    set arrow from Fz,Fy to far,Fy/Fz*far nohead lc rgb "#b8860b" lw 1
  }
  set label (i == 1 ? "camera turned up" : "frame shifted up") at -2.1,4.6
  set label "film" at Mz-0.15,My+0.75 right tc rgb film
  plot NaN
}
unset multiplot
