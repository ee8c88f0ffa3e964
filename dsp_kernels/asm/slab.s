// Clips an interval of a ray to a slab, low <= o + t d <= high along an axis: as clip_to_slab() of
// dsp_kernels/volume_slab.hpp, bit for bit. Needs reciprocal.s.
// A comparison is a subtraction and its sign: what differs by less than 2^-127 is equal.
//   r1  -> o and d, two words
//   r2  -> low and high, two words
//   r3  -> the interval, entry and exit, two words: clipped; there one instruction after the return
//   r4     1 if something is left, else 0
//   r14    return address
//   changes r1 to r13, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
slab:
        r13 = r14
        r12 = r1
        r1 = r1 + 4
        a0 = *r1
        r11 = r2
        r10 = r3
        r9 = slab_numbers
        if (aeq) goto slab_parallel
        nop
        call reciprocal (r14)
        r2 = slab_numbers
        r8 = slab_numbers + 4
        a1 = *r11++ - *r12              // low - o
        a2 = *r11 - *r12                // high - o
        r7 = slab_numbers + 8
        *r8 = a3 = a1 * *r9             // where the ray crosses the two planes
        *r7 = a3 = a2 * *r9
        nop
        nop
        nop
        a1 = *r8
        a2 = *r7
        a3 = *r10                       // entry
        a0 = *r7 - *r8
        a1 = ifalt(*r7)                 // the first
        a2 = ifalt(*r8)                 // the second
        a0 = -a1 + *r10
        *r10++ = a3 = ifalt(a1)         // the later entry
        a1 = *r10                       // exit
        a0 = a2 - *r10
        *r10 = a1 = ifalt(a2)           // the earlier exit
        a0 = a1 - a3
        nop
        nop
        nop
        if (alt) goto slab_missed
        r4 = 0
        return (r13)
        r4 = 1
slab_missed:
        return (r13)
        nop
slab_parallel:
        a0 = *r12 - *r11++              // o - low
        nop
        nop
        nop
        if (alt) goto slab_missed
        r4 = 0
        a0 = *r11 - *r12                // high - o
        nop
        nop
        nop
        if (alt) goto slab_missed
        nop
        return (r13)
        r4 = 1

        .data
slab_numbers:
        3*float 0.0
        .text
