// The quotient: as routines::divide of pxm/dsp32/routines.hpp, bit for bit.
//   r1  -> x, the numerator         kept
//   r2  -> y, the denominator       kept
//   r3  -> x/y                      there four instructions after the return's slot began
//   r14    return address
//   changes r4 to r7, a0 to a3, and its scratch word
//   words and cycles: docs/dsp32.md, "Kernels"
divide:
        r5 = *r2++                      // the lower half of y
        r6 = *r2--                      // its upper half
        r4 = divide_seed
        r5 = r5 ^ 0xffff                // the seed: all bits but the sign inverted
        *r4++ = r5
        r6 = r6 ^ 0x7fff
        *r4-- = r6
        a1 = 1.0 - *r2 * *r4            // d = 1 - y s
        r7 = divide_table
        nop
        a2 = *r7++ + a1 * *r7++         // p2 + p3 d
        nop
        nop
        a2 = *r7++ + a2 * a1            // p1 + ...
        nop
        nop
        a2 = *r7++ + a2 * a1            // p0 + ...
        nop
        nop
        a1 = a2 * *r4                   // r, about 1/y
        nop
        nop
        *r3 = a2 = a1 * *r1             // q = x r
        nop
        nop
        a3 = *r1 - a2 * *r2             // the remainder: x - q y
        nop
        nop
        a2 = *r3 + a3 * a1              // q + (x - q y) r
        return (r14)
        *r3 = a2 = round(a2)

        .data
// The best cubic for 1/t in powers of d = 1 - t, t in [1, 9/8]: p3, p2, p1, p0.
divide_table:
        float 0.7873882830697883, 0.9842353538372354, 0.9996140312409422, 0.9999984981760348
divide_seed:
        .word 0
        .text
