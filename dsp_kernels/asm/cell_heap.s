// The heap of cells (Def. 12.1, Erratum 1), 256 of them, the smallest (key, word) on top: as Heap of
// dsp_kernels/heap.hpp with cells of one object. Cells are in z-buffer memory, sixteen to a page of
// 4 KiB, 256 bytes each: ray, key, exit, constant (ten words), level (a word), the word of maps, a
// byte a map. Their keys are there once more, all on one page, the seventeenth. What orders them is
// in fast memory: the addresses of the keys, as halves, which say where the cells are too.
//   bits 8 to 11: the cell's place on its page     bits 2 to 5: its page
// A word of maps has its first map in the higher byte of its first half, and zeros behind the last:
// compared half by half, words are in their order.
// A comparison is a subtraction and its sign: keys that differ by less than 2^-127 are equal.
//   cell_heap_start: puts the heap in order; once
//   cell_heap_clear: makes it empty
//   cell_heap_put:   adds the cell at cell_heap_new, whose level is at cell_heap_new_level and whose
//                    word is at cell_word; goes to cell_heap_full if there are 256
//   cell_heap_take:  brings the smallest one to cell_heap_top, cell_level and cell_word; the caller
//                    sees to it that there is one
//   cell_heap_bytes: twice the cells there are, a half
//   r14    return address
//   changes r1 to r13, r15 to r20, a0 to a2
//   words and cycles: docs/dsp32.md, "Kernels"
.equ cell_heap_window, 0xb000
.equ cell_heap_page, 0xf002             // which 4 KiB of the z-buffer the window shows
.equ cell_heap_keys_page, 16
.equ cell_heap_slots, 256
.equ cell_bytes_of_numbers, 40

cell_heap_start:
        r1 = cell_heap_order
        r2 = cell_heap_window
        r4 = 14
cell_heap_place:
        r3 = 14
cell_heap_page_of_place:
        *r1++ = r2
        if (r3-- >= 0) goto cell_heap_page_of_place
        r2 = r2 + 4
        r2 = r2 + 192
        if (r4-- >= 0) goto cell_heap_place
        nop
cell_heap_clear:
        r1 = 0
        return (r14)
        *cell_heap_bytes = r1

cell_heap_put:
        r5 = *cell_heap_bytes
        r13 = cell_heap_order
        r7 = r13
        r5 - 2 * cell_heap_slots
        if (eq) goto cell_heap_full
        r7 = r7 + r5
        r4 = *r7                        // its key's address
        r1 = cell_heap_new
        r8 = r4
        r8 = r8 & 0x3c
        r8 = r8 >> 1
        r8 = r8 >> 1
        r9 = r4
        r9 = r9 & 0xff00
        *cell_heap_page = r8
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        *r9++ = a1 = *r1++              // the key
        *r9++ = a0 = *r1++
        *r9++ = a0 = *r1++
        r10 = *cell_heap_new_level
        r2 = cell_word
        *r9++ = r10
        r9 = r9 + 2
        r10 = r10 + 1
        r10 = r10 >> 1                  // halves of the word
        if (eq) goto cell_heap_put_key
        r10 = r10 - 2
cell_heap_put_word:
        r11 = *r2++
        if (r10-- >= 0) goto cell_heap_put_word
        *r9++ = r11
cell_heap_put_key:
        r8 = cell_heap_keys_page
        *cell_heap_page = r8
        *r4 = a1 = a1
        r9 = r5 + 2
        *cell_heap_bytes = r9
cell_heap_rise:
        r5 - 0
        if (eq) goto cell_heap_risen
        r9 = r5 - 2                     // above it: (place - 1) / 2, places times two
        r9 = r9 >> 1
        r9 = r9 & 0xfffe
        r10 = r13
        r10 = r10 + r9
        r11 = *r10
        nop
        a0 = a1 - *r11
        r1 = r4
        r2 = r11
        nop
        if (alt) goto cell_heap_above
        nop
        if (ane) goto cell_heap_risen
        nop
        call cell_heap_tie (r12)
        nop
        r8 - 0
        if (eq) goto cell_heap_risen
        nop
cell_heap_above:
        *r7 = r11                       // goes one down
        r7 = r10
        goto cell_heap_rise
        r5 = r9
cell_heap_risen:
        return (r14)
        *r7 = r4

cell_heap_take:
        r5 = *cell_heap_bytes
        r13 = cell_heap_order
        r5 = r5 - 2
        *cell_heap_bytes = r5           // one less
        r3 = *r13
        r1 = r13
        r1 = r1 + r5
        r4 = *r1                        // the last one, which will find its place
        nop
        *r1 = r3                        // and the place of the first one is free
        r8 = r3
        r8 = r8 & 0x3c
        r8 = r8 >> 1
        r8 = r8 >> 1
        r9 = r3
        r9 = r9 & 0xff00
        *cell_heap_page = r8
        r1 = cell_heap_top
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        *r1++ = a0 = *r9++
        r10 = *r9++
        r2 = cell_word
        r9 = r9 + 2
        *cell_level = r10
        r10 = r10 + 1
        r10 = r10 >> 1
        if (eq) goto cell_heap_taken
        r10 = r10 - 2
cell_heap_take_word:
        r11 = *r9++
        if (r10-- >= 0) goto cell_heap_take_word
        *r2++ = r11
cell_heap_taken:
        r8 = cell_heap_keys_page
        r5 - 0
        if (eq) goto cell_heap_sunk
        r7 = r13
        *cell_heap_page = r8
        a1 = *r4
        r6 = 0                          // the place that is free, times two
cell_heap_sink:
        r9 = r6 * 2
        r9 = r9 + 2                     // the first below it
        r9 - r5
        if (cc) goto cell_heap_sunk     // there is none
        r10 = r13
        r10 = r10 + r9
        r11 = *r10
        r8 = r9 + 2                     // the second
        r8 - r5
        if (cc) goto cell_heap_smaller
        r2 = r10 + 2
        r3 = *r2
        nop
        a0 = *r3 - *r11
        r1 = r3
        r2 = r11
        nop
        if (alt) goto cell_heap_second
        nop
        if (ane) goto cell_heap_smaller
        nop
        call cell_heap_tie (r12)
        nop
        r8 - 0
        if (eq) goto cell_heap_smaller
        nop
cell_heap_second:
        r11 = r3
        r10 = r10 + 2
        r9 = r9 + 2
cell_heap_smaller:
        nop
        a0 = a1 - *r11
        r1 = r4
        r2 = r11
        nop
        if (alt) goto cell_heap_sunk
        nop
        if (ane) goto cell_heap_below
        nop
        call cell_heap_tie (r12)
        nop
        r8 - 0
        if (ne) goto cell_heap_sunk
        nop
cell_heap_below:
        *r7 = r11                       // goes one up
        r7 = r10
        goto cell_heap_sink
        r6 = r9
cell_heap_sunk:
        return (r14)
        *r7 = r4

// r8 becomes 1 if the word of the cell whose key is at r1 is before that at r2, else 0. Through r12.
cell_heap_tie:
        r15 = r1 + 0
        r15 = r15 & 0x3c
        r15 = r15 >> 1
        r15 = r15 >> 1
        r16 = r2 + 0
        r16 = r16 & 0x3c
        r16 = r16 >> 1
        r16 = r16 >> 1
        r1 = r1 & 0xff00
        r2 = r2 & 0xff00
        r1 = r1 + cell_bytes_of_numbers
        r2 = r2 + cell_bytes_of_numbers
        *cell_heap_page = r15
        r17 = *r1++
        *cell_heap_page = r16
        r18 = *r2++
        r1 = r1 + 2
        r2 = r2 + 2
        r19 = r17 + 0                   // the shorter one's length
        r17 - r18
        if (cs) goto cell_heap_shorter
        nop
        r19 = r18 + 0
cell_heap_shorter:
        r19 = r19 + 1
        r19 = r19 >> 1
        if (eq) goto cell_heap_by_length
        r19 = r19 - 2
cell_heap_half:
        *cell_heap_page = r15
        r8 = *r1++
        *cell_heap_page = r16
        r20 = *r2++
        nop
        r8 - r20
        if (ne) goto cell_heap_differ
        nop
        if (r19-- >= 0) goto cell_heap_half
        nop
cell_heap_by_length:
        r17 - r18
cell_heap_differ:
        if (cs) goto cell_heap_tie_ends
        r8 = 1
        r8 = 0
cell_heap_tie_ends:
        r15 = cell_heap_keys_page
        return (r12)
        *cell_heap_page = r15

        .data
cell_heap_bytes:
        .word 0
cell_heap_new_level:
        .word 0
cell_level:
        .word 0
cell_heap_new:
        10*float 0.0
cell_heap_top:
        10*float 0.0
cell_word:
        50*.word 0
cell_heap_order:
        256*int 0
        .text
