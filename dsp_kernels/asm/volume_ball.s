// Balls as the volumes of cells: what the node program calls a volume, its numbers and its normal.
// Needs ball.s, normalize.s, scene.s, walk.s and what they need; ball.s and scene.s above it.
//   volume_normal: the unit vector away from a cell's ball, as sphere_normal() of
//   dsp_kernels/volume_sphere.hpp and normalize(), bit for bit
//   r10 -> where on the ray, a word
//   r19 -> the ray: origin, direction, base, seven words
//   r14    return address
//   volume_vector: the unit vector, there three instructions after the return
//   changes r1 to r13, a0 to a3
.equ volume, ball
.equ volume_at, 0                       // from the centre to what ball.s takes
.equ read_volume, read_scene
volume_normal:
        r1 = r19 + 24                   // the base
        r2 = r19 + 12
        a1 = *r10 - *r1
        r3 = r19
        r4 = scene_volume
        a2 = a1 * *r2++
        a3 = a1 * *r2++
        a0 = a1 * *r2
        a2 = *r3++ + a2                 // the point
        a3 = *r3++ + a3
        a0 = *r3 + a0
        r5 = volume_vector
        *r5++ = a2 = -*r4++ + a2        // from the centre
        *r5++ = a3 = -*r4++ + a3
        *r5 = a0 = -*r4 + a0
        r1 = volume_vector
        goto normalize
        r2 = volume_vector

        .data
scene_volume:
        4*float 0.0                     // centre and radius
volume_vector:
        3*float 0.0
        .text
