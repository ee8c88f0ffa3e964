// Whether a ray meets a cell's volume, and where, within the interval of the cell around it: as meet()
// of dsp_kernels/descend.hpp, bit for bit (Step 2.4.4; Errata 2 and 3). Needs approach.s, divide.s,
// and what volume_ball.s or volume_box.s names: volume, the routine that meets one, and volume_at,
// where behind the centre its numbers are.
// A comparison is a subtraction and its sign: what differs by less than 2^-127 is equal.
//   r1  -> the ray, seven words, which becomes one that starts near the volume
//   r2  -> the volume: its centre, and its numbers
//   r3  -> from and to: the cell around it, two words
//   r4  -> key and exit, two words; there two instructions after the return; if the ray misses, they
//          mean nothing
//   r4     then 1 if the ray meets the cell, else 0
//   r14    return address
//   changes r1 to r13, r15 to r20, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
meet:
        *meet_link = r14
        r17 = r1
        r18 = r2
        r19 = r3
        call approach (r14)
        r20 = r4
        r1 = r17
        r2 = r18 + volume_at
        call volume (r14)
        r3 = meet_interval
        r4 - 0
        if (eq) goto meet_ends
        r5 = r19
        r6 = meet_interval
        a0 = *r5
        a1 = *r5++ - *r6                // from before the entry?
        r8 = r20
        *r8++ = a0 = ifalt(*r6)         // the later of the two is the key
        r6 = r6 + 4
        a2 = *r5
        a1 = *r6 - *r5
        *r8 = a2 = ifalt(*r6)           // the earlier of the two is the exit
        a1 = a2 - a0
        r4 = 1
        nop
        nop
        if (alt) goto meet_nothing
        nop
meet_ends:
        r14 = *meet_link
        nop
        return (r14)
        nop
// A flat cell's interval is a point: rounding alone may separate it from its parent's.
meet_nothing:
        r7 = meet_gap
        r9 = meet_slack
        *r7 = a1 = a0 - a2
        a3 = *r9 * a0
        r4 = 0
        nop
        nop
        a1 = *r7 - a3
        nop
        nop
        nop
        if (agt) goto meet_ends
        nop
        *r8 = a0 = a0
        goto meet_ends
        r4 = 1

        .data
meet_slack:
        float 4.76837158203125e-7       // 2^-21
meet_gap:
        float 0.0
meet_interval:
        2*float 0.0
meet_link:
        .word 0
        .text
