// Writes the text of every program into a folder, for checking by glslangValidator.
#include "shaders/variants.h"

#include <cstdio>
#include <fstream>

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: write_shader_variants FOLDER\n");
        return 2;
    }
    for (const quartic::NamedText& shader : quartic::all_shader_texts()) {
        std::ofstream file(std::string(arguments[1]) + "/" + shader.file_name);
        file << shader.text;
        if (!file.flush()) {
            std::fprintf(stderr, "%s: cannot be written\n", shader.file_name.c_str());
            return 1;
        }
    }
    return 0;
}
