/* The sequential sign test; see sign_test.h. */
#include "bench/measure/sign_test.h"

#include <math.h>

enum sign_decision sign_test_decision(const struct sign_test *test)
{
    if (test->above - test->below >= SIGN_TEST_LEAD)
        return SIGN_ABOVE;
    if (test->below - test->above >= SIGN_TEST_LEAD)
        return SIGN_WITHIN;
    if (test->above + test->below + test->lost >= SIGN_TEST_PAIRS_MAX)
        return SIGN_INCONCLUSIVE;
    return SIGN_OPEN;
}

enum sign_decision sign_test_add(struct sign_test *test, double ratio)
{
    if (sign_test_decision(test) == SIGN_OPEN) {
        if (!isfinite(ratio) || ratio <= 0)
            test->lost++;
        else if (ratio > test->bound)
            test->above++;
        else
            test->below++;
    }
    return sign_test_decision(test);
}
