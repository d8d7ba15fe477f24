// Every modern statement with wrong arguments at the interpreter: expressions of a wrong type or without a
// value, numbers out of range, unknown, misspelt and missing words. Each mistake gives one error at its
// place, and the statements that use what the faulty one declares add none.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glib/messages.h"
#include "glib/script.h"
#include "glib/statement_table.h"
#include "glib/syntax.h"
#include "scene/actions.h"
#include "scene/interpret.h"
#include "scene/run/statements.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::TemporaryFolder;
using tests::textsOf;

/// What the statements below use.
constexpr std::string_view kPrelude = R"(Let speed <0 1 2>
Let mode <plain lit toon>
Camera sun LookAt 3 6 3  0 0 0  0 1 0  Perspective 70 1 20
Texture2D albedo 8 8 rgba8
Texture2D second 8 8 rgba8
Texture2D shadow 8 8 depth24_stencil8
Texture2DArray slices 8 8 4 rgba8 levels 2
CubeMap sky 8 rgba8
Buffer counts uint 4
Buffer points vec4 6
Fragment a.frag
Program Flat
Compute a.comp
Program Count
Group part size 1
    Box (size)
EndGroup
)";

/// A statement that is right, in the middle of others that use what it declares.
struct Specimen {
    const char* line;
    const char* after = "";
    const char* before = "";
};

constexpr Specimen kSpecimens[] = {
    {"Let size <0 1 2>", "Box (size)\n"},
    {"Bound steps <8 64 512>", "Box (steps)\n"},
    {"Let kind <red green blue>", "Translate (kind) 0 0\nBox\n"},
    {"Let twice (2 * speed)", "Box (twice)\n"},
    {"Let pose[4] (i == 0 ? 1 : 2 * pose[i - 1])", "Box (pose[3])\n"},
    {"Let list[3] [1 2 3]", "Box (list[2])\n"},
    {"Let square(x) (x * x)", "Box (square(2))\n"},
    {"Set uTint {1 .5 0} uCount 3 uList [4 of (i)] uMap albedo", "Box\nBox\n"},
    {"Material gold", "Box\n"},
    {"Material ambient {0 0 0} diffuse {1 .5 0} specular {1 1 1} emission {0 0 0} shininess 20", "Box\n"},
    {"Light 0 position 1 2 3 0 ambient {0 0 0} diffuse {1 1 1} specular {1 1 1}", "Box\n"},
    {"Light 1 spot 0 0 -1 cutoff 30 exponent 2 attenuation 1 0 .5", "Box\n"},
    {"Light ambient {.2 .2 .2}", "Box\n"},
    {"Group arm length 1 width (2)", "    Box (length) (width)\nEndGroup\nDraw arm\n"},
    {"EndGroup", "Box\n", "Group\n"},
    {"Draw part size 2", "Box\n"},
    {"Repeat 3 as k", "    Box (k + 1)\nEndRepeat\n"},
    {"Repeat 3 until (speed>0)", "    Box (i + 1)\nEndRepeat\n"},
    {"Repeat [add sub] as op", "    Box (op.index + 1)\nEndRepeat\n"},
    {"EndRepeat", "Box\n", "Repeat 2\n"},
    {"When (speed>0)", "    Box\nElse\n    Sphere\nEndWhen\n"},
    {"Else", "    Box\nEndWhen\n", "When 1\n"},
    {"EndWhen", "Box\n", "When 1\n"},
    {"Include part.glib", "Box\n"},
    {"Vertex inline", "void main() {}\nEndVertex\nProgram Own\nBox\n"},
    {"TessControl inline", "void main() {}\nEndTessControl\nBox\n"},
    {"TessEvaluation inline", "void main() {}\nEndTessEvaluation\nBox\n"},
    {"Geometry inline", "void main() {}\nEndGeometry\nBox\n"},
    {"Fragment inline", "void main() {}\nEndFragment\nProgram Own\nUse Own\nBox\n"},
    {"Glsl shared inline", "float f() { return 1.; }\nEndGlsl\nBox\n"},
    {"Program Lit const STEPS (2*speed) const float SCALE 2 uA (2*speed) uMap albedo uList [3 of (i)]",
     "Use Lit\nBox\nBox\nFill window with Lit\n"},
    {"Use Flat", "Box\n"},
    {"Key k mode plain lit", "Box\n"},
    {"Key k restart", "Box\n"},
    {"Key k held speed (speed + 1)", "Box\n"},
    {"MultMatrix (translate(1, 0, 0))", "Box\n"},
    {"Fps 24", "Box\n"},
    {"Camera left LookAt 0 0 5 0 0 0 0 1 0 Perspective 60 1 10 aspect 1.5",
     "Pass window from left\n    Box (left.near)\nEndPass\n"},
    {"Camera left At 0 0 5 Axes 1 0 0 0 1 0 0 0 1 Ortho -1 1 -1 1 1 10",
     "Camera right Shift left .1 0 0\nPass window from right\n    Box\nEndPass\n"},
    {"Camera left LookAt 0 0 5 0 0 0 0 1 0 Frustum -1 1 -1 1 1 10", "Pass window from left\nEndPass\n"},
    {"Camera below Reflect sun 0 1 0 0 clip", "Pass window from below\n    Box\nEndPass\n"},
    {"Camera right Shift sun .1 0 0", "Pass window from right\n    Box\nEndPass\n"},
    {"Camera side Face 2 0 0 0 1 10", "Pass sky.face(2) from side\n    Box\nEndPass\n"},
    {"Camera own (sun.view) (sun.projection)", "Pass window from own\n    Box\nEndPass\n"},
    {"Camera slice[3] Shift sun (i) 0 0", "Pass window from slice[2]\n    Box (slice[1].near)\nEndPass\n"},
    {"Texture1D ramp 16 rgba8 nearest clamp", "Set uMap ramp\nBox (ramp.size)\n"},
    {"Texture2D glow 16 8 rgba16f linear clamp levels 3 history",
     "Pass glow.level(1)\n    Box (glow.size.x)\nEndPass\nSet uMap glow.prev\n"},
    {"Texture2D many 16 8 rgba8 samples 4", "Pass many\n    Box\nEndPass\n"},
    {"Texture3D fog 8 8 8 r8 mipmap generate border {1 0 0 1}", "Set uMap fog\nBox\n"},
    {"Texture2DArray layers 8 8 6 rgba8 aniso 4", "Pass layers.layer(2)\n    Box\nEndPass\n"},
    {"Texture2DArray soft 8 8 3 rgba8 samples 4", "Pass soft.layer(2)\n    Box\nEndPass\n"},
    {"Texture1DArray ramps 16 4 rgba8 linear clamp",
     "Pass ramps.layer(3)\n    Box (ramps.size.y)\nEndPass\n"},
    {"TextureRect rect 16 8 rgba8 nearest border {1 0 0 1}", "Pass rect\n    Box (rect.size.x)\nEndPass\n"},
    {"CubeMap room 16 rgba8", "Pass room.face(1)\n    Box\nEndPass\nSet uMap room\n"},
    {"Sampler crisp nearest clamp aniso 2", "Set uMap albedo.crisp\nBox\n"},
    {"Sampler far linear compare greater", "Set uMap shadow.far\nBox\n"},
    {"Pass albedo second shadow from sun clear {1 0 0 1} depth .5 stencil 3", "    Box\nEndPass\n"},
    {"Pass window from sun keep color stencil", "    Box\nEndPass\n"},
    {"Pass slices.layer(1).level(1) reversed", "    Box\nEndPass\n"},
    {"EndPass", "Box\n", "Pass window\n"},
    {"Fill albedo with Flat uGain 2", "Box\n"},
    {"Fill albedo second with Flat", "Box\n"},
    {"Clear color depth stencil", "Box\n"},
    {"Clear counts", "Box\n"},
    {"Viewport 0 0 .5 1", "Box\n"},
    {"Scissor 0 0 .5 1", "Box\n"},
    {"State cull back front cw polygon line offset 1 2 depth less depthwrite off", "Box\n"},
    {"State depthrange 0 .5 depthclamp on provoking first samples off alphatocoverage on discard off",
     "Box\n"},
    {"State blend src_alpha one_minus_src_alpha add alpha one zero max blendcolor 0 0 0 1", "Box\n"},
    {"State blend.1 premultiplied write rgb", "Box\n"},
    {"State stencil equal 1 255 stencilop keep incr_wrap replace stencilwrite 15", "Box\n"},
    {"State mark 1", "Box\n"},
    {"State where 1", "Box\n"},
    {"State default", "Box\n"},
    {"Instances 4", "Box\n"},
    {"Attribute aPlace points offset 4 stride 16 per instance", "Box\n"},
    {"Instances from counts", "Box\n"},
    {"Instances from counts at 2", "Box\n"},
    {"Vertices triangles 6", "Box\n"},
    {"Vertices triangles from counts", "Box\n"},
    {"Vertices triangles from counts at 1", "Box\n"},
    {"Vertices triangles indices counts", "Box\n"},
    {"CubeMap many 8 rgba8 layers 2 linear", "Set uMap many\nBox\n"},
    {"Expect sum counts 2 within 1", "Box\n"},
    {"Vertices triangle_strip 4 indices counts", "Box\n"},
    {"Vertices triangles from counts indices counts", "Box\n"},
    {"Attribute aTint 1 .5 0 1", "Box\n"},
    {"Attribute aTint as normal", "Box\n"},
    {"Attribute aTint points per instance", "Box\n"},
    {"TessLevels 4 4 4 4 2 2", "Box\n"},
    {"Buffer values float 6 [1 2 3]",
     "Expect buffer values [1 2 3]\nSet uBuffer values\nBox (values.count)\n"},
    {"Buffer values vec3 4 (vec3(i, 0, 0)) history", "Set uBuffer values.prev\nBox\n"},
    {"Buffer values float [1 2 3]", "Dispatch Count over values\nBox\n"},
    {"Mesh ball Sphere 1 8 4", "Set uBuffer ball.position\nBox (ball.vertices)\nPrint ball.index\n"},
    {"Mesh cow Obj part.obj", "Attribute aTint cow.normal\nBox (cow.primitives)\n"},
    {"Compute b.comp", "Program Other\nDispatch Other 1 1 1\n"},
    {"Compute inline", "void main() {}\nEndCompute\nProgram Other\nDispatch Other 1 1 1\n"},
    {"Dispatch Count 4 2 1 tiles 2", "Box\n"},
    {"Dispatch Count over 512 512", "Box\n"},
    {"Dispatch Count over 512 512 discard", "Box\n"},
    {"Dispatch Count over points", "Box\n"},
    {"Dispatch Count from counts", "Box\n"},
    {"Dispatch Count from counts at 0", "Box\n"},
    {"Once", "    Clear counts\nEndOnce\n"},
    {"EndOnce", "Box\n", "Once\n"},
    {"Step 10", "    Clear counts\nEndStep\n"},
    {"Step 10 reset (speed) sun mode", "    Clear counts\nEndStep\n"},
    {"EndStep", "Box\n", "Step 10\n"},
    {"Expect pixel 1 2 [1 0 0] within .1 of albedo at 2", "Box\n"},
    {"Expect mean 0 0 4 4 [1 0 0] within .1 of albedo", "Box\n"},
    {"Expect count [1 0 0] 5 of albedo", "Box\n"},
    {"Expect count [1 0 0] 5 7 of albedo", "Box\n"},
    {"Expect count [1 0 0] 5 of albedo in 0 0 1 1 within .1", "Box\n"},
    {"Expect range albedo.r 0 1 in 0 0 1 1", "Box\n"},
    {"Expect sum points 0 within .1 in 0 0", "Box\n"},
    {"Expect finite points in 0 0", "Box\n"},
    {"Expect buffer counts [1 2] within .5", "Box\n"},
    {"Expect buffer counts at 2 [1 2] at 1", "Box\n"},
    {"Expect range points 0 1", "Box\n"},
    {"Expect same albedo second", "Box\n"},
    {"Expect same albedo second within .1 at 2", "Box\n"},
    {"Expect different albedo second", "Box\n"},
    {"Expect finite points", "Box\n"},
    {"Expect primitives 12", "Box\n"},
    {"Expect samples 12", "Box\n"},
    {"Expect error glib-E26", "Instances -1\nBox\n"},
    {"Expect (counts[0] == 4)", "Box\n"},
    {"Print counts", "Box\n"},
    {"Print counts 0 2", "Box\n"},
    {"Print albedo in 0 0 1 1", "Box\n"},
    {"Print (sum(counts) + 1)", "Box\n"},
};

/// A piece of a statement: a word, a number, or a bracket with what stands in it.
struct Piece {
    std::string text;
    bool isBracket = false, isNumber = false;
};

std::vector<Piece> piecesOf(std::string_view line) {
    std::vector<Piece> pieces;
    int depth = 0;
    for (const char c : line) {
        if (c == ' ' && depth == 0) {
            pieces.emplace_back();
            continue;
        }
        if (pieces.empty()) pieces.emplace_back();
        if (std::string_view("([{<").find(c) != std::string_view::npos) ++depth;
        if (std::string_view(")]}>").find(c) != std::string_view::npos) --depth;
        pieces.back().text += c;
    }
    for (Piece& each : pieces) {
        const auto first = static_cast<unsigned char>(each.text.front());
        each.isBracket = std::string_view("([{<").find(each.text.front()) != std::string_view::npos;
        each.isNumber = std::isdigit(first) != 0 || first == '-' || first == '.';
    }
    return pieces;
}

const glib::StatementRow& rowOf(std::string_view word) {
    const auto rows = glib::statementTable();
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const glib::StatementRow& row) { return row.name == word; });
}

struct Tried {
    Diagnostics errors;
    std::string scene;                  ///< without the prelude
    int line = 0, column = 0, end = 0;  ///< of the changed piece
};

class Statements : public testing::Test {
  protected:
    void SetUp() override {
        folder_.write("part.glib", "Translate 1 0 0\nBox\n");
        folder_.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        for (const char* name : {"a.frag", "a.comp", "b.comp"}) folder_.write(name, "void main() {}\n");
    }

    /// Interprets the scene with these pieces in place of the specimen's.
    Tried tryPieces(const Specimen& specimen, const std::vector<Piece>& pieces, std::size_t changed,
                    bool isFollowed = true) {
        Tried tried;
        std::string text = std::string(kPrelude) + specimen.before;
        tried.line = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
        std::string line;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!line.empty()) line += ' ';
            if (i == changed) tried.column = static_cast<int>(line.size()) + 1;
            line += pieces[i].text;
            if (i == changed) tried.end = static_cast<int>(line.size()) + 1;
        }
        text += line + "\n";
        if (isFollowed) text += specimen.after;
        tried.scene = text.substr(kPrelude.size());
        const glib::Script script = glib::parse(text, (folder_.path() / "scene.glib").string());
        std::vector<std::size_t> lengths{0};
        for (const char c : text) {
            if (c == '\n')
                lengths.push_back(0);
            else
                ++lengths.back();
        }
        Diagnostics all = script.diagnostics;
        append(all, interpret(script).diagnostics);
        for (const Diagnostic& each : all) {
            EXPECT_NE(glib::findDiagnostic(each.id), nullptr) << each.id;
            const auto at = static_cast<std::size_t>(each.place.line);
            EXPECT_TRUE(at >= 1 && at <= lengths.size() && each.place.column >= 1 &&
                        static_cast<std::size_t>(each.place.column) <= lengths[at - 1] + 1)
                << tried.scene << toString(each);
            EXPECT_EQ(each.text.find('\n'), std::string::npos) << each.text;
            if (each.severity == Severity::error) tried.errors.push_back(each);
        }
        return tried;
    }

    static void expectOne(const Tried& tried) {
        EXPECT_EQ(tried.errors.size(), 1U) << tried.scene << textsOf(tried.errors);
        for (const Diagnostic& each : tried.errors)
            EXPECT_EQ(each.place.line, tried.line) << tried.scene << textsOf(tried.errors);
    }
    /// One error at the changed piece.
    static void expectThere(const Tried& tried) {
        expectOne(tried);
        for (const Diagnostic& each : tried.errors)
            EXPECT_TRUE(each.place.column >= tried.column && each.place.column <= tried.end)
                << tried.scene << textsOf(tried.errors);
    }

    /// If the changed statement has an error, what follows adds none. Without its name, or as a statement of
    /// another form, it declares something else, and what follows has errors of its own.
    void expectNoFollowers(const Specimen& specimen, const std::vector<Piece>& pieces, std::size_t changed) {
        const glib::StatementRow& row = rowOf(pieces.front().text);
        const bool opens = row.role == glib::BlockRole::opens;
        if (std::string_view(specimen.line).starts_with("Expect error")) return;
        const bool isName = changed == 1 && (opens || row.declaresName || row.id == glib::CommandId::program);
        if (!opens) {
            const Tried alone = tryPieces(specimen, pieces, 0, false);
            EXPECT_LE(alone.errors.size(), 1U) << alone.scene << textsOf(alone.errors);
            if (alone.errors.size() != 1) return;
        }
        if (isName) return;
        const Tried tried = tryPieces(specimen, pieces, 0);
        EXPECT_LE(tried.errors.size(), 1U) << tried.scene << textsOf(tried.errors);
    }

    TemporaryFolder folder_;
};

TEST_F(Statements, AndClassicCommandsHaveAWordAndAnActionEach) {
    for (int i = 0; i < static_cast<int>(glib::CommandId::firstPrimitive); ++i) {
        const auto id = static_cast<glib::CommandId>(i);
        EXPECT_FALSE(glib::nameOf(id).empty())
            << "name " << i << " of CommandId has no row; the one before: "
            << (i == 0 ? "none" : glib::nameOf(static_cast<glib::CommandId>(i - 1)));
        EXPECT_NE(actionOf(allActions(), id), nullptr) << glib::nameOf(id);
    }
}

TEST_F(Statements, HaveASpecimenEachAndAllTheirKeys) {
    for (const glib::StatementRow& row : glib::statementTable()) {
        std::set<std::string> keys;
        bool found = false;
        for (const Specimen& each : kSpecimens) {
            const std::vector<Piece> pieces = piecesOf(each.line);
            if (pieces.front().text != row.name) continue;
            found = true;
            for (const Piece& piece : pieces) keys.insert(piece.text.substr(0, piece.text.find('.', 1)));
        }
        EXPECT_TRUE(found) << row.name;
        // Filters and wrap modes belong to the parser's test; one of each is enough here.
        if (row.syntax.find("$options") != std::string_view::npos || row.id == glib::CommandId::sampler)
            continue;
        for (const std::string& key : glib::syntaxOf(row).keys)
            EXPECT_TRUE(keys.contains(key)) << row.name << " " << key;
    }
}

TEST_F(Statements, AreRightAsTheyStand) {
    for (const Specimen& each : kSpecimens) {
        const Tried tried = tryPieces(each, piecesOf(each.line), 0);
        const bool wantsError = std::string_view(each.line).starts_with("Expect error");
        EXPECT_EQ(tried.errors.size(), wantsError ? 1U : 0U) << tried.scene << textsOf(tried.errors);
    }
}

TEST_F(Statements, ReportAnExpressionThatHasNoValueOnce) {
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        for (std::size_t i = 1; i < good.size(); ++i) {
            if (!good[i].isNumber && good[i].text.front() != '(') continue;
            for (const char* wrong : {"(nonesuch)", "(1 / 0)", "(0 / 0)", "(1 +)", "(inverse(mat3(0))[0].x)",
                                      "(speed.x.y)", "(nope(1))", "(sqrt(-1))", "(albedo)", "(1e400)"}) {
                std::vector<Piece> bad = good;
                bad[i].text = wrong;
                SCOPED_TRACE(wrong);
                // The value of a condition is asked for when the picture is there.
                const bool isLater = good[i].text.front() == '(' &&
                                     (good.front().text == "Expect" || good.front().text == "Print");
                const Tried tried = tryPieces(each, bad, i);
                // The body of a function has a value where it is called.
                if (good.front().text == "Let" && good[1].text == "square(x)")
                    EXPECT_EQ(tried.errors.size(), 1U) << tried.scene << textsOf(tried.errors);
                else if (!isLater || !tried.errors.empty())
                    expectThere(tried);
            }
            const bool takesMatrices =
                std::set<std::string>{"Set", "Group", "Draw", "Program", "Fill"}.contains(good.front().text);
            if (good[i].text.front() == '(' || takesMatrices) continue;
            // A matrix has too many components for every number; where components may follow each other,
            // the statement has too many of them.
            std::vector<Piece> bad = good;
            bad[i].text = "(model)";
            expectOne(tryPieces(each, bad, i));
        }
    }
}

TEST_F(Statements, ReportANumberOutOfRangeAtMostOnce) {
    std::set<std::string> reported;
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        for (std::size_t i = 1; i < good.size(); ++i) {
            if (!good[i].isNumber) continue;
            for (const char* extreme :
                 {"-1e300", "1e300", "-1", "0", "2147483648", "1e-300", "-.5", "4294967296"}) {
                for (const bool isExpression : {false, true}) {
                    std::vector<Piece> bad = good;
                    bad[i].text = isExpression ? "(" + std::string(extreme) + ")" : extreme;
                    const Tried tried = tryPieces(each, bad, i);
                    const bool wantsError = std::string_view(each.line).starts_with("Expect error");
                    EXPECT_LE(tried.errors.size(), wantsError ? 2U : 1U)
                        << tried.scene << textsOf(tried.errors);
                    if (!tried.errors.empty()) reported.insert(good.front().text);
                }
            }
        }
    }
    for (const char* word : {"Fps",       "Camera",         "Texture1D",      "Texture2D",
                             "Texture3D", "Texture1DArray", "Texture2DArray", "TextureRect",
                             "CubeMap",   "Sampler",        "Pass",           "Viewport",
                             "Scissor",   "State",          "Instances",      "Vertices",
                             "Buffer",    "Dispatch",       "Step",           "Expect"})
        EXPECT_TRUE(reported.contains(word)) << word;
}

TEST_F(Statements, SuggestTheNameThatWasMeant) {
    // The words that name something of the prelude, or one of a list that the interpreter knows.
    const std::set<std::string> meant{"sun",   "albedo",  "second", "shadow", "counts",  "points",
                                      "Flat",  "Count",   "part",   "mode",   "gold",    "normal",
                                      "rgba8", "rgba16f", "plain",  "toon",   "glib-E26"};
    std::set<std::string> tried;
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        for (std::size_t i = 1; i < good.size(); ++i) {
            const std::string& word = good[i].text;
            if (!meant.contains(word)) continue;
            // The value of a tag may be any word, which then names nothing.
            const bool isTag = good.front().text == "Set" || good.front().text == "Program";
            std::vector<Piece> bad = good;
            bad[i].text.insert(2, "q");
            const Tried found = tryPieces(each, bad, i);
            if (isTag) {
                EXPECT_LE(found.errors.size(), 1U) << found.scene << textsOf(found.errors);
                continue;
            }
            if (good.front().text == "Expect" && word == "glib-E26") continue;  // E26 itself follows
            expectThere(found);
            for (const Diagnostic& error : found.errors)
                EXPECT_NE(error.text.find("did you mean '" + word + "'"), std::string::npos) << error.text;
            tried.insert(word);
        }
    }
    EXPECT_GE(tried.size(), 12U);
}

TEST_F(Statements, ReportAMissingPieceOnce) {
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        for (std::size_t i = 1; i < good.size(); ++i) {
            std::vector<Piece> bad = good;
            bad.erase(bad.begin() + static_cast<std::ptrdiff_t>(i));
            if (good[i].text != "inline") expectNoFollowers(each, bad, i);
        }
    }
}

TEST_F(Statements, ReportAWordTwiceOrInAWrongPlaceOnce) {
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        for (std::size_t i = 1; i < good.size(); ++i) {
            if (good[i].text == "inline") continue;  // the shader's text would be statements
            for (const std::string instead :
                 {"nonesuch", "7", "[1 2]", "{1 0 0}", "<0 1 2>", "\"text\"", "twice"}) {
                std::vector<Piece> bad = good;
                if (instead == "twice")
                    bad.insert(bad.begin() + static_cast<std::ptrdiff_t>(i), good[i]);
                else
                    bad[i].text = instead;
                expectNoFollowers(each, bad, i);
            }
        }
    }
}

TEST_F(Statements, StandInsideTheirBlocks) {
    for (const glib::StatementRow& row : glib::statementTable()) {
        if (row.role != glib::BlockRole::closes && row.role != glib::BlockRole::divides) continue;
        const Tried alone = tryPieces({"", "Box\n"}, {{std::string(row.name)}}, 0);
        expectThere(alone);
        EXPECT_EQ(alone.errors.front().id, "glib-E21") << alone.scene;
    }
    for (const Specimen& each : kSpecimens) {
        const std::vector<Piece> good = piecesOf(each.line);
        const glib::StatementRow* row = glib::findStatement(good.front().text);
        if (row == nullptr || row->role != glib::BlockRole::opens) continue;
        const Tried open = tryPieces({each.line, "Box\n"}, good, 0);
        expectThere(open);
        EXPECT_EQ(open.errors.front().id, "glib-E22") << open.scene;
    }
}

TEST_F(Statements, OfNamesThatHaveAMeaningAreReportedOnce) {
    for (const glib::StatementRow& row : glib::statementTable()) {
        if (!row.declaresName) continue;
        for (const Specimen& each : kSpecimens) {
            std::vector<Piece> pieces = piecesOf(each.line);
            if (pieces.front().text != row.name) continue;
            for (const char* name : {"time", "pi", "albedo", "window", "model", "speed"}) {
                pieces[1].text = name;
                const Tried tried = tryPieces(each, pieces, 1, false);
                SCOPED_TRACE(name);
                expectThere(tried);
            }
        }
    }
}

}  // namespace
}  // namespace glibra::scene
