{ matrix 1 0.3 0 0 1 0.2 0 0 1 x 2 } box
{ rx 90 y 1 } box
{ x 1 s 2 } box
{ s 2 x 1 } box
{ s 1 2 3 rz 45 } box
box
