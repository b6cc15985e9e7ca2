// Compiles the shared texts for every real type, so that they are checked even where nobody calls
// them.
#include "primitives/kernel.h"

template struct quartic::Solver<float>;
template struct quartic::Solver<double>;
template struct quartic::Solver<long double>;
template struct quartic::Kernel<float>;
template struct quartic::Kernel<double>;
template struct quartic::Kernel<long double>;
