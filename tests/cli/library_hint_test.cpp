// A missing file that glibra's own library has: the note names the way to it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

constexpr const char* kVertex = "void main() { gl_Position = aVertex; }\n";

/// The library that the note in `text` names; empty if there is no such note.
std::string libraryIn(const std::string& text, const std::string& begin) {
    const std::string start = "note: the library of glibra has " + begin + "; --library ";
    const std::size_t at = text.find(start);
    if (at == std::string::npos) return {};
    return text.substr(at + start.size(), text.find(" finds it", at) - at - start.size());
}

TEST(LibraryHint, StandsAfterTheErrorsOfARenderAndACheckAndIsRight) {
    const Folder folder;
    folder.write("b.glib", "Vertex noise/solid.vert\nFragment noise/marble.frag\nProgram P\nSphere 1\n");
    std::string library;
    for (const char* command : {"render b.glib", "check b.glib"}) {
        const Finished run = glibra(folder.path(), command);
        EXPECT_EQ(run.status, 3);
        library = libraryIn(run.err, "'noise/solid.vert'");
        EXPECT_FALSE(library.empty()) << run.err;
    }
    const Finished found = glibra(folder.path(), "check b.glib --library " + library);
    EXPECT_EQ(found.status, 0) << found.err;
}

TEST(LibraryHint, NamesTheFolderOfATopic) {
    const Folder folder;
    folder.write("own.vert", kVertex);
    folder.write("b.glib", "Vertex own.vert\nFragment wood.frag\nProgram P\nSphere 1\n");
    const Finished run = glibra(folder.path(), "check b.glib");
    EXPECT_FALSE(libraryIn(run.err, "'wood.frag' as 'noise/wood.frag'").empty()) << run.err;
}

TEST(LibraryHint, StandsAfterAnInclude) {
    const Folder folder;
    folder.write("own.vert", kVertex);
    folder.write(
        "b.glib",
        "Vertex own.vert\nFragment inline\n#version 330\n#include \"raytracing/mixing.glsl\"\n"
        "out vec4 c;\nvoid main() { c = vec4(paintOf(vec3(1.)), 1.); }\nEndFragment\nProgram P\nSphere 1\n");
    const std::string library =
        libraryIn(glibra(folder.path(), "check b.glib").err, "'raytracing/mixing.glsl'");
    EXPECT_FALSE(library.empty());
    const Finished found = glibra(folder.path(), "check b.glib --library " + library);
    EXPECT_EQ(found.status, 0) << found.err;
}

TEST(LibraryHint, IsSilentWhereItDoesNotHelp) {
    const Folder folder;
    folder.write("b.glib", "Vertex mine.vert\nFragment mine.frag\nProgram P\nSphere 1\n");
    EXPECT_FALSE(contains(glibra(folder.path(), "check b.glib").err, "the library of glibra"));
    folder.write("own.vert", kVertex);
    folder.write("c.glib", "Vertex own.vert\nFragment wood.frag\nProgram P\nSphere 1\n");
    const std::string library =
        libraryIn(glibra(folder.path(), "check c.glib").err, "'wood.frag' as 'noise/wood.frag'");
    const Finished searched = glibra(folder.path(), "check c.glib --library " + library);
    EXPECT_TRUE(contains(searched.err, "the library has it as 'noise/wood.frag'")) << searched.err;
    EXPECT_FALSE(contains(searched.err, "the library of glibra")) << "the error says it";
}

TEST(LibraryHint, IsSilentAboutFilesOutsideTheLibrary) {
    const Folder folder;
    folder.write("secret.frag", "float f;\n");
    std::filesystem::create_directory(folder.path() / "own");
    for (const char* name : {"../secret.frag", "/proc/version", "sub/../../secret.frag"}) {
        folder.write("own/a.frag", std::string("#version 330\n#include \"") + name + "\"\nvoid main() {}\n");
        folder.write("own/a.glib", "Fragment a.frag\nProgram P\nFill window with P\n");
        const Finished run = glibra(folder.path(), "check own/a.glib");
        EXPECT_FALSE(contains(run.err, "the library of glibra")) << run.err;
    }
}

}  // namespace
}  // namespace glibra::test
