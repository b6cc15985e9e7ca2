// Writes reports.
#include "bench/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <sstream>

namespace quartic {
namespace {

using nlohmann::ordered_json;

using Cells = std::vector<std::string>;

// A number with so many digits; nothing for what was not measured.
std::string cell(const ordered_json& value, int digits) {
    if (value.is_null()) {
        return {};
    }
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (!value.is_number_float()) {
        return value.dump();
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value.get<double>());
    return text.data();
}

ordered_json value_of(const ordered_json& row, const std::string& key) {
    const auto found = row.find(key);
    return found == row.end() ? ordered_json() : *found;
}

Cells cells_of(const ordered_json& row, const Column& column, int digits) {
    const ordered_json value = value_of(row, column.key);
    if (column.parts.empty()) {
        return {value.is_array() ? std::string() : cell(value, digits)};
    }
    Cells cells;
    for (std::size_t i = 0; i < column.parts.size(); ++i) {
        const bool known = value.is_array() && i < value.size();
        cells.push_back(known ? cell(value[i], digits) : std::string());
    }
    return cells;
}

void append(Cells& to, const Cells& from) {
    to.insert(to.end(), from.begin(), from.end());
}

// The heads of a table for people, then its lines.
std::vector<Cells> grid_of(const Table& table) {
    std::vector<Cells> lines(1);
    for (const Column& column : table.columns) {
        if (!column.title.empty() && column.parts.empty()) {
            lines[0].push_back(column.title);
        } else if (!column.title.empty()) {
            for (const std::string& part : column.parts) {
                lines[0].push_back(column.title + " " + part);
            }
        }
    }
    for (const ordered_json& row : table.rows) {
        Cells& line = lines.emplace_back();
        for (const Column& column : table.columns) {
            if (!column.title.empty()) {
                append(line, cells_of(row, column, 4));
            }
        }
    }
    return lines;
}

// RFC 4180: what holds a comma, a quote or a line's end is quoted.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + "\"";
}

std::string csv_line(const Cells& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        line += (i == 0 ? "" : ",") + quoted(cells[i]);
    }
    return line + "\n";
}

std::string size_text(PixelSize size) {
    return size.width == 0 ? std::string()
                           : std::to_string(size.width) + "x" + std::to_string(size.height);
}

// A bar would end the cell, a line's end the table.
std::string markdown_line(const Cells& cells) {
    std::string line = "|";
    for (const std::string& text : cells) {
        line += " ";
        for (const char c : text) {
            line += c == '|' ? "\\|" : std::string(1, c == '\n' ? ' ' : c);
        }
        line += " |";
    }
    return line + "\n";
}

std::string markdown_table(const std::vector<Cells>& lines) {
    std::string text = markdown_line(lines[0]) + "|";
    for (std::size_t i = 0; i < lines[0].size(); ++i) {
        text += i == 0 ? "---|" : "--:|";
    }
    text += "\n";
    for (std::size_t i = 1; i < lines.size(); ++i) {
        text += markdown_line(lines[i]);
    }
    return text;
}

// Columns of equal width, the first aligned to the left.
std::string text_table(const std::vector<Cells>& lines) {
    std::vector<std::size_t> widths(lines[0].size());
    for (const Cells& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            widths[i] = std::max(widths[i], line[i].size());
        }
    }
    std::string text;
    for (const Cells& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string space(widths[i] - line[i].size(), ' ');
            text += i == 0 ? line[i] + space : "  " + space + line[i];
        }
        text += "\n";
    }
    return text;
}

// Prose in lines of at most so many characters, as pages have them.
std::string wrapped(const std::string& prose) {
    constexpr std::size_t columns_max = 100;
    std::string text;
    std::size_t column = 0;
    std::istringstream words(prose);
    for (std::string word; words >> word;) {
        const bool fits = column + 1 + word.size() <= columns_max;
        if (column > 0) {
            text += fits ? ' ' : '\n';
            column = fits ? column + 1 : 0;
        }
        text += word;
        column += word.size();
    }
    return text;
}

std::string for_people(const Report& report, const std::string& heading,
                       const std::function<std::string(const std::vector<Cells>&)>& as_table) {
    std::string text = as_text(report.conditions) + "\n";
    for (const Table& table : report.tables) {
        if (!table.rows.empty()) {
            text += table.title.empty() ? "\n" : "\n" + heading + table.title + "\n\n";
            text += as_table(grid_of(table));
        }
    }
    for (const std::string& note : report.notes) {
        text += "\n" + wrapped(note) + "\n";
    }
    return text;
}

}  // namespace

std::string as_text(const Conditions& conditions) {
    std::string text;
    if (!conditions.renderer.empty()) {
        text = conditions.renderer + (conditions.software ? " (software)" : "") + ", " +
               size_text(conditions.size) + ", ";
    }
    return text + "wall clock, median of " + std::to_string(conditions.rounds) +
           (conditions.rounds == 1 ? " round" : " rounds");
}

ordered_json as_json(const Report& report) {
    const Conditions& conditions = report.conditions;
    const bool drawn = !conditions.renderer.empty();
    ordered_json document{{"bench", report.bench},
                          {"renderer", drawn ? ordered_json(conditions.renderer) : ordered_json()},
                          {"software", drawn ? ordered_json(conditions.software) : ordered_json()},
                          {"clock", "wall"},
                          {"rounds", conditions.rounds}};
    if (drawn) {
        document["size"] = {conditions.size.width, conditions.size.height};
    }
    for (const Table& table : report.tables) {
        if (!table.key.empty()) {
            document[table.key] = table.rows;
        }
    }
    document["notes"] = report.notes;
    return document;
}

std::string as_csv(const Report& report) {
    constexpr int all_digits = 9;
    const Table& table = report.tables.front();
    const Conditions& conditions = report.conditions;
    Cells heads;
    for (const Column& column : table.columns) {
        if (column.parts.empty()) {
            heads.push_back(column.key);
        }
        for (const std::string& part : column.parts) {
            heads.push_back(column.key + "_" + part);
        }
    }
    append(heads, {"renderer", "size_px", "rounds", "clock"});
    std::string text = csv_line(heads);
    for (const ordered_json& row : table.rows) {
        Cells line;
        for (const Column& column : table.columns) {
            append(line, cells_of(row, column, all_digits));
        }
        append(line, {conditions.renderer, size_text(conditions.size),
                      std::to_string(conditions.rounds), "wall"});
        text += csv_line(line);
    }
    return text;
}

std::string as_markdown(const Report& report) {
    return "# " + report.bench + "\n\n" + for_people(report, "## ", markdown_table);
}

std::string as_text(const Report& report) {
    return for_people(report, "", text_table);
}

}  // namespace quartic
