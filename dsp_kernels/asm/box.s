// Where a ray enters and leaves a box in axes: as intersect_box() of dsp_kernels/volume_box.hpp, bit
// for bit. Needs slab.s and reciprocal.s.
// A comparison is a subtraction and its sign: what differs by less than 2^-127 is equal.
//   r1  -> the ray: origin, direction, base, seven words
//   r2  -> the box: low corner, high corner, six words
//   r3  -> entry and exit, two words; as they were if the ray misses; there three instructions
//          after the return
//   r4     1 if the ray meets the box, else 0
//   r14    return address
//   changes r1 to r13, r15 to r20, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
box:
        r20 = r14
        r19 = r3
        r18 = r1
        r16 = r2
        r17 = 2
        r15 = 12                        // from a coordinate of the origin to that of the direction
        r3 = box_far
        r4 = box_interval
        *r4++ = a0 = -*r3               // everything
        *r4 = a0 = *r3
box_axis:
        r5 = box_axis_numbers
        r6 = r18 + 0
        r7 = r16 + 0
        r1 = r5
        *r5++ = a0 = *r6++r15           // o and d
        *r5++ = a0 = *r6
        *r5++ = a0 = *r7++r15           // low and high
        *r5 = a0 = *r7
        r2 = box_axis_numbers + 8
        call slab (r14)
        r3 = box_interval
        r4 - 0
        if (eq) goto box_missed
        r18 = r18 + 4
        r16 = r16 + 4
        r17 = r17 - 1
        if (pl) goto box_axis
        nop
        r18 = r18 + 12                  // the base
        r1 = r18 + 0
        r2 = box_interval
        r3 = r19 + 0
        *r3++ = a0 = *r1 + *r2++
        *r3 = a0 = *r1 + *r2
box_missed:
        return (r20)
        nop

        .data
box_far:
        float 1e30                      // farther than anything in a scene
box_interval:
        2*float 0.0
box_axis_numbers:
        4*float 0.0
        .text
