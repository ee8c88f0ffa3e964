4 * { rz 90 x 1 } 3 * { z 1 s 0.9 hue 30 } box
2 * { x 3 } sphere
{ y 3 s 0.5 } sphere
