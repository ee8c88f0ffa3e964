// What a program keeps of the scene block in fast memory: one object, the centre of its volume and
// the word behind it, where its maps lie. Needs scene_block.s, and scene_volume of volume_ball.s or
// volume_box.s.
//   r1  -> the follow set's record, when it returns
//   r14    return address
//   changes r1 to r5, a0
read_scene:
        r1 = *block_objects
        r3 = block_pixel
        r1 = r1 * 2
        r1 = r1 * 2
        r1 = r1 + block
        *scene_object = r1
        r2 = r1 + object_inverse
        *scene_inverse = r2
        r2 = scene_pixel
        *r2++ = a0 = *r3++
        *r2 = a0 = *r3
        r2 = scene_detail
        r3 = block_detail
        *r2 = a0 = *r3
        r2 = scene_constant
        r3 = r1 + object_constant
        *r2 = a0 = *r3
        r2 = scene_smallest_pixel
        r3 = r1 + object_smallest_pixel
        *r2 = a0 = *r3
        r2 = scene_diffuse
        r3 = r1 + object_diffuse
        *r2 = a0 = *r3
        r4 = *block_cell_cap
        r5 = *block_cell_cap + 2
        *scene_cell_cap = r4
        *scene_cell_cap + 2 = r5
        r3 = r1 + object_levels
        r4 = *r3++
        r5 = *r3
        nop
        r5 - 0
        if (eq) goto scene_few_levels
        nop
        r4 = 0xffff                     // more than a word has
scene_few_levels:
        *scene_levels = r4
        r1 = *r1                        // the set that it starts with
        nop
        r1 = r1 * 2
        r1 = r1 * 2
        r1 = r1 + block
        r2 = scene_volume
        r3 = r1 + set_center
        *r2++ = a0 = *r3++
        *r2++ = a0 = *r3++
        *r2++ = a0 = *r3++
        *r2 = a0 = *r3
        r2 = scene_diameter
        r3 = r1 + set_diameter
        *r2 = a0 = *r3
        r3 = r1 + set_map_count
        r4 = *r3
        r2 = scene_map_table
        *scene_maps = r4
        r4 = r4 - 2
        r3 = r1 + set_maps
scene_map:
        r5 = *r3++
        r3 = r3 + 2
        r5 = r5 * 2
        r5 = r5 * 2
        r5 = r5 + block
        if (r4-- >= 0) goto scene_map
        *r2++ = r5
        return (r14)
        nop

        .data
scene_object:
        .word 0
scene_inverse:
        .word 0
scene_maps:
        .word 0
scene_levels:
        .word 0
scene_cell_cap:
        .word 0
scene_constant:
        float 0.0
scene_smallest_pixel:
        float 0.0
scene_diffuse:
        float 0.0
scene_diameter:
        float 0.0
scene_detail:
        float 0.0
scene_pixel:
        2*float 0.0
scene_map_table:
        256*int 0
        .text
