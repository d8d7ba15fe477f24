// Suite files with random damage never crash the reader, and every error has a place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glib/messages.h"
#include "suite/file/selection.h"
#include "suite/file/suite_file.h"
#include "suite_text.h"

namespace glibra::suite::test {
namespace {

constexpr std::string_view kWhole = R"(# Every key there is.
goldens = "gold"

[defaults]
size = [200, 100]
samples = 2
set = { uKd = 0.5, uColor = [1, 0.5, 0] }
tolerance = { max = 2, fraction = 0.001, bias = 0.5 }
tags = ["all"]

[[shot]]
script = "a.glib"
name = "left/a"
time = [0, 0.5]
set = { uOn = true, "ä" = 1 }
view = "glman"
timeout = 3.5
library = "n"

[[shot]]
script = ["n/*.glib", "b.glib"]
except = "n/y.glib"
name = "several"
sweep = { uTol = [0, 0.1, 0.2], light.color = [[1, 0, 0], "{0 1 0}"] }
axes = true
float = false

[[shot]]
script = "a.glib"
name = "pair"
match = "left/a@time=0.5"
differ = "several/b@uTol=0@light.color=1,0,0"
golden = false

[[shot]]
script = "b.glib"
name = "wrong"
strict = true
expect-error = { id = "glib-E01", text = "unknown", line = 5 }
)";

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& each : lines) text += (&each == &lines.front() ? "" : "\n") + each;
    return text;
}

class Mutator {
  public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::string mutate(std::string text) {
        for (std::size_t left = 1 + below(3); left > 0; --left) once(text);
        return text;
    }

  private:
    std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

    void once(std::string& text) {
        static constexpr std::string_view kPieces[] = {"\"",
                                                       "'",
                                                       "[",
                                                       "]",
                                                       "[[",
                                                       "]]",
                                                       "{",
                                                       "}",
                                                       "=",
                                                       ",",
                                                       "\n",
                                                       "#",
                                                       "-",
                                                       ".",
                                                       "1e99",
                                                       "nan",
                                                       "inf",
                                                       "true",
                                                       "99999999999",
                                                       "0x7fffffffffffffff",
                                                       "''",
                                                       "\"\"",
                                                       "..",
                                                       "/",
                                                       "@",
                                                       "\\",
                                                       "\xff",
                                                       "\xc3",
                                                       "\xe2\x80\xa8",
                                                       std::string_view("\0", 1),
                                                       "1979-05-27",
                                                       "[[shot]]",
                                                       "[shot]",
                                                       "set.x = 1",
                                                       "\r",
                                                       "\t",
                                                       "\"\"\"",
                                                       "shot = 3",
                                                       "*",
                                                       "["};
        const std::size_t at = below(text.size());
        switch (below(7)) {
            case 0:
                text.erase(at, 1 + below(3));
                break;
            case 1:
                text.insert(at, kPieces[below(std::size(kPieces))]);
                break;
            case 2:
                if (!text.empty()) text[at] = static_cast<char>(below(256));
                break;
            case 3:
                text.resize(at);
                break;
            default: {
                std::vector<std::string> lines = linesOf(text);
                std::string& one = lines[below(lines.size())];
                std::string& other = lines[below(lines.size())];
                if (below(2) == 0)
                    std::swap(one, other);
                else
                    one = std::string(other);
                text = joined(lines);
            }
        }
    }

    std::mt19937 random_;
};

TEST(SuiteMutation, GivesAPlaceOrASuiteAndNeverCrashes) {
    const SceneFolder folder{"a.glib", "b.glib", "n/x.glib", "n/y.glib"};
    const std::string whole(kWhole);
    const auto unharmed = folder.read(whole);
    // "ä" is not a valid name of a uniform. Without it the suite is correct.
    ASSERT_EQ(folder.shown(unharmed), "15:21 suite-E05 set: '\xc3\xa4' is not the name of a uniform\n");
    std::string base = whole;
    base.replace(base.find("\"ä\""), 4, "uA");
    ASSERT_TRUE(folder.read(base)) << folder.show(base);

    Mutator mutator(20);
    std::set<std::string> ids;
    int good = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string text = mutator.mutate(i % 4 == 0 ? whole : base);
        SCOPED_TRACE(text);
        const auto suite = folder.read(text);
        ASSERT_NE(suite.value.has_value(), hasError(suite.diagnostics));
        const std::vector<std::string> lines = linesOf(text);
        for (const Diagnostic& each : suite.diagnostics) {
            if (each.severity == Severity::note) continue;
            ids.insert(each.id);
            ASSERT_TRUE(glib::findDiagnostic(each.id)) << each.id;
            ASSERT_EQ(each.place.file, (folder.path() / "s.toml").string());
            ASSERT_GE(each.place.line, 1) << each.text;
            ASSERT_LE(static_cast<std::size_t>(each.place.line), lines.size()) << each.text;
            ASSERT_GE(each.place.column, 1) << each.text;
            ASSERT_LE(static_cast<std::size_t>(each.place.column),
                      lines[static_cast<std::size_t>(each.place.line) - 1].size() + 1)
                << each.text;
            ASSERT_FALSE(each.text.empty());
        }
        if (!suite) continue;
        ++good;
        std::size_t selected = 0;
        for (int part = 1; part <= 3; ++part) selected += select(*suite, {}, {part, 3}).size();
        ASSERT_EQ(selected, suite->shots.size());
    }
    EXPECT_GT(good, 100);
    EXPECT_GT(ids.size(), 9U) << "the mutations have become too tame";
}

TEST(SuiteMutation, SurvivesTextsThatNestWithoutEnd) {
    const SceneFolder folder{"a.glib"};
    const auto repeated = [](std::string_view piece, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += piece;
        return all;
    };
    for (const std::string& text :
         {"x = " + repeated("[", 100'000), "x = " + repeated("{a=", 100'000),
          "[a" + repeated(".a", 200'000) + "]", "[[shot]]\nset.a" + repeated(".'b = .'", 200'000) + " = 1",
          "[[shot]]\nset.a" + repeated(" . \"\\\",\" ", 200'000) + " = 1",
          "# " + repeated(".", 100) + "\nx = \"\"\"\n" + repeated(".", 100) + "\"\"\"\ny" +
              repeated(".y", 200'000),
          "x = " + repeated("{" + repeated("a.", 14) + "a=", 200)}) {
        const auto suite = folder.read(text);
        ASSERT_EQ(suite.diagnostics.size(), 1U) << text.substr(0, 40);
        EXPECT_EQ(suite.diagnostics[0].id, "suite-E01") << text.substr(0, 40);
    }
    // The same number of dots outside of keys is allowed.
    EXPECT_EQ(folder.show("# " + repeated(".", 100) + "\n[[shot]]\nscript = 'a.glib'\nset = { uA = '1" +
                          repeated(" .5", 100) + "', uB = [" + repeated("0.5, ", 100) + "] }\n"),
              "a\n");
}

}  // namespace
}  // namespace glibra::suite::test
