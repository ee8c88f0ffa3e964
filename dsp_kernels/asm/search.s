// The first cell that a ray meets: Alg. 12.4 on one object with a complete graph and one volume, as
// intersect() of dsp_kernels/intersect.hpp, bit for bit. Needs child.s, meet.s, cell_heap.s,
// pixel_size.s, diameter.s and what they need; scene.s has its constants.
//   search_ray: the ray, seven words
//   r4     1 if it meets a cell: that is then at cell_heap_top, cell_level and cell_word; else 0
//   r14    return address
//   goes to cell_heap_full if the heap is full, to search_word_full if a word is
//   changes all registers but r14, all accumulators
search:
        *search_link = r14
        r5 = *scene_cell_cap
        r6 = *scene_cell_cap + 2
        r5 = r5 - 1                     // the outermost cell
        if (cc) goto search_starts
        r4 = 0
        r6 = r6 - 1
search_starts:
        *search_left = r5
        *search_left + 2 = r6
        *cell_heap_bytes = r4
        *cell_heap_new_level = r4
        r1 = search_ray
        r2 = *scene_inverse
        r3 = cell_heap_new
        call transform_ray (r14)
        nop
        r5 = scene_constant
        r6 = cell_heap_new + 36
        *r6 = a0 = *r5
        r1 = cell_heap_new
        r2 = scene_volume
        r3 = search_bounds
        call meet (r14)
        r4 = cell_heap_new + 28
        r4 - 0
        if (eq) goto search_ends
        nop
        call cell_heap_put (r14)
        nop
search_next:
        r5 = *cell_heap_bytes
        r4 = 0
        r5 - 0
        if (eq) goto search_ends
        nop
        call cell_heap_take (r14)
        nop
        r5 = *cell_level
        r6 = *scene_levels
        r1 = scene_pixel
        r5 - r6
        if (eq) goto search_hit         // the last level
        r2 = cell_heap_top + 28
        r3 = scene_smallest_pixel
        call pixel_size (r14)
        r4 = search_pixel
        r1 = cell_heap_top + 36
        r2 = scene_diameter
        call diameter (r14)
        r3 = search_diameter
        r5 = scene_detail
        r6 = search_pixel
        a1 = *r5 * *r6
        r7 = search_diameter
        nop
        a0 = -*r7 + a1
        r5 = *cell_level
        nop
        r5 - 200
        if (age) goto search_hit        // no larger than so many pixels
        nop
        if (cc) goto search_word_full
        r6 = *search_left + 2
        r5 = *search_left
        r7 = *scene_maps
        r6 - 0
        if (mi) goto search_capped
        nop
        if (ne) goto search_expands
        nop
        r5 - 0
        if (eq) goto search_capped
        nop
search_expands:
        r5 = r5 - r7
        if (cc) goto search_charged
        *search_left = r5
        r6 = r6 - 1
        *search_left + 2 = r6
search_charged:
        r5 = *cell_level
        r7 = 0
        r6 = r5
        r6 = r6 ^ 1
        r6 = r6 + cell_word             // where the symbol goes
        *search_place = r6
        r8 = r5
        r8 = r8 & 1
        if (ne) goto search_in_low_byte
        r5 = r5 + 1
        r6 = r6 - 1
        *r6 = r7l                       // nothing behind it
search_in_low_byte:
        *cell_heap_new_level = r5
        r21 = 0
search_map:
        r6 = r21 * 2
        r6 = r6 + scene_map_table
        r2 = *r6
        r1 = cell_heap_top
        call child (r14)
        r3 = cell_heap_new
        r1 = cell_heap_new
        r2 = scene_volume
        r3 = cell_heap_top + 28
        call meet (r14)
        r4 = cell_heap_new + 28
        r4 - 0
        if (eq) goto search_not_met
        r6 = *search_place
        nop
        call cell_heap_put (r14)
        *r6 = r21l
search_not_met:
        r6 = *scene_maps
        r21 = r21 + 1
        r21 - r6
        if (ne) goto search_map
        nop
        goto search_next
        nop
search_capped:
        r4 = 1
        *search_was_capped = r4
search_hit:
        r4 = 1
search_ends:
        r14 = *search_link
        nop
        return (r14)
        nop
search_word_full:
        goto search_word_full
        nop

        .data
search_bounds:
        float 0.0, 1e30                 // what counts of a ray: all of it
search_ray:
        7*float 0.0
search_pixel:
        float 0.0
search_diameter:
        float 0.0
search_left:
        .word 0                         // cells that may still be tested
search_place:
        .word 0
search_was_capped:
        .word 0
search_link:
        .word 0
        .text
