// How fast the processor is: transforms a ray and meets a ball with it, 1,000,000 times.
//   pxm asm bench/rays.s dsp_kernels/asm/{transform_ray,ball,divide,square_root}.s --run start \
//       --steps 1000000000
// docs/measurements/node-instructions.md has what it took.
start:
        r19 = r14
        r18 = 999
outer:
        r17 = 999
inner:
        r1 = ray
        r2 = map
        call transform_ray (r14)
        r3 = moved
        r1 = moved
        r2 = ball_shape
        call ball (r14)
        r3 = interval
        r17 = r17 - 1
        if (pl) goto inner
        nop
        r18 = r18 - 1
        if (pl) goto outer
        nop
        return (r19)
        nop

        .data
ray:        float 0.3, -0.2, 4.0, 0.1, 0.2, -0.97, 0.0
map:        float 2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0, -0.5, 0.25, -7.9
moved:      7*float 0.0
ball_shape: float 0.1, 0.15, 0.1, 0.9
interval:   2*float 0.0
        .text
