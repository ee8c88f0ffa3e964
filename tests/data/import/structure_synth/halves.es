rule cube maxdepth 3 > box {
    { s 1/2 x -0.5 } cube   { s 1/2 x 0.5 } cube
}
cube
