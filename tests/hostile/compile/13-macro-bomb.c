/* Tries: 10^9 tokens of one line
 * Stopped by: the build box: memory, file size or CPU time
 * expect: compile-error, compiler-output */
#define A x x x x x x x x x x
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
#define F E E E E E E E E E E
#define G F F F F F F F F F F
#define H G G G G G G G G G G
H H H H H H H H H H
