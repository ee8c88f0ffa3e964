// The product of two linear maps, first one and then the other: as compose() of
// dsp_kernels/affine.hpp, bit for bit.
//   r1  -> the first, by rows, nine words
//   r2  -> the second, nine words
//   r3  -> the product, nine words; it may be where r1 points; there two instructions after the
//          return
//   r14    return address
//   changes r1 to r5, r15, r16, a0 to a3
//   words and cycles: docs/dsp32.md, "Kernels"
compose:
        r15 = 12                        // to the next row
        r16 = -20                       // from the last row to the next column of the first
        r5 = 1                          // rows left, less one
compose_row:
        a1 = *r1++
        a2 = *r1++
        a3 = *r1++
        r4 = r2
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        *r3++ = a0 = a0 + a3 * *r4++r16
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        *r3++ = a0 = a0 + a3 * *r4++r16
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        if (r5-- >= 0) goto compose_row
        *r3++ = a0 = a0 + a3 * *r4
        return (r14)
        nop
