// One over the square root: as routines::reciprocal_square_root of pxm/dsp32/routines.hpp, bit for
// bit.
//   r1  -> x                        kept; of 0 and negative numbers it is the largest number
//   r2  -> 1/sqrt(x)                there when the routine returns
//   r14    return address
//   changes r3 to r8, a0 to a2, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
reciprocal_square_root:
        r5l = *r1                       // the exponent
        r3 = r1 + 2
        r5 - 0
        if (eq) goto rsqrt_of_nothing
        r6 = *r3                        // the upper half: its sign is that of x
        nop
        if (mi) goto rsqrt_of_nothing
        r4 = rsqrt_mantissa
        r7 = *r1                        // the mantissa in [1, 2): x with the exponent 128
        r8 = 128
        *r4++ = r7
        *r4-- = r6
        *r4 = r8l
        r5 = r5 - 128
        r8 = 1
        r8 = r8 & r5                    // 1 if the exponent is odd
        a1 = *r4                        // m
        r3 = rsqrt_half_value           // v / 2: the same in [1/2, 1), or in [1, 2) if it is odd
        *r3++ = r7
        *r3-- = r6
        r7 = r8 + 127
        *r3 = r7l
        r6 = rsqrt_table
        a0 = *r6++ + a1 * *r6++         // a parabola: c1 + c2 m
        r5 = r5 / 2                     // half of the exponent, rounded down
        nop
        a0 = *r6++ + a0 * a1            // c0 + (c1 + c2 m) m
        r7 = rsqrt_guess
        r8 - 0
        if (eq) goto rsqrt_is_even
        *r7 = a2 = a0                   // r
        *r7 = a0 = a0 * *r6             // times the root of a half
rsqrt_is_even:
        r6 = rsqrt_half
        nop
        nop
        nop
        a1 = *r3 * a0                   // a Newton step: r + r (1/2 - (v/2) r r)
        nop
        nop
        a2 = *r6 - a1 * a0
        nop
        nop
        *r7 = a0 = *r7 + a2 * a0
        nop
        nop
        a1 = *r3 * a0                   // and another
        nop
        nop
        a2 = *r6 - a1 * a0
        nop
        nop
        a0 = *r7 + a2 * a0
        *r2 = a0 = round(a0)
        nop
        nop
        nop
        r7l = *r2
        nop
        r7 = r7 - r5
        return (r14)
        *r2 = r7l
rsqrt_of_nothing:
        r3 = rsqrt_largest
        nop
        *r2 = a0 = *r3
        nop
        return (r14)
        nop

        .data
// The parabola: c2, c1, c0, and behind them the root of a half.
rsqrt_table:
        float 0.147687586, -0.730514325, 1.57963909, 0.70710678118654752
rsqrt_half:
        float 0.5
rsqrt_largest:
        .word 0x7fffffff
rsqrt_mantissa:
        .word 0
rsqrt_half_value:
        .word 0
rsqrt_guess:
        .word 0
        .text
