// A ray in the coordinates of a master object: as transform_ray() of dsp_kernels/ray.hpp, bit for
// bit (Eq. 12.3).
//   r1  -> the ray: origin, direction, base, seven words                        left behind it
//   r2  -> the inverse map: rows 1 to 3 of T, then the translation, twelve words
//   r3  -> the ray in the master's coordinates, seven words: not where r1 points
//   r14    return address
//   changes r1 to r5, r15, r16, a0 to a3; no memory but the result, all of it there one
//   instruction after the return
//   words and cycles: docs/dsp32.md, "Kernels"
transform_ray:
        r15 = 12                        // to the next row
        r16 = -20                       // from the last row to the next column of the first
        a1 = *r1++
        a2 = *r1++
        a3 = *r1++
        r5 = r2 + 36                    // the translation
        r4 = r2
        // a0 = offset + x T; a column of T is three words, a row apart
        a0 = *r5++ + a1 * *r2++r15
        a0 = a0 + a2 * *r2++r15
        *r3++ = a0 = a0 + a3 * *r2++r16
        a0 = *r5++ + a1 * *r2++r15
        a0 = a0 + a2 * *r2++r15
        *r3++ = a0 = a0 + a3 * *r2++r16
        a0 = *r5++ + a1 * *r2++r15
        a0 = a0 + a2 * *r2++r15
        *r3++ = a0 = a0 + a3 * *r2
        // d T
        a1 = *r1++
        a2 = *r1++
        a3 = *r1++
        nop
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        *r3++ = a0 = a0 + a3 * *r4++r16
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        *r3++ = a0 = a0 + a3 * *r4++r16
        a0 = a1 * *r4++r15
        a0 = a0 + a2 * *r4++r15
        *r3++ = a0 = a0 + a3 * *r4
        *r3 = a0 = *r1                  // the base stays
        return (r14)
        nop
