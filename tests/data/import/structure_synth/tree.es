set maxdepth 8
tree
rule tree { { y 0.9 s 0.75 rz 25 } tree { y 0.9 s 0.75 rz -25 ry 90 } tree { s 0.2 1 0.2 } box }
