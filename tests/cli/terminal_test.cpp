// Scenes, shaders and file names of strangers cannot steer the terminal that shows their messages, and closed
// standard descriptors cost no picture.

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "base/utf8.h"
#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// What a terminal would obey, as a number of its place; nothing if the text is safe.
std::optional<std::size_t> firstUnsafe(const std::string& text) {
    for (std::string_view rest = text; !rest.empty();) {
        const base::Character next = base::firstCharacter(rest);
        const bool isControl = (next.code < 0x20 && next.code != '\n' && next.code != '\t') ||
                               (next.code >= 0x7F && next.code <= 0x9F);
        const bool turns = (next.code >= 0x202A && next.code <= 0x202E) ||
                           (next.code >= 0x2066 && next.code <= 0x2069) || next.code == 0x200F;
        if (isControl || turns || !next.valid) return text.size() - rest.size();
        rest.remove_prefix(next.bytes);
    }
    return std::nullopt;
}

void expectSafe(const Finished& run, const std::string& what) {
    for (const std::string& text : {run.out, run.err})
        if (const auto at = firstUnsafe(text))
            ADD_FAILURE() << what << ": unsafe at byte " << *at << " of\n" << base::printableText(text, true);
}

/// Bytes that a terminal may obey, and others.
std::string hostileBytes(std::mt19937& random, std::size_t count) {
    static const std::vector<std::string> kPieces{"\x1b]0;owned\x07",
                                                  "\x1b[2J",
                                                  "\x9b"
                                                  "31m",
                                                  "\xc2\x9b"
                                                  "31m",
                                                  "\x7f",
                                                  "\xe2\x80\xae",
                                                  "\xe2\x81\xa6",
                                                  "\x08",
                                                  "\r",
                                                  "\x0e",
                                                  "\xff\xfe",
                                                  "\xf0\x9f\x98\x80",
                                                  "\xc3\xbc",
                                                  "a",
                                                  " b",
                                                  "\xf3\xa0\x80\x81",
                                                  "\xed\xa0\x80"};
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += kPieces[random() % kPieces.size()];
    return text;
}

/// For the shell.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char each : text) result += each == '\'' ? std::string("'\\''") : std::string(1, each);
    return result + "'";
}

TEST(Terminal, EscapeSequencesOfAShaderAreShown) {
    const Folder folder;
    folder.write("a.vert", kVertexShader);
    folder.write("a.frag", "#version 330 core\n#error \033]0;owned\007\nvoid main() {}\n");
    folder.write("a.glib", "Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n");
    for (const char* command : {"check a.glib", "render a.glib"}) {
        const Finished run = glibra(folder.path(), command);
        EXPECT_EQ(run.status, 3) << command;
        EXPECT_NE(run.err.find("\\x1b]0;owned\\x07"), std::string::npos) << command << ": " << run.err;
        expectSafe(run, command);
    }
}

TEST(Terminal, NoBytesOfSceneShaderOrFileNameReachIt) {
    std::mt19937 random(13);
    for (int round = 0; round < (GLIBRA_SANITIZED ? 3 : 12); ++round) {
        const Folder folder;
        const auto bytes = [&] { return hostileBytes(random, 1 + random() % 6); };
        const std::string name = "s" + bytes();
        folder.write("a.vert", kVertexShader);
        folder.write("a.frag", "#version 330 core\n#error " + bytes() +
                                   "\nout vec4 f; void main() { f = " + bytes() + "; }\n");
        folder.write("b.frag", "#version 330 core\nuniform float u" + bytes() +
                                   ";\nout vec4 f;\nvoid main() { f = vec4(1.); }\n");
        folder.write(name + ".glib", "Vertex a.vert\nFragment a.frag\nProgram \"" + bytes() + "\" u" +
                                         bytes() + " 3\nSphere\n" + bytes() + " 1\nTexture 5 \"" + bytes() +
                                         ".bmp\"\n");
        folder.write("b.glib", "MessageBox " + bytes() + "\nVertex a.vert\nFragment \"" + bytes() +
                                   "\"\nProgram P\nVerbose\nSphere\n");
        folder.write("c.glib", "Vertex a.vert\nFragment b.frag\nProgram P" + bytes() + "\nSphere\n");
        folder.write("t.toml", "[[shot]]\nscript = \"c.glib\"\n[[shot]]\nscript = \"b.glib\"\n");
        folder.write("w.toml", "[[shot]]\nscript = \"" + bytes() + "\"\n" + bytes() + " = 1\n");
        folder.write("p" + bytes() + ".png", bytes());
        const std::string scene = quoted(name + ".glib");
        for (const std::string& command : std::vector<std::string>{
                 "check " + scene + " b.glib c.glib", "check --json " + scene + " b.glib",
                 "render " + scene + " b.glib c.glib -o out", "render c.glib --explain -o c.png",
                 "test t.toml", "test w.toml", "compare p* p*", "render " + quoted(bytes()),
                 "render c.glib --set " + quoted("u=" + bytes()), "frobnicate " + quoted(bytes()),
                 "language " + quoted(bytes()), "test --merge " + quoted(bytes())})
            expectSafe(glibra(folder.path(), command),
                       "round " + std::to_string(round) + ", " + command.substr(0, 8));
    }
}

TEST(Terminal, TheLineOfProgressIsSafe) {
    const Folder folder;
    folder.write("a\033]0;owned\007.glib", "Sphere\n");
    folder.write(
        "b\xc2\x9b"
        "31m.glib",
        "Sphere\n");
    // script(1) gives the program a terminal.
    if (shell(folder.path(), "command -v script").status != 0) GTEST_SKIP() << "needs script(1)";
    const Finished run =
        shell(folder.path(), "script -qec '\"" GLIBRA_PROGRAM "\" render *.glib -o out --size 8x8' typed");
    std::string text = readFile(folder / "typed");
    EXPECT_NE(text.find("[1/2]"), std::string::npos) << text;
    for (const char* own : {"\033[K", "\033[0m", "\033[1;31m", "\033[1;35m", "\033[1;36m", "\r"})
        for (std::size_t at = 0; (at = text.find(own)) != std::string::npos;)
            text.erase(at, std::string(own).size());
    EXPECT_EQ(firstUnsafe(text), std::nullopt) << base::printableText(text, true);
}

TEST(Descriptors, ClosedOnesCostNoPicture) {
    for (int closed = 1; closed < 8; ++closed) {
        const Folder folder;
        std::string scenes;
        for (const char* each : {"a", "b", "c", "d", "e"}) {
            folder.write(std::string(each) + ".glib", "Sphere\n");
            scenes += std::string(each) + ".glib ";
        }
        std::string closing = "exec";
        const char* const words[] = {" <&-", " >&-", " 2>&-"};
        for (unsigned i = 0; i < 3; ++i)
            if ((static_cast<unsigned>(closed) >> i & 1U) != 0) closing += words[i];
        const Finished run = shell(folder.path(), "(" + closing + "; exec '" GLIBRA_PROGRAM "' render " +
                                                      scenes + "--size 40x30 -o out/ --jobs 2)");
        EXPECT_EQ(run.status, 0) << closing << run.err;
        const std::string whole = readFile(folder / "out/a.png");
        EXPECT_TRUE(whole.starts_with("\x89PNG")) << closing;
        for (const char* each : {"b", "c", "d", "e"})
            EXPECT_EQ(readFile(folder.path() / "out" / (std::string(each) + ".png")), whole)
                << closing << ": " << each;
    }
}

TEST(Descriptors, APictureForAClosedStandardOutputIsAnError) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    const Finished run = shell(folder.path(), "(exec >&-; exec '" GLIBRA_PROGRAM "' render a.glib -o -)");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("file-E10"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace glibra::test
