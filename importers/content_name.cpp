// Knows the first bytes of what people mistake for a model.
#include "importers/content_name.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace quartic {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view first_bytes;
    std::string_view name;
};

constexpr Signature signatures[] = {
    {"\x89PNG"sv, "a PNG image"},
    {"\xff\xd8\xff"sv, "a JPEG image"},
    {"GIF8"sv, "a GIF image"},
    {"BM"sv, "a BMP image"},
    {"II*\0"sv, "a TIFF image"},
    {"MM\0*"sv, "a TIFF image"},
    {"%PDF"sv, "a PDF document"},
    {"PK\x03\x04"sv, "a ZIP archive; unpack it first"},
    {"PK\x05\x06"sv, "an empty ZIP archive"},
    {"\x1f\x8b"sv, "a gzip archive; unpack it first"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive; unpack it first"},
    {"Rar!"sv, "a RAR archive; unpack it first"},
    {"\x7f"
     "ELF"sv,
     "a program"},
    {"MZ"sv, "a Windows program"},
    {"glTF"sv, "a binary glTF model"},
    {"ISO-10303-21"sv, "a STEP or IFC model"},
    {"solid "sv, "an STL model"},
    {"ply\n"sv, "a PLY model"},
    {"Kaydara FBX"sv, "an FBX model"},
    {"SQLite format 3"sv, "an SQLite database"},
    {"\xd0\xcf\x11\xe0"sv, "an Office document"},
    {"<!DOCTYPE html"sv, "an HTML page; was the download redirected?"},
    {"<html"sv, "an HTML page; was the download redirected?"},
    {"<?xml"sv, "an XML document"},
    {"version https://git-lfs"sv, "a Git LFS pointer; fetch the real file with git lfs pull"},
    {"CADC_Attributes_File"sv, "an attribute file; open the .rvm or .rev beside it"},
    {"\xef\xbb\xbf"
     "CADC_Attributes_File"sv,
     "an attribute file; open the .rvm or .rev beside it"},
};

bool is_printable(char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
}

std::string first_bytes_in_hex(std::string_view text) {
    std::string hex = "a file that begins with the bytes";
    for (const char c : text.substr(0, 8)) {
        std::array<char, 4> digits{};
        std::snprintf(digits.data(), digits.size(), " %02x", static_cast<unsigned char>(c));
        hex += digits.data();
    }
    return hex;
}

}  // namespace

std::string content_name(std::span<const std::byte> head) {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (text.empty()) {
        return "an empty file";
    }
    for (const Signature& signature : signatures) {
        if (text.starts_with(signature.first_bytes)) {
            return std::string(signature.name);
        }
    }
    const std::string_view start = text.substr(0, 64);
    if (std::all_of(start.begin(), start.end(), is_printable)) {
        const std::string_view line =
            start.substr(0, std::min(start.find_first_of("\r\n"), start.size()));
        return "text that begins with '" + std::string(line.substr(0, 40)) + "'";
    }
    return first_bytes_in_hex(text);
}

}  // namespace quartic
