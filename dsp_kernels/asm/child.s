// The cell of a map inside a cell, its ray and its constant: as child_cell() of
// dsp_kernels/descend.hpp, bit for bit. The inverse maps are multiplied on the ray, from the left:
// (o M^-1) W_i^-1. Needs transform_ray.s and scene_block.s.
//   r1  -> the cell: ray, key, exit, constant, ten words
//   r2  -> the map's record
//   r3  -> the child, ten words: its ray, and its constant, which is there four instructions after
//          the return's slot began; key and exit stay as they were
//   r14    return address
//   changes r1 to r6, r10 to r13, r15, r16, a0 to a3
//   words and cycles: docs/dsp32.md, "Kernels"
.equ cell_constant_at, 36
child:
        r13 = r14
        r12 = r1
        r11 = r2
        r10 = r3
        call transform_ray (r14)
        r2 = r2 + map_inverse
        r4 = r12 + cell_constant_at
        r5 = r11 + map_constant
        r6 = r10 + cell_constant_at
        return (r13)
        *r6 = a0 = *r4 * *r5
