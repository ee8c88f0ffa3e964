// Boxes in axes as the volumes of cells: what the node program calls a volume, its numbers and its
// normal. Needs box.s, divide.s, normalize.s, scene.s, scene_block.s, walk.s and what they need;
// box.s and scene_block.s above it.
// A comparison is a subtraction and its sign: what differs by less than 2^-127 is equal.
.equ volume, box
.equ volume_at, 12                      // from the centre to the corners
.equ corner_words, 6
// As read_scene, and the corners.
//   r14    return address
//   changes r1 to r5, a0
read_volume:
        *volume_link = r14
        call read_scene (r14)
        nop
        r3 = r1 + set_low
        r2 = scene_volume + volume_at
        r4 = corner_words - 2
volume_copy:
        if (r4-- >= 0) goto volume_copy
        *r2++ = a0 = *r3++
        r14 = *volume_link
        nop
        return (r14)
        nop
// The normal of the face through which the ray enters a cell's box or leaves it: of the slabs'
// entries the last, of their exits the first; as box_normal() of dsp_kernels/volume_box.hpp and
// normalize(), bit for bit.
//   r10 -> where it enters, walk_interval, or where it leaves, the word behind
//   r19 -> the ray: origin, direction, base, seven words
//   r14    return address
//   volume_vector: the unit vector, there three instructions after the return
//   changes r1 to r13, a0 to a3
volume_normal:
        *volume_link = r14
        r1 = box_far
        r3 = volume_best
        r10 - walk_interval
        if (eq) goto volume_faces       // later than anything is late
        *r3 = a0 = -*r1
        *r3 = a0 = *r1                  // earlier than anything is early
volume_faces:
        r1 = volume_zero
        r13 = volume_vector
        *r13++ = a0 = *r1
        *r13++ = a0 = *r1
        *r13 = a0 = *r1
        r13 = volume_vector
        r8 = r19
        r9 = scene_volume + volume_at   // the low corner; the high one is 12 bytes behind
        r12 = 1
volume_face:
        r2 = r8 + 12                    // along an axis: the direction
        a0 = *r2
        r1 = volume_way
        r3 = volume_face_at
        r4 = volume_best
        if (aeq) goto volume_next_face  // parallel to the slab
        nop
        if (agt) goto volume_forward
        r10 - walk_interval
        if (eq) goto volume_high_face   // against the axis the high face is the first
        nop
volume_low_face:
        r5 = r9
        goto volume_has_face
        r11 = volume_minus_one
volume_forward:
        if (eq) goto volume_low_face
        nop
volume_high_face:
        r5 = r9 + 12
        r11 = volume_one
volume_has_face:
        *r1 = a0 = *r5 - *r8
        call divide (r14)
        nop
        r4 = volume_best
        r10 - walk_interval
        if (eq) goto volume_enters
        nop
        a0 = *r3 - *r4
        goto volume_compared
        nop
volume_enters:
        a0 = *r4 - *r3
        nop
        nop
volume_compared:
        nop
        if (age) goto volume_next_face
        nop
        *r4 = a0 = *r3
        r5 = volume_vector
        r1 = volume_zero
        *r5++ = a0 = *r1
        *r5++ = a0 = *r1
        *r5 = a0 = *r1
        *r13 = a0 = *r11
volume_next_face:
        r8 = r8 + 4
        r9 = r9 + 4
        if (r12-- >= 0) goto volume_face
        r13 = r13 + 4
        r14 = *volume_link
        r1 = volume_vector
        goto normalize
        r2 = volume_vector

        .data
scene_volume:
        9*float 0.0                     // centre, low corner, high corner
volume_vector:
        3*float 0.0
volume_zero:
        float 0.0
volume_one:
        float 1.0
volume_minus_one:
        float -1.0
volume_best:
        float 0.0                       // where the face that counts is
volume_way:
        float 0.0
volume_face_at:
        float 0.0
volume_link:
        .word 0
        .text
