// Expands the includes of shader files.
#include "shaders/source.h"

#include "diagnostics/check.h"
#include "shaders/embedded.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace quartic {
namespace {

constexpr int include_depth_max = 8;

std::string file_text(std::string_view path) {
    if (const char* tree = std::getenv("QUARTIC_SHADER_TREE")) {
        std::ifstream file(std::string(tree) + "/" + std::string(path));
        if (file) {
            std::ostringstream text;
            text << file.rdbuf();
            return text.str();
        }
    }
    for (const EmbeddedFile& file : embedded_files()) {
        if (file.path == path) {
            return std::string(file.text);
        }
    }
    check_failed("a shader includes a file that is not embedded", std::string(path).c_str(), 0);
}

void expand(std::string_view path, int depth, std::string& into) {
    CHECK(depth < include_depth_max);
    std::istringstream lines(file_text(path));
    for (std::string line; std::getline(lines, line);) {
        constexpr std::string_view keyword = "#include \"";
        if (line.starts_with(keyword)) {
            expand(line.substr(keyword.size(), line.rfind('"') - keyword.size()), depth + 1, into);
        } else {
            into += line;
            into += '\n';
        }
    }
}

}  // namespace

std::string shader_source(std::string_view path, std::string_view defines) {
    std::string text = "#version 450 core\n";
    text += defines;
    expand(path, 0, text);
    return text;
}

}  // namespace quartic
