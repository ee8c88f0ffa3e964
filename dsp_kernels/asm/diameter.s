// The diameter of a cell: as cell_diameter() of dsp_kernels/diameter.hpp with Lipschitz constants by
// product (Eq. 16.1) or by determinant (Eq. 16.3), bit for bit. Which of the two it is lies in the
// constants that the host broadcasts; a cell has their product.
//   r1  -> the cell's constant
//   r2  -> the diameter of its volume
//   r3  -> the cell's diameter      there four instructions after the return's slot began
//   r14    return address
//   changes a0
//   words and cycles: docs/dsp32.md, "Kernels"
diameter:
        return (r14)
        *r3 = a0 = *r1 * *r2
