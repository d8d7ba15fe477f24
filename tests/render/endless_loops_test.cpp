// Which loops are said to never end (view-W02): those whose condition nothing can change.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "render/load/open_loops.h"

namespace glibra::test {
namespace {

std::size_t endless(const std::string& body, const std::string& functions = "") {
    glsl::TranslatedStage stage;
    stage.source = functions + "void main() { int m = 5, n = 3; int a[2]; ivec2 v; S s;\n" + body + "\n}\n";
    stage.lineMap.files = {"a.frag"};
    const auto lines = std::count(stage.source.begin(), stage.source.end(), '\n') + 1;
    for (int line = 1; line <= static_cast<int>(lines); ++line) stage.lineMap.lines.push_back({0, line});
    return render::endlessLoops(stage).size();
}

TEST(EndlessLoops, AreNotThoseWhoseConditionCounts) {
    for (const char* loop : {"while (m-- > 0) t++;",
                             "while (--m > 0) t++;",
                             "for (; m-- > 0;) t++;",
                             "while (0 < m--) t++;",
                             "while (m++ < 9) { t++; }",
                             "while (m > 0 && n-- > 0) t++;",
                             "while (m -= 1, m > 0) t++;",
                             "while (m--, m > 0) t++;",
                             "for (int i = 0; i++ < 3;) t++;",
                             "while (a[0]-- > 0) t++;",
                             "while (a[n - 1]-- > 0) t++;",
                             "while (v.x-- > 0) t++;",
                             "while (--v.y > 0) t++;",
                             "while (s.count-- > 0) t++;",
                             "while (s.parts[1].x-- > 0) t++;",
                             "while (m >>= 1) t++;",
                             "while (m > 0) t++, m--;",
                             "while (m > 0) { a[0] = 1; m -= 1; }",
                             "while (a[0] > 0) { a[0]--; }",
                             "while (v.x > 0) { v.x--; }",
                             "while (s.count > 0) { s.count = s.count - 1; }"})
        EXPECT_EQ(endless(loop), 0U) << loop;
}

TEST(EndlessLoops, AreNotThoseWhoseCallsChangeWhatIsTested) {
    EXPECT_EQ(endless("while (m > 0) { less(m); t++; }"), 0U);
    EXPECT_EQ(endless("while (left > 0) step();", "int left = 5;\nvoid step() { left--; }\n"), 0U);
    EXPECT_EQ(endless("while (left > 0) far();",
                      "int left = 5;\nvoid step() { left -= 1; }\nvoid far() { step(); }\n"),
              0U);
    EXPECT_EQ(endless("while (flag == 0) { memoryBarrierBuffer(); }"), 0U);
}

TEST(EndlessLoops, AreThoseThatNothingEnds) {
    for (const char* loop :
         {"while (true) { t += 1; }", "while (m > 0) t++;", "for (int i = 0; i < 3; ) t++;",
          "while (m > 0) { n--; }", "while (a[0] > n) { t = a[0]; }", "while (v.x > 0) { t = v.x + 1; }",
          "while (m == 5) { t = n - m; }", "while (m > 0) { t += far(n - 1); }"})
        EXPECT_EQ(endless(loop, "int far(int n) { return n; }\n"), 1U) << loop;
}

}  // namespace
}  // namespace glibra::test
