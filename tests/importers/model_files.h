// Where the real files lie, for tests that need one.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace quartic {

// The path of a file of the test data, or empty where it is absent.
inline std::string test_data(const std::string& name) {
    const char* folder = std::getenv("QUARTIC_TEST_DATA");
    const std::filesystem::path root =
        folder != nullptr ? std::filesystem::path(folder)
                          : std::filesystem::path(QUARTIC_SOURCE_DIR) / ".." / "shared" / "data";
    const std::filesystem::path path = root / name;
    return std::filesystem::exists(path) ? path.string() : std::string();
}

}  // namespace quartic

#define SKIP_WITHOUT(path)                                                                  \
    if ((path).empty()) {                                                                   \
        GTEST_SKIP() << "SKIPPED: NO TEST DATA; set QUARTIC_TEST_DATA to the folder of it"; \
    }
