// What a benchmark found: rows under described columns, and the conditions they were measured
// under; written as JSON, CSV, Markdown or plain text.
#pragma once

#include "bench/plot.h"
#include "scene/camera.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace quartic {

// Benchmarks measure the wall's time until the GPU has finished: timers of software renderers lie.
struct Conditions {
    std::string renderer;  // as OpenGL names it; empty: nothing was drawn
    bool software = false;
    PixelSize size;  // of the pictures; 0: none
    int rounds = 0;
};

struct Column {
    std::string key;                 // of the rows
    std::string title;               // in tables for people; empty: only in JSON and CSV
    std::vector<std::string> parts;  // of a column of lists: what the elements are
};

struct Table {
    std::string key;    // in JSON; empty: another look at the rows, for people alone
    std::string title;  // empty for the rows themselves
    std::vector<Column> columns;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
};

struct Report {
    std::string bench;
    Conditions conditions;
    std::vector<Table> tables;  // the first one holds the rows
    std::vector<std::string> notes;
    Plot plot;
};

// "llvmpipe (software), 1024x1024, wall clock, median of 9 rounds"
std::string as_text(const Conditions& conditions);

nlohmann::ordered_json as_json(const Report& report);  // without the schema's version
std::string as_csv(const Report& report);              // the rows, and the conditions in each
std::string as_markdown(const Report& report);
std::string as_text(const Report& report);

}  // namespace quartic
