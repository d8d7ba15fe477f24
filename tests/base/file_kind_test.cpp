#include "base/files.h"

#include <gtest/gtest.h>

#include <string>

namespace glibra::base {
namespace {

/// A text of one byte per character with `zeros` after each, or before.
std::string wide(std::string_view text, std::size_t zeros, bool isBefore) {
    std::string bytes;
    for (const char each : text) {
        if (isBefore) bytes.append(zeros, '\0');
        bytes += each;
        if (!isBefore) bytes.append(zeros, '\0');
    }
    return bytes;
}

TEST(FileKind, IsReadFromTheBeginning) {
    using namespace std::string_literals;
    const std::pair<std::string, const char*> cases[] = {
        {"\x89PNG\r\n\x1a\n", "a PNG picture"},
        {"\xff\xd8\xff\xe0", "a JPEG picture"},
        {"BM\x36\0\0\0"s, "a BMP picture"},
        {"MM\x22\x01\0\0\x02\0"s, "a 3DS model"},
        {"P6\n2 2\n255\n", "a PNM picture"},
        {"%PDF-1.7\n", "a PDF document"},
        {"glTF\x02\0\0\0"s, "a glTF model"},
        {"{\"asset\": {\"version\": \"2.0\"}}", "a glTF model"},
        {"{\"a\": 1}", "a JSON file"},
        {"ply\nformat ascii 1.0\n", "a PLY model"},
        {"# Blender\no Cube\nv 1 2 3\n", "an OBJ model"},
        {"v 1 2 3\nf 1 1 1\n", "an OBJ model"},
        {"#version 330\nvoid main() {}\n", "a GLSL shader"},
        {"// light\n/* of\nday */\nvec3 light() { return vec3(1); }\n", "a GLSL shader"},
        {"<?xml version=\"1.0\"?><svg/>", "an XML file"},
        {"<!DOCTYPE html>", "a web page"},
        {"\1\0\2\3"s, ""},
        {"Sphere 1\n", ""},
        {"", ""},
    };
    for (const auto& [content, kind] : cases) EXPECT_EQ(fileKind(content), kind) << content;
}

TEST(FileKind, KnowsEncodingsWithAndWithoutAMark) {
    const std::string text = "# a scene\nSphere 1\n";
    for (const bool isBefore : {false, true}) {
        EXPECT_EQ(foreignEncoding(wide(text, 1, isBefore)), "UTF-16 text");
        EXPECT_EQ(foreignEncoding(wide(text, 3, isBefore)), "UTF-32 text");
    }
    EXPECT_EQ(foreignEncoding("\xff\xfe" + wide(text, 1, false)), "UTF-16 text");
    EXPECT_EQ(foreignEncoding("\xfe\xff" + wide(text, 1, true)), "UTF-16 text");
    EXPECT_EQ(foreignEncoding(text), "");
    EXPECT_EQ(foreignEncoding("\xef\xbb\xbf" + text), "");
    EXPECT_EQ(notThe("a scene", wide(text, 1, false)), "is UTF-16 text; save it as UTF-8");
    EXPECT_EQ(notThe("a scene", "%PDF-1.7"), "is a PDF document, not a scene");
    EXPECT_EQ(notThe("a scene", std::string("\1\0\2\3", 4)), "is a binary file, not a scene");
    EXPECT_EQ(notThe("an OBJ model", "v 1 2 3"), "");
}

}  // namespace
}  // namespace glibra::base
