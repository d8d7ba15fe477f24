// Reading OBJ text: every rule of the language, 8, and its messages.

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/obj/obj_model.h"

namespace glibra::geometry {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Result<ObjModel> parseObjText(std::string_view text) {
    return parseObj(text, "models/tree.obj");
}

std::vector<std::string> idsOf(const Diagnostics& diagnostics) {
    std::vector<std::string> ids;
    for (const Diagnostic& each : diagnostics) ids.push_back(each.id);
    return ids;
}

std::vector<std::uint32_t> positionsOf(const ObjModel& model) {
    std::vector<std::uint32_t> all;
    for (const ObjCorner& corner : model.corners) all.push_back(corner.position);
    return all;
}

TEST(ObjParser, ReadsPositionsTexCoordsNormalsAndFaces) {
    const auto model = parseObjText(
        "v 1 2 3\nv 4 5 6 7 8\nv -1 -.5 +2\nvt .25\nvt .5 .75\nvt 1 2 3\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1\n");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    EXPECT_EQ(model->positions, (std::vector<std::array<float, 3>>{{1, 2, 3}, {4, 5, 6}, {-1, -.5F, 2}}));
    EXPECT_EQ(model->texCoords, (std::vector<std::array<float, 3>>{{.25F, 0, 0}, {.5F, .75F, 0}, {1, 2, 3}}));
    EXPECT_EQ(model->normals, (std::vector<std::array<float, 3>>{{0, 0, 2}}));
    EXPECT_EQ(model->corners, (std::vector<ObjCorner>{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}));
    EXPECT_EQ(model->faceStarts, (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(model->triangleCount(), 1U);
}

TEST(ObjParser, TakesAllFourFormsOfCorners) {
    const auto model = parseObjText(
        std::string(kTriangle) +
        "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf 1/ 2// 3//1\n");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    EXPECT_EQ(model->faceCount(), 5U);
    EXPECT_EQ(model->corners[0], (ObjCorner{0, kNoIndex, kNoIndex}));
    EXPECT_EQ(model->corners[4], (ObjCorner{1, 0, kNoIndex}));
    EXPECT_EQ(model->corners[8], (ObjCorner{2, kNoIndex, 0}));
    EXPECT_EQ(model->corners[9], (ObjCorner{0, 0, 0}));
    EXPECT_EQ(model->corners[13], (ObjCorner{1, kNoIndex, kNoIndex}));
    EXPECT_EQ(model->corners[14], (ObjCorner{2, kNoIndex, 0}));
}

TEST(ObjParser, NegativeIndicesCountFromWhatStandsAbove) {
    const auto model = parseObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -3 -2 -1\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(positionsOf(*model), (std::vector<std::uint32_t>{0, 1, 2, 1, 2, 3}));
}

TEST(ObjParser, PositiveIndicesMayPointFurtherDown) {
    const auto model = parseObjText("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    EXPECT_EQ(positionsOf(*model), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(ObjParser, DropsFacesWithIndicesOutOfRange) {
    const auto model =
        parseObjText(std::string(kTriangle) +
                     "f 1 2 912\nf 1 2 -4\nf 0 1 2\nf 1/7 2/7 3/7\nf 1//2 2//2 3//2\nf 1 2 x\nf 1 2 3\n"
                     "f 1 2 99999999999999999999\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->faceCount(), 1U);
    EXPECT_EQ(positionsOf(*model), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(idsOf(model.diagnostics), std::vector<std::string>(7, "file-W05"));
    EXPECT_EQ(model.diagnostics[0].text, "face dropped: vertex 912 does not exist");
    EXPECT_EQ(model.diagnostics[0].place, (Place{"models/tree.obj", 4, 1}));
    EXPECT_EQ(model.diagnostics[1].text, "face dropped: vertex -4 does not exist");
    EXPECT_EQ(model.diagnostics[3].text, "face dropped: texture coordinate 7 does not exist");
    EXPECT_EQ(model.diagnostics[4].text, "face dropped: normal 2 does not exist");
    EXPECT_EQ(model.diagnostics[5].text, "face dropped: 'x' is not an index");
}

TEST(ObjParser, DropsFacesOfFewerThanThreeCorners) {
    const auto model = parseObjText(std::string(kTriangle) + "f 1 2\nf\nf 1\nf 1 2 3\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->faceCount(), 1U);
    EXPECT_EQ(idsOf(model.diagnostics), std::vector<std::string>(3, "file-W05"));
    EXPECT_EQ(model.diagnostics[0].text, "face dropped: only 2 corners");
    EXPECT_EQ(model.diagnostics[2].text, "face dropped: only 1 corner");
}

TEST(ObjParser, IgnoresMeaninglessLinesWithoutAWord) {
    const auto model = parseObjText("# a\nmtllib a.mtl\no x\ng\ns off\nusemtl wood\n\n   \n" +
                                    std::string(kTriangle) + "f 1 2 3 # last\n");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
}

TEST(ObjParser, NamesEveryUnknownWordOnce) {
    const auto model = parseObjText(std::string(kTriangle) + "l 1 2\nl 2 3\np 1\ncurv 0 1\nl 3 1\nf 1 2 3\n");
    ASSERT_TRUE(model);
    ASSERT_EQ(idsOf(model.diagnostics), std::vector<std::string>(3, "file-W04"));
    EXPECT_EQ(model.diagnostics[0].text, "3 'l' lines ignored");
    EXPECT_EQ(model.diagnostics[0].place.line, 4);
    EXPECT_EQ(model.diagnostics[1].text, "1 'p' line ignored");
    EXPECT_EQ(model.diagnostics[2].text, "1 'curv' line ignored");
}

TEST(ObjParser, MalformedNumbersAreTheirPrefixOrZero) {
    const auto model = parseObjText("v 1.2.3 abc 1e400\nv inf nan 0x10\nv 1,5 - .\nf 1 2 3\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->positions, (std::vector<std::array<float, 3>>{{1.2F, 0, 0}, {0, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(idsOf(model.diagnostics), std::vector<std::string>(9, "file-W06"));
    EXPECT_EQ(model.diagnostics[0].text, "'1.2.3' read as 1.2");
    EXPECT_EQ(model.diagnostics[0].place.column, 3);
    EXPECT_EQ(model.diagnostics[1].text, "'abc' read as 0");
}

TEST(ObjParser, NumbersMayHaveExponentsSignsAndBareDots) {
    const auto model =
        parseObjText("v 1e3 -1.5E-2 +.25\nv 5. 1e-60 -1e-300\nv 3.4e38 1e-400 00012\nf 1 2 3\n");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
    EXPECT_EQ(model->positions,
              (std::vector<std::array<float, 3>>{{1000, -.015F, .25F}, {5, 0, 0}, {3.4e38F, 0, 12}}));
}

TEST(ObjParser, MissingNumbersAreZero) {
    const auto model = parseObjText("v 1 2\nv\nv 1 2 3\nvt\nf 1 2 3\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->positions, (std::vector<std::array<float, 3>>{{1, 2, 0}, {0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(idsOf(model.diagnostics), std::vector<std::string>(3, "file-W06"));
}

TEST(ObjParser, AcceptsAnyLineEndsBlanksAndJoins) {
    const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto expected = parseObjText(plain);
    for (const char* end : {"\r\n", "\r", "\n\n", "  \t\n \v", "\f\n"}) {
        std::string text;
        for (const char c : plain) text += c == '\n' ? std::string(end) : std::string(1, c);
        const auto model = parseObjText(text);
        ASSERT_TRUE(model);
        EXPECT_TRUE(model.diagnostics.empty());
        EXPECT_EQ(model->positions, expected->positions);
        EXPECT_EQ(model->corners, expected->corners);
    }
    for (const char* text : {"v 0 0 \\\n0\nv 1 \\\r\n 0 0\nv 0 1 0\nf 1 \\  \n2\\\n 3",
                             "v 0 0 0\nv 1 0 0\nv 0\\\n\\\n 1 0\nf\\\r1 2 3\\"}) {
        const auto model = parseObjText(text);
        ASSERT_TRUE(model);
        EXPECT_TRUE(model.diagnostics.empty());
        EXPECT_EQ(model->positions, expected->positions);
        EXPECT_EQ(model->corners, expected->corners);
    }
}

TEST(ObjParser, JoinedLinesAreCounted) {
    const auto model = parseObjText(std::string(kTriangle) + "g a \\\n b\n# no join \\\nl 1\nf 1 2 3\n");
    ASSERT_TRUE(model);
    ASSERT_EQ(model.diagnostics.size(), 1U);
    EXPECT_EQ(model.diagnostics[0].place.line, 7);
}

TEST(ObjParser, SkipsTheByteOrderMark) {
    const auto model = parseObjText("\xef\xbb\xbf" + std::string(kTriangle) + "f 1 2 3");
    ASSERT_TRUE(model);
    EXPECT_TRUE(model.diagnostics.empty());
}

TEST(ObjParser, AFileWithoutFacesIsAnError) {
    for (const char* text : {"", "v 0 0 0\n", "hello\nworld", "f 1 2 3"}) {
        const auto model = parseObjText(text);
        EXPECT_FALSE(model);
        ASSERT_FALSE(model.diagnostics.empty());
        EXPECT_EQ(model.diagnostics.back().id, "file-E07");
        EXPECT_EQ(model.diagnostics.back().text, "'tree.obj' has no faces");
        EXPECT_EQ(model.diagnostics.back().severity, Severity::error);
    }
}

TEST(ObjParser, RecognisesACompilersObjectFile) {
    using namespace std::string_literals;
    for (const std::string& start : {"\x4c\x01\x05\0\0\0"s, "\x64\x86\x02\0"s,
                                     "\x7f"
                                     "ELF\x02\x01\x01\0"s,
                                     "\xcf\xfa\xed\xfe\0"s, "\0\0\xff\xff\0"s}) {
        const auto model = parseObjText(start + std::string(600, '\0'));
        EXPECT_FALSE(model);
        ASSERT_EQ(idsOf(model.diagnostics), std::vector<std::string>{"file-E08"});
        EXPECT_EQ(model.diagnostics[0].text, "'tree.obj' is a compiler's object file, not a model");
    }
    // A text may begin with the same letters.
    EXPECT_TRUE(parseObjText("L\x01\n" + std::string(kTriangle) + "f 1 2 3"));
}

TEST(ObjParser, TooManyTrianglesAreAnErrorBeforeTheyAreStored) {
    std::string text = kTriangle;
    std::string face = "f";
    for (int i = 0; i < 1 << 20; ++i) face += " 1 2 3 1";
    face += '\n';
    for (int i = 0; i < 4; ++i) text += face;
    text += "f 1 2 3 1 2 3 1 2 3 1 2\n";
    const auto model = parseObjText(text);
    EXPECT_FALSE(model);
    ASSERT_EQ(idsOf(model.diagnostics), std::vector<std::string>{"file-E09"});
    EXPECT_NE(model.diagnostics[0].text.find("16,777,216"), std::string::npos);
}

TEST(ObjParser, MessagesOfAKindAreLimited) {
    std::string text = kTriangle;
    for (int i = 0; i < 2000; ++i) text += "f 1 2\nv x 0 0\nword" + std::to_string(i) + "\n";
    const auto model = parseObjText(text + "f 1 2 3");
    ASSERT_TRUE(model);
    EXPECT_EQ(model.diagnostics.size(), 303U);
    EXPECT_EQ(model.diagnostics[301].text, "1,900 more of this kind");
    for (const Diagnostic& each : model.diagnostics) EXPECT_LT(each.text.size(), 100U);
}

TEST(ObjParser, LongAndBinaryWordsAreShownShort) {
    const auto model = parseObjText(std::string(kTriangle) + std::string(5000, 'w') + "\nx\x01y 1\nf 1 2 3");
    ASSERT_TRUE(model);
    ASSERT_EQ(model.diagnostics.size(), 2U);
    EXPECT_LT(model.diagnostics[0].text.size(), 80U);
    EXPECT_EQ(model.diagnostics[1].text, "1 'x?y' line ignored");
}

}  // namespace
}  // namespace glibra::geometry
