set maxdepth 40
set background #fff
#define size 0.5
rule cell w 2 md 12 > leaf {
  { s size x 1 rz 30 h 12 sat 0.9 b 0.8 a 0.5 color red } cell
  3 * { y 1 rx 90 } 2 * { z 0.5 fx } box
}
rule leaf { sphere }
{ m 1 0 0 0 1 0 0 0 1 } cell
