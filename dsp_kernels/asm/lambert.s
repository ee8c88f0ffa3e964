// Lambert's law under directional lights (Eq. 17.1): as illuminate() of dsp_kernels/lights.hpp, bit
// for bit, where no light casts a shadow. Needs scene_block.s.
//   r1  -> the unit normal, three words
//   r2  -> the surface's colour, three words
//   r3  -> its diffuse share
//   r4  -> the light that it sends back, three words; there two instructions after the return
//   r14    return address
//   changes r5 to r12, r15, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
lambert:
        r5 = block_ambient
        r6 = lambert_sum
        *r6++ = a0 = *r5++
        *r6++ = a0 = *r5++
        *r6 = a0 = *r5
        r7 = *block_lights
        r8 = *block_light_count
        r7 = r7 * 2
        r7 = r7 * 2
        r7 = r7 + block + light_place   // the place, then the colour
        r15 = light_bytes - 12
        r8 - 0
        if (eq) goto lambert_lit
        r8 = r8 - 2
lambert_light:
        r9 = r1
        a0 = *r9++ * *r7++
        a0 = a0 + *r9++ * *r7++
        a0 = a0 + *r9 * *r7++
        r10 = r7
        r7 = r7 + light_bytes - 12
        r11 = lambert_sum
        if (ale) goto lambert_dark      // on the side away from it
        r12 = lambert_sum
        a1 = *r3 * a0
        nop
        nop
        a0 = a1 * *r10++
        a2 = a1 * *r10++
        a3 = a1 * *r10
        *r12++ = a0 = *r11++ + a0
        *r12++ = a2 = *r11++ + a2
        *r12 = a3 = *r11 + a3
lambert_dark:
        if (r8-- >= 0) goto lambert_light
        nop
lambert_lit:
        r9 = r2
        r10 = r4
        r11 = lambert_sum
        nop
        *r10++ = a0 = *r11++ * *r9++
        *r10++ = a0 = *r11++ * *r9++
        *r10 = a0 = *r11 * *r9
        return (r14)
        nop

        .data
lambert_sum:
        3*float 0.0
        .text
