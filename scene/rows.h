// Shares a picture's rows out among the machine's threads.
#pragma once

#include <functional>

namespace quartic {

// Calls work(y) once for every row, from several threads, and returns when all are done. Where
// stop() says so, rows that have not begun are left out.
void for_each_row(int height, const std::function<void(int)>& work,
                  const std::function<bool()>& stop = {});

}  // namespace quartic
