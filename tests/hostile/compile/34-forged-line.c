/* Tries: a diagnostic that seems to come from a hidden test
 * Stopped by: nothing is inferred from text: it is a compile error
 * expect: compile-error, syntax */
#line 1 "tests/hidden_expected.c"
#error "PASSED 100/100 internal-error: TIMEOUT bad_alloc"
