// The unit vector along a vector: as normalize() of dsp_kernels/vector.hpp, bit for bit. Needs
// reciprocal.s and reciprocal_square_root.s.
//   r1  -> the vector, three words  kept
//   r2  -> the unit vector, three words; of the null vector it is null; there three instructions
//          after the return
//   r14    return address
//   changes r1 to r13, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
normalize:
        r13 = r14
        r12 = r1
        r11 = r2
        a1 = -*r1
        a3 = *r1++
        a3 = ifalt(a1)                  // the largest of the three magnitudes
        a1 = -*r1
        a0 = *r1++
        a0 = ifalt(a1)
        a2 = -a0 + a3
        a3 = ifalt(a0)
        a1 = -*r1
        a0 = *r1
        a0 = ifalt(a1)
        a2 = -a0 + a3
        a3 = ifalt(a0)
        r1 = normalize_largest
        *r1 = a3 = a3
        r2 = normalize_scale
        r10 = r2
        r9 = normalize_sized
        if (aeq) goto normalize_nothing
        r8 = r9
        call reciprocal (r14)
        nop
        nop
        nop
        nop
        *r9++ = a0 = *r12++ * *r10      // the vector, of a size whose square has a word
        *r9++ = a0 = *r12++ * *r10
        *r9 = a0 = *r12 * *r10
        r1 = normalize_largest
        nop
        nop
        a0 = *r8++ * *r8                // its square: the second operand is read first
        a0 = a0 + *r8++ * *r8
        *r1 = a0 = a0 + *r8 * *r8
        r10 = r2
        r12 = normalize_sized
        call reciprocal_square_root (r14)
        nop
        *r11++ = a0 = *r12++ * *r10
        *r11++ = a0 = *r12++ * *r10
        return (r13)
        *r11 = a0 = *r12 * *r10
normalize_nothing:
        *r11++ = a0 = a3
        *r11++ = a0 = a3
        return (r13)
        *r11 = a0 = a3

        .data
normalize_largest:
        .word 0
normalize_scale:
        .word 0
normalize_sized:
        3*float 0.0
        .text
