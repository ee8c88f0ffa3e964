// The eye's ray through a place in a pixel, in perspective (Sec. 13.1): as eye_ray() of
// dsp_kernels/camera.hpp, bit for bit. Needs normalize.s, reciprocal.s, reciprocal_square_root.s and
// scene_block.s.
//   r1  -> x and y of the pixel, two halves
//   r2  -> the place in it, two words
//   r3  -> the ray: origin, direction, base, seven words; there three instructions after the return
//   r14    return address
//   changes r1 to r13, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
eye_ray:
        *eye_ray_link = r14
        a0 = float(*r1++)
        a1 = float(*r1)
        a2 = a0 + *r2++                 // column and row
        a3 = a1 + *r2
        r4 = block_across
        r5 = block_corner
        r6 = eye_ray_point
        a0 = a2 * *r4++
        a1 = a2 * *r4++
        a2 = a2 * *r4
        *r6++ = a0 = *r5++ + a0         // the corner, and so many columns across
        *r6++ = a1 = *r5++ + a1
        *r6 = a2 = *r5 + a2
        r4 = block_down
        a0 = a3 * *r4++
        a1 = a3 * *r4++
        a2 = a3 * *r4
        r5 = eye_ray_point
        r6 = eye_ray_point
        *r6++ = a0 = *r5++ + a0         // and so many rows down
        *r6++ = a1 = *r5++ + a1
        *r6 = a2 = *r5 + a2
        r4 = block_eye
        *r3++ = a0 = *r4++
        *r3++ = a0 = *r4++
        *r3++ = a0 = *r4
        r2 = r3                         // the direction
        r5 = eye_ray_zero
        r3 = r3 + 12
        *r3 = a0 = *r5
        call normalize (r14)
        r1 = eye_ray_point
        r14 = *eye_ray_link
        nop
        return (r14)
        nop

        .data
eye_ray_point:
        3*float 0.0
eye_ray_zero:
        float 0.0
eye_ray_link:
        .word 0
        .text
