// For any bytes the parser ends, its places and ranges are valid, and it gives the same answer twice.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "glib/messages.h"
#include "glib/statement_table.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

/// Random values that depend only on (seed, count).
class Hash {
  public:
    explicit Hash(std::uint32_t seed) : seed_(mix(seed)) {}
    std::uint32_t below(std::uint32_t bound) { return mix(seed_ ^ count_++) % bound; }

  private:
    static std::uint32_t mix(std::uint32_t x) {
        x ^= x >> 16U;
        x *= 0x7feb352dU;
        x ^= x >> 15U;
        x *= 0x846ca68bU;
        return x ^ (x >> 16U);
    }
    std::uint32_t seed_;
    std::uint32_t count_ = 0;
};

void checkPromises(const std::string& text) {
    const Script script = read(text);
    std::size_t end = 0;
    for (const Command& command : script.commands) {
        ASSERT_GE(command.begin, end);
        ASSERT_GT(command.end, command.begin);
        ASSERT_LE(command.end, text.size());
        ASSERT_EQ(text.substr(command.begin, command.word.size()), command.word);
        end = command.end;
        for (const double number : command.numbers) ASSERT_TRUE(std::isfinite(number));
        for (const UniformSpec& spec : command.uniforms) ASSERT_FALSE(spec.values.empty());
    }
    for (std::size_t i = 0; i < script.commands.size(); ++i) {
        const std::size_t partner = script.commands[i].partner;
        if (partner != Command::kNoPartner) {
            ASSERT_LT(partner, script.commands.size());
            ASSERT_NE(partner, i);
        }
        for (const Value& value : script.commands[i].values) ASSERT_LE(value.end, text.size());
        ASSERT_FALSE(written(script.commands[i]).empty());
    }
    ASSERT_LE(script.diagnostics.size(), kMostMessages + 1);
    for (const Diagnostic& each : script.diagnostics) {
        ASSERT_GE(each.place.line, 1);
        ASSERT_GE(each.place.column, 1);
        ASSERT_FALSE(each.text.empty());
        if (!each.id.empty()) {
            const CatalogueRow* row = findDiagnostic(each.id);
            ASSERT_TRUE(row) << each.id;
            ASSERT_EQ(row->severity(), each.severity) << each.id;
        }
    }
    const Script again = read(text);
    ASSERT_EQ(again.commands.size(), script.commands.size());
    ASSERT_EQ(idsOf(again), idsOf(script));
}

/// Checks a scene without mistakes, and 2,000 times with some of its bytes changed, dropped or doubled.
void checkEdits(const std::string& scene, std::uint32_t firstSeed) {
    checkPromises(scene);
    ASSERT_TRUE(read(scene).diagnostics.empty());
    for (std::uint32_t seed = firstSeed; seed < firstSeed + 2000; ++seed) {
        Hash hash(seed);
        std::string text = scene;
        for (std::uint32_t edits = 1 + hash.below(6); edits > 0; --edits) {
            const std::size_t at = hash.below(static_cast<std::uint32_t>(text.size()));
            switch (hash.below(3)) {
                case 0:
                    text[at] = static_cast<char>(hash.below(256));
                    break;
                case 1:
                    text.erase(at, 1 + hash.below(10));
                    break;
                default:
                    text.insert(
                        at, text.substr(hash.below(static_cast<std::uint32_t>(text.size())), hash.below(30)));
            }
            if (text.empty()) text = "#";
        }
        checkPromises(text);
    }
}

TEST(RandomText, AnyBytes) {
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        Hash hash(seed);
        std::string text(hash.below(600), ' ');
        for (char& c : text) c = static_cast<char>(hash.below(256));
        checkPromises(text);
    }
}

TEST(RandomText, BytesThatMeanSomething) {
    constexpr std::string_view kBytes = "<>[]{}()\\\\\n\n\r\t \"#/,;.-+e0159uA_?\xa0\xc2";
    for (std::uint32_t seed = 1000; seed < 2000; ++seed) {
        Hash hash(seed);
        std::string text = seed % 2 == 0 ? "Program P " : "";
        const std::uint32_t size = hash.below(300);
        for (std::uint32_t i = 0; i < size; ++i)
            text += kBytes[hash.below(static_cast<std::uint32_t>(kBytes.size()))];
        checkPromises(text);
    }
}

TEST(RandomText, TokensInAnyOrder) {
    constexpr std::array<std::string_view, 26> kPieces = {
        "<",       ">",         "[",        "]",     "{",    "}",          "(",    ")",   "\\\n",
        "\n",      " \\ # x\n", "1",        "-2.5",  "0.1.", "1e39",       "true", "uA",  "a.bmp",
        "\"q r\"", "RGBA8",     "gl_lines", "# c\n", "/ ",   "MessageBox", ",",    "\n\n"};
    const auto table = commandTable();
    for (std::uint32_t seed = 5000; seed < 6500; ++seed) {
        Hash hash(seed);
        std::string text;
        const std::uint32_t count = hash.below(80);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (hash.below(4) == 0)
                text += table[hash.below(static_cast<std::uint32_t>(table.size()))].name;
            else
                text += kPieces.at(hash.below(kPieces.size()));
            if (hash.below(5) != 0) text += ' ';
        }
        checkPromises(text);
    }
}

TEST(RandomText, WordsOfModernStatementsInAnyOrder) {
    constexpr std::array<std::string_view, 26> kPieces = {
        "\n",        "\n",        "\n",     "\\\n",      "1",          "-2.5",    "(time)",        "(1",
        "thing",     "life.prev", "a[2]",   "[1 2]",     "[3 of (i)]", "{1 0 0}", "<0 1 2>",       "<a b>",
        "\"q r\"",   "window",    "inline", "EndVertex", "[",          "}",       "glow.level(2)", "# c\n",
        "Let x 5\n", "x[(i)].y"};
    std::vector<std::string> words;
    for (const StatementRow& row : statementTable()) {
        words.emplace_back("\n" + std::string(row.name));
        for (const std::string& each : wordsOf(row)) words.push_back(each);
    }
    for (std::uint32_t seed = 20000; seed < 23000; ++seed) {
        Hash hash(seed);
        std::string text;
        const std::uint32_t count = hash.below(120);
        for (std::uint32_t i = 0; i < count; ++i) {
            if (hash.below(2) == 0)
                text += words[hash.below(static_cast<std::uint32_t>(words.size()))];
            else
                text += kPieces.at(hash.below(kPieces.size()));
            if (hash.below(6) != 0) text += ' ';
        }
        checkPromises(text);
    }
}

TEST(RandomText, ModernScenesWithBytesChangedDroppedAndDoubled) {
    const std::string scene =
        "Camera eye LookAt 0 3 6 0 0 0 0 1 0 Perspective 50 .1 100\nTexture2D shadow 64 64 depth32f history\n"
        "Let a[6] (sin(i))\nLet b <0 1 2>\nBuffer s float [1 2 3]\nGroup world size 1\nTranslate (2*time) 0 "
        "0\n"
        "Repeat [add sub] as op\nState blend (op) depth less\nSet lights[2].position {1 2 3} uT life.prev\n"
        "When (a[2] < 3)\nBox (size)\nElse\nBox 1\nEndWhen\nEndRepeat\nEndGroup\nVertex inline\nvoid main() "
        "{}\n"
        "EndVertex\nProgram Lit uS shadow uM (eye.view * model) uA [6 of (i)]\nPass window shadow.level(1) "
        "from eye "
        "clear {1 1 1} depth 1\nDraw world size 2\nEndPass\nOnce\nDispatch Lit over shadow\nEndOnce\n"
        "Expect pixel 1 2 [1 1 1 1] within .1 at 2\n";
    checkEdits(scene, 30000);
}

TEST(RandomText, ScenesWithBytesChangedDroppedAndDoubled) {
    const std::string scene =
        "##OpenGL GLIB\nPerspective 70\nLookAt 0 0 5  0 0 0  0 1 0\nCubeMap 6 a.bmp b.bmp c.bmp d.bmp e.bmp "
        "f.bmp\n"
        "Vertex oval.vert\nFragment oval.frag\nProgram Oval \\\n\tuAd <.01 .1 .5>  uBd <.01 .1 .5> \\\n"
        "\tuColor {1. .5 0.} uOn <true> uUnit 6\nTexture2D 7 1024 1024 RGBA16F\nglBegin gl_patches\nglVertex "
        "0. 2. 0.\nglEnd\n"
        "LinesAdjacency [0. 0. 0.] [1. 1. 1.] [2. 1. 2.] [3. -1. 0.]\nMessageBox Move # it\nSphere 1 60 60\n";
    checkEdits(scene, 9000);
}

TEST(RandomText, LargestFilesOfOneTokenEnd) {
    constexpr std::size_t kSize = GLIBRA_SANITIZED ? 1U << 17U : 1U << 20U;
    for (const std::string_view piece : {"<\\\n",
                                         "Program P {\n",
                                         "CubeMap [\n",
                                         "[\n",
                                         "u 1\n",
                                         ", ",
                                         "\\\n",
                                         "Spere\n",
                                         "/\n",
                                         "\"\n",
                                         "Program u u\\\n",
                                         "Triangles <\\\n",
                                         "u<",
                                         "\xa0",
                                         "(a",
                                         "Let a (",
                                         "Group\n",
                                         "EndPass\n",
                                         "Vertex inline\n",
                                         "Set u[",
                                         "Pass a ",
                                         "x(1)"}) {
        for (const char* head : {"", "Program P ", "CubeMap 6 "}) {
            std::string text = head;
            while (text.size() < kSize) {
                text += piece;
                if (piece.find('\n') == std::string_view::npos && text.size() % 1000 < piece.size())
                    text += '\n';
            }
            const Script script = read(text);
            EXPECT_LE(script.diagnostics.size(), kMostMessages + 1);
        }
    }
}

}  // namespace
}  // namespace glibra::glib::test
