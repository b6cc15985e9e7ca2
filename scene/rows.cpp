// Rows are handed out one by one: some cost far more than others.
#include "scene/rows.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace quartic {

void for_each_row(int height, const std::function<void(int)>& work,
                  const std::function<bool()>& stop) {
    std::atomic<int> next{0};
    const auto take_rows = [&] {
        for (int y = next++; y < height && !(stop && stop()); y = next++) {
            work(y);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back(take_rows);
    }
    take_rows();
    for (std::thread& thread : threads) {
        thread.join();
    }
}

}  // namespace quartic
