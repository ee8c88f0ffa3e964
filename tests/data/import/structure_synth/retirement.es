R1
rule R1 maxdepth 5 > R2 { { x 1.1 rz 10 } R1 { s 0.8 } box }
rule R2 maxdepth 4 { { y 1.1 rx 20 } R2 { s 0.6 } box }
