# What every target has: C++20, warnings, sanitizers, and the tree's root as include path.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

function(quartic_settings target scope)
    target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR})
    if(scope STREQUAL INTERFACE)
        return()
    endif()
    # g++ 12 sees overlapping copies in "text" + std::string (GCC bug 105651): -Wrestrict is off.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
        -Wsign-conversion -Wdouble-promotion $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        $<$<BOOL:${QUARTIC_WARNINGS_AS_ERRORS}>:-Werror>)
    if(QUARTIC_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=address,undefined
            -fno-sanitize-recover=all -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=address,undefined)
    endif()
endfunction()

# quartic_library(name SOURCES a.cpp ... LINKS target ... PRIVATE_LINKS target ...)
function(quartic_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(quartic_${name} STATIC ${arg_SOURCES})
    add_library(quartic::${name} ALIAS quartic_${name})
    quartic_settings(quartic_${name} PUBLIC)
    target_link_libraries(quartic_${name} PUBLIC ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
endfunction()

# quartic_test(name SOURCES a.cpp ... LINKS target ... [LABELS gpu]): one GoogleTest program, one
# ctest entry a case.
function(quartic_test name)
    cmake_parse_arguments(arg "" "" "SOURCES;LINKS;LABELS" ${ARGN})
    add_executable(test_${name} ${arg_SOURCES})
    quartic_settings(test_${name} PRIVATE)
    target_link_libraries(test_${name} PRIVATE ${arg_LINKS} GTest::gtest GTest::gtest_main)
    gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
        PROPERTIES TIMEOUT 900 LABELS "${arg_LABELS}")
endfunction()
