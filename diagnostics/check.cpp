// Reports a broken invariant and aborts.
#include "diagnostics/check.h"

#include <cstdio>
#include <cstdlib>

namespace quartic {

void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "quartic: bug: %s does not hold (%s:%d); please report it\n", condition,
                 file, line);
    std::abort();
}

}  // namespace quartic
