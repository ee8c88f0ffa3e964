set maxdepth 40
2 * { ry 180 hue 180 } arm
rule arm { { s 0.9 x 0.9 rz 12 hue 5 } arm  { s 1 0.3 0.3 } box }
