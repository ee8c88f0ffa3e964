#define STEP 0.8
#define TURN 17
set maxdepth 15
p
rule p { { x STEP ry TURN rx TURN s 0.95 } q { color #fa0 sat 0.7 brightness 0.9 } box }
rule q { { y STEP rz TURN hue 20 } p { s 0.5 } box }
