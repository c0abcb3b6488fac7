" povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
" SPDX-License-Identifier: AGPL-3.0-or-later
"
" Adds tilt_lens to Vim's own colours for POV-Ray. Its items are coloured inside its block only: outside they
" are free for identifiers. The same for the macros of tilt_lens.inc.

syn match   povTiltLens      "\<tilt_lens\>" nextgroup=povTiltLensBlock skipwhite skipempty
syn region  povTiltLensBlock matchgroup=povTiltLensBrace start="{" end="}" contained
      \ contains=ALLBUT,povBraceError,@povPRIVATE
syn keyword povTiltLensItem  contained containedin=povTiltLensBlock
      \ tilt swing focus_tilt focus_swing focal_plane focal_points
      \ sharp_points sharp_within circle_of_confusion
      \ focus_on focus_at film_distance focus_scale sample_seed
      \ shift film_width focal_length scene_unit f_stop blades blade_curvature squeeze denoise budget
      \ edge_light natural_vignetting optical_vignetting distortion field_curvature
      \ lateral_colour axial_colour prescription dispersion
      \ focus_peaking focus_map show_planes
" Vim's own regions between braces contain all groups but those of this cluster.
syn cluster povPRIVATE add=povTiltLensBlock,povTiltLensItem
syn match   povTiltLensMacro "\<Tilt_Lens_\w\+\>"

hi def link povTiltLens      Statement
hi def link povTiltLensItem  Type
hi def link povTiltLensMacro Function
