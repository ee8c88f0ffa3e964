set maxdepth 7
R
rule R {
{ s 1/3 x -1 y -1 z -1 } R
{ s 1/3 x 1 y -1 z -1 } R
{ s 1/3 x 0 y 1 z 1 rx 30 } R
box
}
