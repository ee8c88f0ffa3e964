// The square root: as routines::square_root of pxm/dsp32/routines.hpp, bit for bit.
//   r1  -> x                        kept; 0 and negative numbers have the root 0
//   r2  -> its root                 there when the routine returns
//   r14    return address
//   changes r3 to r8, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
square_root:
        r5l = *r1                       // the exponent
        r3 = r1 + 2
        r5 - 0
        if (eq) goto root_of_nothing
        r6 = *r3                        // the upper half: its sign is that of x
        nop
        if (mi) goto root_of_nothing
        r4 = root_mantissa
        r7 = *r1                        // the mantissa in [1, 2): x with the exponent 128
        r8 = 128
        *r4++ = r7
        *r4-- = r6
        *r4 = r8l
        r5 = r5 - 128
        r8 = 1
        r8 = r8 & r5                    // 1 if the exponent is odd
        a1 = *r4                        // m
        r3 = root_value                 // v: the same, in [2, 4) if it is odd
        *r3++ = r7
        *r3-- = r6
        r7 = r8 + 128
        *r3 = r7l
        r6 = root_line
        a0 = *r6++ + a1 * *r6++         // a line for the root: a + b m
        r4 = root_guess
        r8 - 0
        if (eq) goto root_is_even
        *r4 = a2 = a0                   // s
        nop
        *r4 = a0 = a0 * *r6             // times the root of 2
root_is_even:
        r6 = root_table
        nop
        nop
        nop
        r7 = *r4++                      // the seed of its reciprocal
        r8 = *r4--
        r4 = root_seed
        r7 = r7 ^ 0xffff
        *r4++ = r7
        r8 = r8 ^ 0x7fff
        *r4-- = r8
        a1 = 1.0 - a0 * *r4             // d = 1 - s seed
        r7 = root_guess
        nop
        a2 = *r6++ + a1 * *r6++         // p2 + p3 d
        a0 = *r7                        // s without guard bits
        nop
        a2 = *r6++ + a2 * a1            // p1 + ...
        nop
        nop
        a2 = *r6++ + a2 * a1            // p0 + ...
        a3 = *r3 - a0 * *r7             // v - s s
        nop
        *r4 = a1 = a2 * *r4             // r, about 1/s
        nop
        nop
        a2 = a1 * *r6                   // r / 2
        nop
        nop
        *r7 = a0 = a0 + a2 * a3         // s + (v - s s) r / 2
        nop
        nop
        a2 = 1.0 - a0 * a1              // the same for the better root, with a better r
        nop
        a3 = *r3 - a0 * *r7             // v - s s
        a1 = *r4 + a1 * a2              // r + r (1 - s r)
        nop
        nop
        a1 = a1 * *r6                   // r / 2
        a0 = *r7
        nop
        a0 = a0 + a1 * a3
        r5 = r5 / 2                     // half of the exponent, rounded down
        nop
        *r2 = a0 = round(a0)
        nop
        nop
        nop
        r7l = *r2
        nop
        r7 = r7 + r5
        return (r14)
        *r2 = r7l
root_of_nothing:
        r3 = root_zero
        nop
        *r2 = a0 = *r3
        nop
        return (r14)
        nop

        .data
// The line a + b m: b, a, and behind them the root of 2.
root_line:
        float 0.417307600, 0.590162067, 1.41421356237309505
// As in reciprocal.s; then a half.
root_table:
        float 0.7873882830697883, 0.9842353538372354, 0.9996140312409422, 0.9999984981760348
        float 0.5
root_zero:
        float 0.0
root_mantissa:
        .word 0
root_value:
        .word 0
root_guess:
        .word 0
root_seed:
        .word 0
        .text
