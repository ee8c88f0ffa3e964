// The program of a pixel node: for each of its pixels eye rays, the first cell along each, its shade,
// and the colour to the front buffer. As pixel_program() of dsp_kernels/pixel_program.hpp, bit for
// bit, for what docs/dsp32.md, "The node program", says. Needs all files of this folder but heap.s, and
// of volume_ball.s and volume_box.s one, with what it needs.
//   share: which pixels, set by the host; the program returns when they are done
//   r14    return address
// What the emulator looks at, at these labels, takes no time of the node:
//   program_sample_done: r21 is 1 if a cell was met; program_pixel_done: program_color, program_alpha
.equ front_window, 0xd000
.equ front_window_end, 0xe000
.equ front_page, 0xf006                 // which 4 KiB of the front buffer the window shows
.equ front_page_bytes, 4096
program:
        *program_link = r14
        call cell_heap_start (r14)
        nop
        call read_volume (r14)
        nop
        r1 = *share_page
        r2 = *share_y
        *front_page = r1
program_row:
        *program_y = r2
        r1 = *share_x
        nop
program_pixel:
        *program_x = r1
        r2 = *block_samples
        r3 = *block_sample_count
        r2 = r2 * 2
        r2 = r2 * 2
        r2 = r2 + block
        *program_place = r2
        *program_samples = r3
        r1 = program_color
        r2 = program_zero
        *r1++ = a0 = *r2
        *r1++ = a0 = *r2
        *r1++ = a0 = *r2
        *r1 = a0 = *r2                  // and nothing that hides the background
program_sample:
        r1 = program_x
        r2 = *program_place
        r4 = 0
        *search_was_capped = r4
        call eye_ray (r14)
        r3 = search_ray
        call search (r14)
        nop
        r4 - 0
        if (eq) goto program_missed
        r1 = block_background
        call walk (r14)
        nop
        r1 = walk_normal
        r2 = walk_color
        r3 = scene_diffuse
        call lambert (r14)
        r4 = program_light
        r3 = program_alpha
        r4 = block_sample_share
        *r3 = a0 = *r3 + *r4
        r21 = 1
        goto program_sample_done
        r1 = program_light
program_missed:
        r21 = 0
program_sample_done:
        r2 = block_sample_share
        r3 = program_color
        r4 = program_color
        a0 = *r2 * *r1++
        a1 = *r2 * *r1++
        a2 = *r2 * *r1
        *r4++ = a0 = *r3++ + a0
        *r4++ = a1 = *r3++ + a1
        *r4 = a2 = *r3 + a2
        r1 = *program_place
        r2 = *program_samples
        r1 = r1 + 8
        *program_place = r1
        r2 = r2 - 1
        if (ne) goto program_sample
        *program_samples = r2
program_pixel_done:
        r2 = program_bytes
        r3 = program_one
        r4 = program_255
        r5 = program_zero
        r6 = 2
        r1 = program_color              // and alpha behind it
program_byte:
        a0 = *r1
        a1 = -*r5 + *r1
        a0 = ifalt(*r5)                 // no less than 0
        a1 = *r3 - *r1++
        a0 = ifalt(*r3)                 // and no more than 1
        nop
        nop
        a1 = *r4 * a0
        if (r6-- >= 0) goto program_byte
        *r2++ = a1 = int(a1)
        r1 = program_bytes
        r5 = *share_at
        nop
        nop
        r6h = *r1                       // red and green, then blue and alpha
        r1 = r1 + 2
        r7l = *r1
        r1 = r1 + 2
        r8h = *r1
        r6 = r6 | r7
        r1 = r1 + 2
        r9l = *r1
        r3 = r5 + 2
        r8 = r8 | r9
        *r5 = r8
        *r3 = r6
        r5 = r5 + 4
        *share_at = r5
        r5 - front_window_end
        if (ne) goto program_next
        nop
        call program_turn_page (r14)
        nop
program_next:
        r1 = *program_x
        r2 = *share_step_x
        r3 = *share_end_x
        r1 = r1 + r2
        r1 - r3
        if (cs) goto program_pixel
        nop
        // to the next row of the window
        r5 = *share_at
        r1 = *share_skip_bytes
        r2 = *share_skip_pages
        r5 = r5 + r1
        r4 = *front_page
        *share_at = r5
        r4 = r4 + r2
        *front_page = r4
        r5 - front_window_end
        if (cs) goto program_next_row
        nop
        call program_turn_page (r14)
        nop
program_next_row:
        r1 = *program_y
        r2 = *share_step_y
        r3 = *share_end_y
        r2 = r2 + r1
        r2 - r3
        if (cs) goto program_row
        nop
        r14 = *program_link
        nop
        return (r14)
        nop
// The front buffer's next page: share_at is r5, less a page.
program_turn_page:
        r4 = *front_page
        r5 = r5 - front_page_bytes
        *share_at = r5
        r4 = r4 + 1
        return (r14)
        *front_page = r4
// More cells than the heap holds: the emulator stops here.
cell_heap_full:
        goto cell_heap_full
        nop

        .data
// Halves: pixels from (x, y) on, by steps, before the ends; where in the front buffer the first one
// goes, its page and its address in the window; what to skip there between two rows.
share_x:
        int 0
share_y:
        int 0
share_end_x:
        int 0
share_end_y:
        int 0
share_step_x:
        int 0
share_step_y:
        int 0
share_page:
        int 0
share_at:
        int 0
share_skip_pages:
        int 0
share_skip_bytes:
        int 0
program_x:
        int 0
program_y:
        int 0
program_place:
        .word 0
program_samples:
        .word 0
program_link:
        .word 0
program_zero:
        float 0.0
program_one:
        float 1.0
program_255:
        float 255.0
program_color:
        3*float 0.0
program_alpha:
        float 0.0
program_light:
        3*float 0.0
program_bytes:
        4*int 0
        .text
