// The command table: every word of existing scenes, and rows that agree with each other.

#include "glib/syntax.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "base/suggest.h"
#include "geometry/shapes/primitive.h"
#include "glib/limits.h"

namespace glibra::glib::test {
namespace {

/// The words that scenes have used since glman. None may vanish. New commands need not be added.
constexpr const char* kWords =
    "WindowSize Perspective Persp Ortho LookAt Color Colour Background Clear Translate Rotate Scale "
    "PushMatrix TransformBegin "
    "PopMatrix TransformEnd Box Cube Sphere Cylinder Cone Torus Teapot Soccerball DiskXY QuadXY QuadXZ "
    "QuadYZ QuadBox Xarrow "
    "PointCloud JitterCloud WireSphere WireTorus WireCylinder WireCone WireCube WireBox WireTeapot Obj "
    "WireObj ObjAdj ObjPatch "
    "Shp LinesAdjacency Triangles glBegin glVertex glNormal glColor glTexCoord glEnd LineWidth PointSize "
    "PointSizeMode "
    "NumPatchVertices Flat Smooth Texture1D Texture2D Texture3D Texture CubeMap RenderToTexture Clamp Vertex "
    "TessControl "
    "TessEvaluation Geometry Fragment Program GeometryInput GeometryInputType GeometryOutput "
    "GeometryOutputType "
    "GeometryVerticesOut GSTAP gstap.h Noise2D Noise3D Timer MessageBox Verbose";

TEST(CommandTable, KnowsTheWordsOfExistingScenes) {
    std::istringstream words(kWords);
    for (std::string word; words >> word;) EXPECT_NE(findCommand(word), nullptr) << word;
}

TEST(CommandTable, HasEveryWordOnce) {
    std::set<std::string> found;
    for (const StatementRow& row : commandTable())
        for (const std::string_view name : row.names())
            if (!name.empty()) {
                EXPECT_TRUE(found.insert(std::string(name)).second) << name;
            }
}

TEST(CommandTable, HasOneRowPerId) {
    std::set<int> ids;
    for (const StatementRow& row : commandTable()) {
        EXPECT_TRUE(ids.insert(static_cast<int>(row.id)).second) << row.name;
        EXPECT_EQ(commandOf(row.name), row.id);
    }
    for (const StatementRow& row : statementTable()) {
        // The stages and Program have one id for both forms.
        if (const StatementRow* classic = findCommand(row.name); classic && classic->id == row.id) continue;
        EXPECT_TRUE(ids.insert(static_cast<int>(row.id)).second) << row.name;
    }
    ASSERT_FALSE(ids.empty());
    EXPECT_EQ(*ids.begin(), 0);
    EXPECT_EQ(*ids.rbegin(), static_cast<int>(ids.size()) - 1);
}

TEST(CommandTable, StatementsOfTheFrameAloneDoNotRestartASimulation) {
    for (const char* word : {"Sphere", "Obj", "Translate", "Background", "MessageBox"})
        EXPECT_FALSE(restartsSimulation(commandOf(word))) << word;
    for (const CommandId id :
         {CommandId::draw, CommandId::pass, CommandId::clearParts, CommandId::dispatch, CommandId::expect})
        EXPECT_FALSE(restartsSimulation(id)) << nameOf(id);
    for (const CommandId id : {CommandId::color, CommandId::clear, CommandId::program, CommandId::let,
                               CommandId::buffer, CommandId::namedTexture2D, CommandId::step})
        EXPECT_TRUE(restartsSimulation(id)) << nameOf(id);
}

TEST(CommandTable, TakesPrimitivesFromGeometry) {
    for (const geometry::PrimitiveSpec* each : geometry::primitives()) {
        const StatementRow* row = findCommand(each->names[0]);
        ASSERT_NE(row, nullptr) << each->names[0];
        EXPECT_EQ(primitiveOf(row->id), each) << row->name;
        const auto arguments = argumentsOf(*row);
        EXPECT_LE(arguments.size(), each->arguments.size()) << row->name;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            EXPECT_EQ(arguments[i]->text, each->arguments[i].name) << row->name;
            EXPECT_EQ(arguments[i]->byDefault, each->arguments[i].byDefault) << row->name;
            EXPECT_EQ(arguments[i]->low, each->arguments[i].least) << row->name;
            EXPECT_EQ(arguments[i]->high, each->arguments[i].most) << row->name;
        }
        for (std::size_t i = arguments.size(); i < each->arguments.size(); ++i)
            EXPECT_TRUE(each->arguments[i].isFixed) << row->name;
    }
    EXPECT_EQ(primitiveOf(CommandId::obj), nullptr);
}

TEST(CommandTable, EveryRowAndArgumentIsDescribed) {
    for (const StatementRow& row : commandTable()) {
        EXPECT_FALSE(row.summary.empty()) << row.name;
        for (const SyntaxNode* each : argumentsOf(row)) EXPECT_FALSE(each->text.empty()) << row.name;
        EXPECT_EQ(lastTypeOf(row) == ValueType::oneOf, !wordsOf(row).empty()) << row.name;
    }
}

TEST(CommandTable, DefaultsObeyTheirOwnRanges) {
    for (const StatementRow& row : commandTable())
        for (const SyntaxNode* each : argumentsOf(row)) {
            if (!each->byDefault) continue;
            if (each->type == ValueType::count || each->type == ValueType::integer) {
                EXPECT_GE(*each->byDefault, each->low) << row.name << ' ' << each->text;
                EXPECT_LE(*each->byDefault, each->high) << row.name << ' ' << each->text;
            }
        }
}

TEST(CommandTable, StatesLimitsDefaultsAndUnitsInTheNotation) {
    const SyntaxNode& angle = *argumentsOf(*findCommand("Perspective"))[0];
    EXPECT_EQ(angle.type, ValueType::between);
    EXPECT_EQ(angle.byDefault, 50);
    EXPECT_EQ(std::pair(angle.low, angle.high), std::pair(0., 180.));
    EXPECT_EQ(angle.measure, "degrees");
    const SyntaxNode& green = *argumentsOf(*findCommand("Background"))[1];
    EXPECT_EQ(green.byDefault, kDefaultBackground[1]);
    EXPECT_EQ(green.filler, 0);
    const SyntaxNode& depth = *argumentsOf(*findCommand("Texture3D"))[3];
    EXPECT_TRUE(depth.isSkippable);
    EXPECT_EQ(std::pair(depth.low, depth.high), std::pair(1., kLargestVolumeSide));
    const SyntaxNode& width = *argumentsOf(*findCommand("LineWidth"))[0];
    EXPECT_FALSE(width.byDefault || width.filler);
    EXPECT_EQ(width.high, std::numeric_limits<double>::infinity());
    EXPECT_EQ(argumentsOf(*findCommand("CubeMap"))[1]->most, 6U);
}

TEST(CommandTable, FindsAliasesInAnyCase) {
    ASSERT_TRUE(findCommand("transformBEGIN"));
    EXPECT_EQ(findCommand("transformBEGIN")->id, CommandId::pushMatrix);
    EXPECT_EQ(findCommand("Cube")->id, glib::commandOf("Box"));
    EXPECT_EQ(findCommand("GSTAP.H")->id, CommandId::gstap);
    EXPECT_FALSE(findCommand(""));
    EXPECT_FALSE(findCommand("Spere"));
    EXPECT_FALSE(findCommand("Texture4D"));
}

TEST(StatementTable, WordsAreApartFromClassicOnesExceptWhereTheArgumentsDecide) {
    std::string shared;
    for (const StatementRow& row : statementTable()) {
        EXPECT_EQ(findStatement(row.name) == nullptr, row.sharesWord()) << row.name;
        EXPECT_EQ(modernFormOf(row.name) == nullptr, !row.sharesWord()) << row.name;
        EXPECT_EQ(statementOf(row.id), &row) << row.name;
        EXPECT_FALSE(row.summary.empty()) << row.name;
        if (row.sharesWord()) shared.append(row.name).append(" ");
    }
    EXPECT_EQ(
        shared,
        "Vertex TessControl TessEvaluation Geometry Fragment Program Texture1D Texture2D Texture3D CubeMap "
        "Clear ");
    EXPECT_EQ(findStatement("ENDpass")->id, CommandId::endPass);
    EXPECT_EQ(findStatement("Box"), nullptr);
    EXPECT_EQ(findStatement(""), nullptr);
}

TEST(StatementTable, ShowsUsageAndWords) {
    EXPECT_EQ(usage(*findStatement("Camera")).substr(0, 40), "Camera name[count] (LookAt view x9 (Pers");
    EXPECT_EQ(usage(*findStatement("Repeat")), "Repeat (count | words) {until (condition) | as counter}");
    EXPECT_EQ(usage(*findStatement("EndPass")), "EndPass");
    const std::vector<std::string> words = wordsOf(*findStatement("State"));
    for (const char* word : {"cull", "blend", "src_alpha", "notequal", "incr_wrap", "alphatocoverage"})
        EXPECT_NE(std::find(words.begin(), words.end(), word), words.end()) << word;
    EXPECT_EQ(wordLists(*findStatement("Vertices")).at(0).words.size(), 15U);
}

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(base::editDistance("", ""), 0U);
    EXPECT_EQ(base::editDistance("", "abc"), 3U);
    EXPECT_EQ(base::editDistance("abc", ""), 3U);
    EXPECT_EQ(base::editDistance("kitten", "sitting"), 3U);
    EXPECT_EQ(base::editDistance("Spehre", "sphere"), 1U);  // neighbours exchanged
    EXPECT_EQ(base::editDistance("flaw", "lawn"), 2U);
    EXPECT_EQ(base::editDistance("ca", "abc"), 3U);  // no byte is edited twice
}

TEST(EditDistance, IsSymmetric) {
    for (const char* a : {"Sphere", "Cone", "glVertex", ""})
        for (const char* b : {"Spere", "Cylinder", "xgl", "Cnoe"})
            EXPECT_EQ(base::editDistance(a, b), base::editDistance(b, a));
}

TEST(NearestName, IsTheNearestOrNothing) {
    constexpr std::string_view kNames[] = {"uShrink", "uKa", "uKd", "Sphere", "uA"};
    EXPECT_EQ(base::nearestName("ushrink", kNames), "uShrink");
    EXPECT_EQ(base::nearestName("uShrnik", kNames), "uShrink");
    EXPECT_EQ(base::nearestName("Spere", kNames), "Sphere");
    EXPECT_EQ(base::nearestName("uKs", kNames), "uKa");
    EXPECT_EQ(base::nearestName("uB", kNames), "");
    EXPECT_EQ(base::nearestName("Tetrahedron", kNames), "");
    EXPECT_EQ(base::nearestName("", kNames), "");
    EXPECT_EQ(base::nearestName(std::string(100, 'u'), kNames), "");
}

TEST(NearestCommand, IsSpelledAsInTheTable) {
    EXPECT_EQ(nearestCommand("spere"), "Sphere");
    EXPECT_EQ(nearestCommand("Cylindre"), "Cylinder");
    EXPECT_EQ(nearestCommand("PushMatirx"), "PushMatrix");
    EXPECT_EQ(nearestCommand("Dodecahedron"), "");
}

}  // namespace
}  // namespace glibra::glib::test
