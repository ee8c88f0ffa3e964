// Where a ray that was re-based to the centre of a ball enters and leaves it: as intersect_sphere()
// of dsp_kernels/volume_sphere.hpp, bit for bit. Needs divide.s and square_root.s.
//   r1  -> the ray: origin, direction, base, seven words
//   r2  -> the ball: centre and radius, four words
//   r3  -> entry and exit, two words; as they were if the ray misses
//   r4     1 if the ray meets the ball, else 0
//   r14    return address
//   changes r1 to r13, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
ball:
        r13 = r14
        r12 = r3
        r4 = ball_perpendicular
        r5 = ball_perpendicular
        *r4++ = a0 = *r1++ - *r2++      // what is left of (origin - centre)
        *r4++ = a0 = *r1++ - *r2++
        *r4++ = a0 = *r1++ - *r2++
        r6 = r1                         // the direction
        r11 = r1 + 12                   // the base
        a0 = *r5++ * *r5                // the miss, squared: the second operand is read first
        a0 = a0 + *r5++ * *r5
        a0 = a0 + *r5++ * *r5
        r10 = ball_numbers
        *r10++ = a1 = *r2 * *r2         // the radius, squared
        a2 = *r6++ * *r6                // the direction, squared
        a2 = a2 + *r6++ * *r6
        *r10-- = a2 = a2 + *r6++ * *r6
        nop
        *r10 = a1 = *r10 - a0           // half the chord, squared; without guard bits both
        r1 = ball_numbers
        r2 = ball_numbers + 4
        nop
        if (alt) goto ball_missed
        r4 = 0
        call divide (r14)
        r3 = ball_numbers + 8
        r1 = ball_numbers + 8
        call square_root (r14)
        r2 = ball_numbers
        r1 = ball_numbers
        *r12++ = a0 = *r11 - *r1        // entry and exit: the base, half a chord on either side
        *r12 = a0 = *r11 + *r1
        return (r13)
        r4 = 1
ball_missed:
        return (r13)
        nop

        .data
ball_perpendicular:
        3*float 0.0
ball_numbers:
        3*float 0.0
        .text
