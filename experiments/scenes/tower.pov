// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A bright tower on black, 30 m high and 6 m wide, from the street: its verticals are measured.
// Rise: shift upward in mm; Pitch: 1 looks up instead; F_Stop 0: a pinhole; Tilt: of the lens.

#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Rise) #declare Rise = 0; #end
#ifndef (Pitch) #declare Pitch = 0; #end
#ifndef (F_Stop) #declare F_Stop = 0; #end
#ifndef (Tilt) #declare Tilt = 0; #end

camera
{
  perspective
  location <0, 1.6, -40>
  right image_width/image_height*x
  look_at <0, 1.6 + 12*Pitch, 0>
  #if (F_Stop) blur_samples 1024  variance 0  #end
  focal_point <0, 1.6 + 12*Pitch, 0>
  tilt_lens
  {
    film_width 24
    focal_length 45
    shift <0, Rise>
    tilt Tilt
    #if (F_Stop) f_stop F_Stop #end
  }
}

box
{
  <-3, -20, 0>, <3, 30, 6>
  pigment { color rgb 1 }
  finish { ambient 0 diffuse 0 emission 1 }
}
