// The size of a pixel at a distance along a ray (Ch. 15): as pixel_size() of
// dsp_kernels/pixel_size.hpp, bit for bit.
//   r1  -> p at the ray's origin and its growth, two words
//   r2  -> the distance
//   r3  -> the least that p may be
//   r4  -> p                        there four instructions after the return's slot began
//   r14    return address
//   changes r5, a0, a1
//   words and cycles: docs/dsp32.md, "Kernels"
pixel_size:
        r5 = r1 + 4
        a0 = *r5 * *r2
        nop
        nop
        a0 = *r1 + a0                   // without guard bits, both here and where it is compared
        nop
        nop
        a1 = -*r3 + a0
        return (r14)
        *r4 = a0 = ifalt(*r3)
