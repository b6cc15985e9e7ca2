// CHECK: a broken invariant is a bug; it is reported and the program aborts, in release builds too.
#pragma once

namespace quartic {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace quartic

#define CHECK(condition) \
    ((condition) ? static_cast<void>(0) : ::quartic::check_failed(#condition, __FILE__, __LINE__))
