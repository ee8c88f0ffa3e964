// A heap of cells by their keys, the smallest on top: as Heap of dsp_kernels/heap.hpp orders cells
// of different keys (Def. 12.1, Erratum 1). The keys are in z-buffer memory, a word a slot, seen
// through its window; their order, 256 slots at most, is in fast memory, as there, but in halves.
//   heap_push: r1 -> the key           it goes to the first free slot
//              r4    its slot; the caller sees to it that the heap is not full
//   heap_pop:  r4    the slot of the smallest key; the caller sees to it that the heap is not empty
//   heap_clear: makes the heap empty
//   r14    return address
//   changes r1 to r13, a0
//   words and cycles: docs/dsp32.md, "Kernels"
.equ heap_keys, 0xb000                  // the window on the z-buffer
.equ heap_slots, 256

heap_clear:
        r1 = heap_order
        r2 = 0
        r3 = heap_slots - 2
        *heap_bytes = r2
heap_number:
        *r1++ = r2
        if (r3-- >= 0) goto heap_number
        r2 = r2 + 1
        return (r14)
        nop

// Places are numbered from 0 and kept times two, as the halves of the order lie.
heap_push:
        r5 = *heap_bytes                // the place behind the last
        r13 = heap_order
        r6 = heap_keys
        r7 = r13
        r7 = r7 + r5
        r4 = *r7                        // its slot
        nop
        r8 = r4 * 2
        r8 = r8 * 2
        r8 = r8 + r6
        *r8 = a0 = *r1                  // the key
        r9 = r5 + 2
        *heap_bytes = r9
heap_up:
        r5 - 0
        if (eq) goto heap_up_ends
        r9 = r5 - 2                     // above it: (place - 1) / 2
        r9 = r9 / 2
        r9 = r9 & 0xfffe
        r10 = r13
        r10 = r10 + r9
        r11 = *r10                      // the slot above
        nop
        r12 = r11 * 2
        r12 = r12 * 2
        r12 = r12 + r6
        a0 = *r1 - *r12
        nop
        nop
        nop
        if (age) goto heap_up_ends      // not before it: there it stays
        nop
        *r7 = r11                       // else they change places
        *r10 = r4
        r7 = r10
        goto heap_up
        r5 = r9
heap_up_ends:
        return (r14)
        nop

heap_pop:
        r5 = *heap_bytes
        r13 = heap_order
        r5 = r5 - 2
        *heap_bytes = r5                // one less
        r1 = r13
        r1 = r1 + r5
        r4 = *r13                       // the top's slot goes where the last was
        r2 = *r1                        // whose slot goes to the top
        r6 = heap_keys
        *r1 = r4
        *r13 = r2
        r7 = 0                          // the place that is looked at
heap_down:
        r8 = r7                         // the smallest of three
        r9 = r7 * 2
        r9 = r9 + 2                     // the first below it
        r9 - r5
        if (cc) goto heap_down_ends     // there is none
        nop
        call heap_smaller (r3)
        nop
        r9 = r9 + 2                     // the second
        r9 - r5
        if (cc) goto heap_one_below
        nop
        call heap_smaller (r3)
        nop
heap_one_below:
        r8 - r7
        if (eq) goto heap_down_ends
        r10 = r13
        r10 = r10 + r7
        r11 = r13
        r11 = r11 + r8
        r1 = *r10
        r2 = *r11
        r7 = r8
        *r11 = r1
        goto heap_down
        *r10 = r2
heap_down_ends:
        return (r14)
        nop

// r8 becomes r9 if the key at place r9 is before that at r8. Through r3.
heap_smaller:
        r10 = r13
        r10 = r10 + r9
        r11 = r13
        r11 = r11 + r8
        r1 = *r10
        r2 = *r11
        r1 = r1 * 2
        r2 = r2 * 2
        r1 = r1 * 2
        r2 = r2 * 2
        r1 = r1 + r6
        r2 = r2 + r6
        a0 = *r1 - *r2
        nop
        nop
        nop
        if (age) goto heap_not_smaller
        nop
        r8 = r9
heap_not_smaller:
        return (r3)
        nop

        .data
heap_bytes:
        .word 0                         // of the order in use
heap_order:
        256*int 0
        .text
