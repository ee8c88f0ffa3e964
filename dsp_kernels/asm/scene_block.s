// Where the scene block's fields lie, as dsp_kernels/scene_block.hpp has them, in bytes: a test
// compares the two. The node sees the first 4 KiB of the block through the window on its back buffer.
// No instructions.
.equ block, 0xa000
// The header.
.equ block_objects, block + 28
.equ block_light_count, block + 32
.equ block_lights, block + 36
.equ block_cell_cap, block + 48
.equ block_sample_count, block + 56
.equ block_samples, block + 60
.equ block_eye, block + 76
.equ block_corner, block + 88
.equ block_across, block + 100
.equ block_down, block + 112
.equ block_pixel, block + 136           // at the eye, then the growth
.equ block_detail, block + 144
.equ block_ambient, block + 152
.equ block_background, block + 164
.equ block_sample_share, block + 176
// An object, from its record on.
.equ object_levels, 8
.equ object_inverse, 24
.equ object_constant, 108
.equ object_smallest_pixel, 112
.equ object_color, 116
.equ object_diffuse, 128
// A follow set.
.equ set_map_count, 4
.equ set_center, 12                     // then the radius
.equ set_low, 24                        // then the high corner
.equ set_diameter, 48
.equ set_maps, 52
// A map.
.equ map_inverse, 12
.equ map_constant, 96
.equ map_color, 100                     // red, green, blue, share
// A light.
.equ light_place, 8
.equ light_color, 20
.equ light_bytes, 32
