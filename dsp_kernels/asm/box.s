// Where a ray enters and leaves a box in axes: as intersect_box() of dsp_kernels/volume_box.hpp, bit
// for bit. Needs slab.s and reciprocal.s.
// A comparison is a subtraction and its sign: what differs by less than 2^-127 is equal.
//   r1  -> the ray: origin, direction, base, seven words
//   r2  -> the box: low corner, high corner, six words
//   r3  -> entry and exit, two words; as they were if the ray misses
//   r4     1 if the ray meets the box, else 0
//   r14    return address
//   changes r1 to r13, r15, r16, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
box:
        *box_link = r14
        *box_to = r3
        r15 = r1
        r16 = r2
        r4 = 2
        *box_axes = r4
        r3 = box_far
        r4 = box_interval
        *r4++ = a0 = -*r3               // everything
        *r4 = a0 = *r3
box_axis:
        r1 = box_axis_numbers
        r5 = r1
        r6 = r15
        r7 = r15 + 12                   // from a coordinate of the origin to that of the direction
        r8 = r16
        r9 = r16 + 12                   // from the low corner to the high one
        *r5++ = a0 = *r6                // o and d
        *r5++ = a0 = *r7
        *r5++ = a0 = *r8                // low and high
        *r5 = a0 = *r9
        r2 = box_axis_numbers + 8
        call slab (r14)
        r3 = box_interval
        r4 - 0
        if (eq) goto box_ends
        r5 = *box_axes
        r15 = r15 + 4
        r16 = r16 + 4
        r5 = r5 - 1
        if (pl) goto box_axis
        *box_axes = r5
        r3 = *box_to
        r1 = r15 + 12                   // the base
        r2 = box_interval
        *r3++ = a0 = *r1 + *r2++
        *r3 = a0 = *r1 + *r2
box_ends:
        r14 = *box_link
        nop
        return (r14)
        nop

        .data
box_far:
        float 1e30                      // farther than anything in a scene
box_interval:
        2*float 0.0
box_axis_numbers:
        4*float 0.0
box_axes:
        .word 0                         // axes that are left, without this one
box_link:
        .word 0
box_to:
        .word 0
        .text
