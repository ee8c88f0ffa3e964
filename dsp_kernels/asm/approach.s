// A ray with its origin moved to its closest approach to a point: as rebase() of
// dsp_kernels/ray.hpp, bit for bit. Needs divide.s.
//   r1  -> the ray: origin, direction, base, seven words; it is changed there, all of it there one
//          instruction after the return
//   r2  -> the point, three words
//   r14    return address
//   changes r1 to r7, r11 to r13, a0 to a3, and its scratch words
//   words and cycles: docs/dsp32.md, "Kernels"
approach:
        r13 = r14
        r12 = r1
        r3 = approach_numbers
        *r3++ = a0 = *r2++ - *r1++      // from the origin to the point
        *r3++ = a0 = *r2++ - *r1++
        *r3++ = a0 = *r2++ - *r1++
        r11 = r1                        // the direction
        r6 = r1
        a1 = *r6++ * *r6                // its square: the second operand is read first
        a1 = a1 + *r6++ * *r6
        r4 = approach_length2
        *r4 = a1 = a1 + *r6++ * *r6
        r5 = approach_numbers
        a0 = *r5++ * *r1++              // how far along it the point lies
        a0 = a0 + *r5++ * *r1++
        *r3 = a0 = a0 + *r5 * *r1
        r1 = approach_along
        r2 = approach_length2
        call divide (r14)
        r3 = approach_step
        r6 = r12
        r7 = r12
        a0 = a2 * *r11++                // the step, which the quotient left in a2
        a1 = a2 * *r11++
        a3 = a2 * *r11++
        *r7++ = a0 = *r6++ + a0
        *r7++ = a1 = *r6++ + a1
        *r7 = a3 = *r6 + a3
        *r11 = a0 = *r11 + a2           // the base
        return (r13)
        nop

        .data
approach_numbers:
        3*float 0.0
approach_along:
        float 0.0
approach_length2:
        float 0.0
approach_step:
        float 0.0
        .text
