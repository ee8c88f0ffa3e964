set maxdepth 60
spiral
rule spiral { { z 0.6 ry 8 rz 3 s 0.97 hue 6 } spiral { s 0.4 1 0.2 color #08f } box }
