// The reciprocal: as routines::reciprocal of pxm/dsp32/routines.hpp, bit for bit.
//   r1  -> y                        kept
//   r2  -> 1/y                      there four instructions after the return's slot began
//   r14    return address
//   changes r3 to r6, a0 to a3, and its scratch word
//   words and cycles: docs/dsp32.md, "Kernels"
reciprocal:
        r5 = *r1++                      // the lower half of y
        r6 = *r1--                      // its upper half
        r4 = reciprocal_seed
        r5 = r5 ^ 0xffff                // the seed: all bits but the sign inverted
        *r4++ = r5
        r6 = r6 ^ 0x7fff
        *r4-- = r6
        a1 = 1.0 - *r1 * *r4            // d = 1 - y s
        r3 = reciprocal_table
        nop
        a2 = *r3++ + a1 * *r3++         // p2 + p3 d
        nop
        nop
        a2 = *r3++ + a2 * a1            // p1 + ...
        nop
        nop
        a2 = *r3++ + a2 * a1            // p0 + ...
        nop
        nop
        *r2 = a2 = a2 * *r4             // r: below 2 parts in a million
        nop
        nop
        a3 = 1.0 - *r1 * a2             // a Newton step: r + r (1 - y r)
        nop
        nop
        a2 = *r2 + a2 * a3
        return (r14)
        *r2 = a2 = round(a2)

        .data
// The best cubic for 1/t in powers of d = 1 - t, t in [1, 9/8]: p3, p2, p1, p0.
reciprocal_table:
        float 0.7873882830697883, 0.9842353538372354, 0.9996140312409422, 0.9999984981760348
reciprocal_seed:
        .word 0
        .text
