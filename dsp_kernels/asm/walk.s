// Hierarchical shading (Ch. 17) with constant weights: the colour and the total normal of a cell, as
// surface_at() of dsp_kernels/shade.hpp, bit for bit. The cells on the way to it are met again along
// its word. Needs transform_ray.s, approach.s, normalize.s, compose.s, one of volume_ball.s and
// volume_box.s, and what they need; scene.s has its constants.
//   search_ray: the ray; cell_level and cell_word: the cell
//   walk_color:  its colour, three words, there when the routine returns
//   walk_normal: its total normal, a unit vector; there three instructions after the return
//   r14    return address
//   changes all registers but r14, all accumulators
walk:
        *walk_link = r14
        r1 = *scene_object
        r2 = walk_color
        r3 = r1 + object_color
        *r2++ = a0 = *r3++
        *r2++ = a0 = *r3++
        *r2 = a0 = *r3
        r2 = walk_inverse               // the linear part of M^-1
        r3 = r1 + object_inverse
        r4 = 7
walk_copy:
        if (r4-- >= 0) goto walk_copy
        *r2++ = a0 = *r3++
        r2 = walk_sum
        r3 = walk_zero
        *r2++ = a0 = *r3
        *r2++ = a0 = *r3
        *r2 = a0 = *r3
        r4 = 0
        *walk_visited = r4
        r1 = search_ray
        r2 = *scene_inverse
        r3 = walk_rays
        call transform_ray (r14)
        r21 = 0
        r19 = walk_rays
        r20 = walk_rays + 28
walk_cell:
        r1 = r19
        call approach (r14)
        r2 = scene_volume
        r1 = r19
        r2 = scene_volume + volume_at
        call volume (r14)
        r3 = walk_interval
        r4 - 0
        if (eq) goto walk_not_met
        r10 = walk_interval
        nop
        a0 = *r10
        r5 = *cell_level
        r6 = *walk_visited
        nop
        if (agt) goto volume_normal     // it enters the volume in front of the eye
        r14 = walk_turn
        r5 - r21
        if (ne) goto walk_on
        r6 - 0
        if (ne) goto walk_on
        r14 = walk_turn
        goto volume_normal              // the last one is around the eye: where it leaves the volume
        r10 = r10 + 4
walk_not_met:
        r5 = *cell_level
        r6 = *walk_visited
        r5 - r21
        if (ne) goto walk_on
        r6 - 0
        if (ne) goto walk_on
        r1 = search_ray + 12
        r2 = walk_sum
        r3 = r2
        a0 = -*r1++
        a1 = -*r1++
        a2 = -*r1
        *r3++ = a0 = *r2++ + a0
        *r3++ = a1 = *r2++ + a1
        *r3 = a2 = *r2 + a2
        goto walk_on
        nop
walk_turn:
        r1 = volume_vector
        r2 = walk_inverse
        r3 = walk_turned
        r15 = -8                        // back to the normal's first number
        a0 = *r1++ * *r2++
        a0 = a0 + *r1++ * *r2++
        *r3++ = a0 = a0 + *r1++r15 * *r2++
        a0 = *r1++ * *r2++
        a0 = a0 + *r1++ * *r2++
        *r3++ = a0 = a0 + *r1++r15 * *r2++
        a0 = *r1++ * *r2++
        a0 = a0 + *r1++ * *r2++
        *r3++ = a0 = a0 + *r1 * *r2
        r1 = walk_turned
        call normalize (r14)
        r2 = walk_turned
        r1 = walk_turned
        r2 = walk_sum
        r3 = walk_sum
        r4 = 1
        *walk_visited = r4
        *r3++ = a0 = *r2++ + *r1++
        *r3++ = a0 = *r2++ + *r1++
        *r3 = a0 = *r2 + *r1
walk_on:
        r5 = *cell_level
        r6 = r21 + 0
        r6 = r6 ^ 1
        r21 - r5
        if (eq) goto walk_ends
        r6 = r6 + cell_word
        r7l = *r6
        r21 = r21 + 1
        r7 = r7 * 2
        r7 = r7 + scene_map_table
        r18 = *r7                       // the map's record
        r1 = walk_inverse
        r2 = r18 + map_inverse
        call compose (r14)
        r3 = walk_inverse
        r1 = r18 + map_color
        r2 = r18 + map_color + 12
        r3 = walk_one
        r4 = walk_color
        a1 = *r3 - *r2                  // (1 - a) c + a (r, g, b)
        r5 = walk_color
        nop
        *r5++ = a0 = a1 * *r4++
        *r5++ = a0 = a1 * *r4++
        *r5 = a0 = a1 * *r4
        a0 = *r2 * *r1++
        a2 = *r2 * *r1++
        a3 = *r2 * *r1
        r4 = walk_color
        r5 = walk_color
        *r5++ = a0 = *r4++ + a0
        *r5++ = a2 = *r4++ + a2
        *r5 = a3 = *r4 + a3
        r1 = r19
        r2 = r18 + map_inverse
        call transform_ray (r14)
        r3 = r20
        r18 = r19
        r19 = r20
        goto walk_cell
        r20 = r18
walk_ends:
        r1 = walk_sum
        call normalize (r14)
        r2 = walk_normal
        r14 = *walk_link
        nop
        return (r14)
        nop

        .data
walk_zero:
        float 0.0
walk_one:
        float 1.0
walk_color:
        3*float 0.0
walk_normal:
        3*float 0.0
walk_sum:
        3*float 0.0
walk_turned:
        3*float 0.0
walk_inverse:
        9*float 0.0
walk_rays:
        14*float 0.0
walk_interval:
        2*float 0.0
walk_visited:
        .word 0
walk_link:
        .word 0
        .text
