3 * { x 2 rz 15 } 2 * { y 1.5 ry 20 s 0.8 } box
{ fx x 1.5 } part
{ fz y -1 rx 40 } part
rule part { { s 0.5 1 2 } box { x 1 ry 30 } box }
