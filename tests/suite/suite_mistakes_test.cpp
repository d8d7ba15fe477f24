// Wrong suite files: every mistake is reported with its place, its id and a way to correct it.

#include <gtest/gtest.h>

#include <cstddef>
#include <ostream>
#include <string>

#include "glib/messages.h"
#include "suite/file/suite_file.h"
#include "suite_text.h"

namespace glibra::suite::test {
namespace {

struct Mistake {
    const char* name;
    std::string text;
    std::string message;  ///< "line:column id text" per message, one per line
};

// GoogleTest needs this name.
void PrintTo(const Mistake& mistake, std::ostream* to) {
    *to << mistake.name;
}

class SuiteMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SuiteMistake, IsReportedWithItsPlace) {
    const SceneFolder folder{"teapot.glib", "start/cow.glib"};
    const auto suite = folder.read(GetParam().text);
    EXPECT_FALSE(suite);
    EXPECT_EQ(folder.shown(suite), GetParam().message);
    for (const Diagnostic& each : suite.diagnostics) {
        EXPECT_EQ(each.severity, Severity::error);
        EXPECT_TRUE(glib::findDiagnostic(each.id)) << each.id;
        EXPECT_EQ(each.place.file, (folder.path() / "s.toml").string());
    }
}

/// A shot of the teapot with one more line, which is line 3.
std::string shot(const std::string& line) {
    return "[[shot]]\nscript = \"teapot.glib\"\n" + line + "\n";
}

INSTANTIATE_TEST_SUITE_P(
    All, SuiteMistake,
    testing::Values(
        Mistake{"HalfAWord", "[[shot]]\nx = tru\n",
                "2:8 suite-E01 not TOML: boolean: expected 'true', saw 'tru '; a text needs quotes, as "
                "\"teapot.glib\"\n"},
        Mistake{"NestedTooDeep", "x = " + std::string(400, '[') + std::string(400, ']') + "\n",
                "1:261 suite-E01 not TOML: arrays and tables stand too deep in each other\n"},
        Mistake{"TextWithoutQuotes", "[[shot]]\nscript = teapot.glib\n",
                "2:11 suite-E01 not TOML: boolean: expected 'true', saw 'te'; a text needs quotes, as "
                "\"teapot.glib\"\n"},
        Mistake{"SizeWithoutQuotes", shot("size = 64x48"),
                "3:10 suite-E01 not TOML: decimal integer: expected digit, saw 'x'; a text needs quotes, as "
                "\"teapot.glib\"\n"},
        Mistake{"CurlyQuotes", "[[shot]]\nscript = \xe2\x80\x9cteapot.glib\xe2\x80\x9d\n",
                "2:10 suite-E01 not TOML: value: could not determine value type; a text stands between plain "
                "quotes, as \"teapot.glib\"\n"},
        Mistake{"OpenQuote", "[[shot]]\nscript = \"teapot.glib\n",
                "2:22 suite-E01 not TOML: string: unescaped control characters other than TAB (U+0009) are "
                "explicitly prohibited; the closing quote is missing\n"},
        Mistake{"TrueInCapitals", shot("strict = True"),
                "3:10 suite-E01 not TOML: boolean: expected 'true', saw 'T'; true and false are written in "
                "small letters\n"},
        Mistake{"Colon", "[[shot]]\nscript: 'teapot.glib'\n",
                "2:7 suite-E01 not TOML: key-value pair: expected '=', saw ':'; a key and its value have '=' "
                "between them\n"},
        Mistake{"BracesOverTwoLines", shot("set = { uKd = 0.1\n uKs = 0.2 }"),
                "3:18 suite-E01 not TOML: inline table: expected key or closing '}', saw '\\n'; a table in "
                "braces "
                "stands on one line; of a long one each key gets a line: set.uKd = 0.5\n"},
        Mistake{"Syntax", "[[shot]\n", "1:8 suite-E01 not TOML: table header: expected ']', saw '\\n'\n"},
        Mistake{"PointWithoutDigit", shot("set = { uKd = .5 }"),
                "3:15 suite-E01 not TOML: floating-point: expected decimal digit, saw '.'; a number needs a "
                "digit "
                "before its "
                "point, as 0.5\n"},
        Mistake{
            "WrongView",
            shot("eye-transform = [1, 2]\nprojection = 'flat'\nbackground = [1, 'a', 0]\n"
                 "object-transform = { teapot = [1] }"),
            "3:17 suite-E03 eye-transform: expected a list of 16 numbers, column by column, found a list\n"
            "4:14 suite-E03 projection: expected \"scene\", \"perspective\" or \"orthographic\", found the "
            "text 'flat'\n"
            "5:18 suite-E03 background: expected a number, found the text 'a'\n"
            "6:22 suite-E04 object-transform: 'teapot' is not the number of a line of the scene\n"},
        Mistake{"KeyTwice", shot("time = 1\ntime = 2"),
                "4:8 suite-E01 not TOML: key-value pair: cannot redefine existing integer 'time'\n"},
        Mistake{"UnknownKey", shot("sise = [8, 8]"),
                "3:1 suite-E02 unknown key 'sise' in [[shot]]; did you mean 'size'?\n"},
        Mistake{"UnknownTopKey", "golden = 'x'\n" + shot(""),
                "1:1 suite-E02 'golden' belongs under [defaults] or [[shot]]\n"},
        Mistake{"UnknownTopKeyNear", "goldnes = 'x'\n" + shot(""),
                "1:1 suite-E02 unknown key 'goldnes' at the top of the file; did you mean 'goldens'?\n"},
        Mistake{"AddressOfGoldens", "goldens = 'https://a.example/{hash}.png'\n" + shot(""),
                "1:11 suite-E04 goldens: expected a folder, found 'https://a.example/{hash}.png'; 'store' "
                "takes the address of their pictures\n"},
        Mistake{"StoreOfAnotherKind", "store = 's3://bucket/{hash}.png'\n" + shot(""),
                "1:9 suite-E04 store: expected a folder, or an address that begins with https://, as buckets "
                "have one, too, found 's3://bucket/{hash}.png'\n"},
        Mistake{"StoreWithoutAHash", "store = 'https://a.example/goldens'\n" + shot(""),
                "1:9 suite-E04 store: expected {hash} once, after the last '/', as in "
                "\"https://host/place/{hash}.png\", found 'https://a.example/goldens'\n"},
        Mistake{"ShotKeyInDefaults", "[defaults]\nmatch = 'x'\n" + shot(""),
                "2:1 suite-E02 'match' belongs to one shot and cannot stand in [defaults]\n"},
        Mistake{"AToleranceOfEverything", shot("tolerance = { flip = 1 }"),
                "1:1 suite-E33 tolerance: flip = 1 passes every picture, so the shot compares nothing\n"},
        Mistake{
            "ATwofoldToleranceOfEverything", shot("tolerance = { flip = 1, structure = 1.0 }"),
            "1:1 suite-E33 tolerance: flip = 1 with structure = 1 passes every picture, so the shot compares "
            "nothing\n"},
        Mistake{
            "AToleranceOfAllDifferences", shot("tolerance = { max = 255, bias = 255 }"),
            "1:1 suite-E33 tolerance: max = 255 with this bias passes every picture, so the shot compares "
            "nothing\n"},
        Mistake{"AToleranceOfAllPixels",
                shot("tolerance = { fraction = 1, cluster = 1000000, line = 1000000, bias = 3 }"),
                "1:1 suite-E33 tolerance: fraction = 1 with these limits passes every picture, so the shot "
                "compares "
                "nothing\n"},
        Mistake{
            "AToleranceOfEverythingInDefaults", "[defaults]\ntolerance = { structure = 1 }\n" + shot(""),
            "3:1 suite-E33 tolerance: structure = 1 passes every picture, so the shot compares nothing\n"},
        Mistake{"UnknownToleranceKey", shot("tolerance = { maximum = 3, flipp = 1 }"),
                "3:15 suite-E02 unknown key 'maximum' in tolerance; did you mean 'max'?\n"
                "3:28 suite-E02 unknown key 'flipp' in tolerance; did you mean 'flip'?\n"},
        Mistake{"UnknownToleranceKeyLikeNoOther", shot("tolerance = { percent = 3 }"),
                "3:15 suite-E02 unknown key 'percent' in tolerance; the keys are max, fraction, cluster, "
                "line, bias, flip, structure, relative, absolute\n"},
        Mistake{"ShotKeyAtTheTop", "script = 'teapot.glib'\n",
                "1:1 suite-E02 'script' belongs under [[shot]]\n"},
        Mistake{"UnknownErrorKey", shot("expect-error = { ids = 'glsl-E01' }"),
                "3:18 suite-E02 unknown key 'ids' in expect-error; did you mean 'id'?\n"},
        Mistake{"SingleShot", "[shot]\nscript = 'teapot.glib'\n",
                "1:1 suite-E03 shot: expected [[shot]], found a table\n"},
        Mistake{"ShotIsNoTable", "shot = [1]\n",
                "1:9 suite-E03 shot: expected a table under [[shot]], found the number 1\n"},
        Mistake{"WrongTypes",
                shot("samples = 'four'\nstrict = 1\ntimeout = '3'\nsize = 'big'\neye = 'best'\ntags = "
                     "3\ntime = true"),
                "3:11 suite-E03 samples: expected a whole number, found the text 'four'\n"
                "4:10 suite-E03 strict: expected true or false, found the number 1\n"
                "5:11 suite-E03 timeout: expected a number, found the text '3'\n"
                "6:8 suite-E03 size: expected [WIDTH, HEIGHT] or \"WIDTHxHEIGHT\", found the text 'big'\n"
                "7:7 suite-E03 eye: expected \"auto\" or \"glman\", found the text 'best'\n"
                "8:8 suite-E03 tags: expected a text between quotes, or a list of such, found the number 3\n"
                "9:8 suite-E03 time: expected a number, found true\n"},
        Mistake{"DateAsTime", shot("time = 1979-05-27"),
                "3:8 suite-E03 time: expected a number, found a date or time\n"},
        Mistake{"HalfASample", shot("samples = 1.5"),
                "3:11 suite-E03 samples: expected a whole number, found the number 1.5\n"},
        Mistake{"WrongBound", shot("max-error = 0\noverride-counts = 1"),
                "3:13 suite-E04 max-error: 0 is not between 1e-09 and 1e+06\n"
                "4:19 suite-E03 override-counts: expected true or false, found the number 1\n"},
        Mistake{"HalfAPixel", shot("tolerance = { cluster = 1.5 }"),
                "3:25 suite-E03 tolerance.cluster: expected a whole number, found the number 1.5\n"},
        Mistake{"ListOfListsInSet", shot("set = { uColor = [[1, 0, 0], [0, 1, 0]] }"),
                "3:19 suite-E03 set.uColor: expected one value, found a list of lists; a list of values "
                "belongs in sweep\n"},
        Mistake{
            "SweepOfOneNumber", shot("sweep = { uTol = 0.1 }"),
            "3:18 suite-E03 sweep.uTol: expected a list of values, as [0, 0.1, 0.2], found the number 0.1\n"},
        Mistake{"OutOfRange",
                shot("samples = 100\ntimeout = -1\ntolerance = { flip = 2 }\nsize = [0, 70000]\ntime = [0, "
                     "1e10]\nset = "
                     "{ uA = 1e39, uB = nan }"),
                "3:11 suite-E04 samples: 100 is not between 1 and 64\n"
                "4:11 suite-E04 timeout: -1 is not between 0 and 1e+06\n"
                "5:22 suite-E04 tolerance.flip: 2 is not between 0 and 1\n"
                "6:9 suite-E04 size: 0 is not between 1 and 65536\n"
                "6:12 suite-E04 size: 70000 is not between 1 and 65536\n"
                "7:12 suite-E04 time: 1e+10 is not between -1e+09 and 1e+09\n"
                "8:14 suite-E04 set.uA: 1e+39 is not a finite 32-bit number\n"
                "8:25 suite-E04 set.uB: nan is not a finite 32-bit number\n"},
        Mistake{"SizeTextOutOfRange", shot("size = '0x9'"),
                "3:8 suite-E04 size: 0x9 is not 1 to 65536 pixels a side\n"},
        Mistake{"EmptyLists", shot("time = []\ntags = []\nsweep = { uA = [] }\nset = { uA = [] }\nname = ''"),
                "3:8 suite-E04 time: the list is empty\n"
                "4:8 suite-E04 tags: the list is empty\n"
                "5:16 suite-E04 sweep.uA: the list is empty\n"
                "6:14 suite-E04 set.uA: the list is empty\n"
                "7:8 suite-E04 name: the text is empty\n"},
        Mistake{"UniformTextThatIsNone", shot("set = { uA = '1 red', uB = '[1 2' }"),
                "3:14 suite-E04 set.uA: '1 red': 'red' is not a number\n"
                "3:28 suite-E04 set.uB: '[1 2': a bracket is not closed\n"},
        Mistake{
            "BadNames",
            shot("name = '../x'\n[[shot]]\nscript = 'teapot.glib'\nname = '/etc/x'\n[[shot]]\nscript = "
                 "'teapot.glib'\nname = 'a b'\n[[shot]]\nscript = 'teapot.glib'\nname = "
                 "'a//b'\n[[shot]]\nscript = "
                 "'teapot.glib'\nname = '.x'\ntags = 'a/b'"),
            "3:8 suite-E05 name: '../x' has '..' in it\n"
            "6:8 suite-E05 name: '/etc/x' begins with '/'; names are relative\n"
            "9:8 suite-E05 name: 'a b' has ' ' in it; letters, digits and . _ - = , @ + can be in a name\n"
            "12:8 suite-E05 name: 'a//b' has an empty part\n"
            "15:8 suite-E05 name: '.x' has a part that begins with '.'\n"
            "16:8 suite-E05 tag 'a/b' has '/' in it\n"},
        Mistake{"UniformNameThatIsNone", shot("set = { 'u Kd' = 1 }"),
                "3:9 suite-E05 set: 'u Kd' is not the name of a uniform\n"},
        Mistake{"NameTwice", shot("") + shot("name = 'teapot'"),
                "6:8 suite-E06 there are two shots 'teapot'; the other one is on line 2\n"},
        Mistake{"ValueTwice", shot("sweep = { uA = [0, 0.0] }"),
                "2:10 suite-E06 this makes two shots 'teapot@uA=0'\n"},
        Mistake{
            "NameOfAVariant", shot("") + shot("name = 'teapot.nvidia'"),
            "6:8 suite-E06 the golden of 'teapot.nvidia' would be a variant of that of 'teapot' on line 2\n"},
        Mistake{
            "NameOfAVariantThatIsNotLettersAlone", shot("") + shot("name = 'teapot.osmesa-llvmpipe'"),
            "6:8 suite-E06 the golden of 'teapot.osmesa-llvmpipe' would be a variant of that of 'teapot' on "
            "line 2\n"},
        Mistake{"UnknownShot", shot("") + shot("name = 'b'\nmatch = 'teapto'"),
                "7:9 suite-E07 match: there is no shot 'teapto'; did you mean 'teapot'?\n"},
        Mistake{"SweepNamedAsOne", shot("sweep = { uA = [1, 2] }") + shot("name = 'b'\ndiffer = 'teapot'"),
                "7:10 suite-E07 differ: there is no shot 'teapot'; there is 'teapot@uA=1', one of several\n"},
        Mistake{"Itself", shot("match = 'teapot'"),
                "3:9 suite-E08 match: the shots name each other in a cycle: teapot, teapot\n"},
        Mistake{"ItselfInEveryShotOfASweep", shot("sweep = { uA = [1, 2] }\nmatch = 'teapot'"),
                "4:9 suite-E08 match: the shots name each other in a cycle: teapot@uA=1, teapot@uA=1\n"
                "4:9 suite-E08 match: the shots name each other in a cycle: teapot@uA=2, teapot@uA=2\n"},
        Mistake{"Ring",
                shot("name = 'a'\nmatch = 'b'") + shot("name = 'b'\ndiffer = 'c'") +
                    shot("name = 'c'\nmatch = 'a'"),
                "12:9 suite-E08 match: the shots name each other in a cycle: a, b, c, a\n"},
        Mistake{
            "PatternOfNothing", "[[shot]]\nscript = 'strat/*.glib'\n",
            "2:10 suite-E09 script: no file matches 'strat/*.glib'; there is no folder 'strat'; did you mean "
            "'start'?\n"},
        Mistake{"PatternOfAnotherEnding", "[[shot]]\nscript = 'start/*.gilb'\n",
                "2:10 suite-E09 script: no file matches 'start/*.gilb'; did you mean 'start/*.glib'?\n"},
        Mistake{"ExceptionOfNothing", "[[shot]]\nscript = '*.glib'\nexcept = 'x*'\n",
                "3:10 suite-E09 except: no file matches 'x*'\n"},
        Mistake{"ExceptionOfAll", "[[shot]]\nscript = '*.glib'\nexcept = '*'\n",
                "2:10 suite-E09 script: 'except' excludes every file\n"},
        Mistake{"MissingScript", "[[shot]]\nscript = 'teapto.glib'\n",
                "2:10 suite-E10 script: cannot find 'teapto.glib'; did you mean 'teapot.glib'?\n"},
        Mistake{"MissingScriptOfAList", "[[shot]]\nscript = ['teapot.glib', 'start/cwo.glib']\n",
                "2:26 suite-E10 script: cannot find 'start/cwo.glib'; did you mean 'cow.glib'?\n"},
        Mistake{
            "NoScene", "[[shot]]\nscript = '/etc/passwd'\n",
            "2:10 suite-E10 script: '/etc/passwd' is not a scene; the name of a scene ends with '.glib'\n"},
        Mistake{"MissingEnding", "[[shot]]\nscript = 'teapot'\n",
                "2:10 suite-E10 script: cannot find 'teapot'; did you mean 'teapot.glib'?\n"},
        Mistake{
            "ScriptInAMissingFolder", "[[shot]]\nscript = 'strat/cow.glib'\n",
            "2:10 suite-E10 script: cannot find 'strat/cow.glib'; there is no folder 'strat'; did you mean "
            "'start'?\n"},
        Mistake{"FolderAsScript", "[[shot]]\nscript = 'start'\n",
                "2:10 suite-E10 script: cannot find 'start'; it is a folder, write \"start/*.glib\"\n"},
        Mistake{"WindowsPath", "[[shot]]\nscript = 'far\\off\\cow.glib'\n",
                "2:10 suite-E10 script: cannot find 'far\\off\\cow.glib'; folders are separated by '/'\n"},
        Mistake{"MissingLibrary", shot("library = 'nowhere'"),
                "3:11 suite-E10 library: there is no folder 'nowhere'\n"},
        Mistake{"MissingLibraryNear", shot("library = 'strat'"),
                "3:11 suite-E10 library: there is no folder 'strat'; did you mean 'start'?\n"},
        Mistake{"FileAsLibrary", shot("library = 'teapot.glib'"),
                "3:11 suite-E10 library: 'teapot.glib' is not a folder\n"},
        Mistake{"NoScript", "[[shot]]\nname = 'x'\n", "1:1 suite-E12 the shot has no script\n"},
        Mistake{"SetAndSweep", shot("set = { uA = 1 }\nsweep = { uA = [2] }"),
                "4:11 suite-E12 'uA' is in both set and sweep\n"},
        Mistake{"ErrorThatMatches", shot("") + shot("name = 'b'\nexpect-error = true\nmatch = 'teapot'"),
                "8:9 suite-E12 a shot with expect-error makes no picture that could match or differ\n"},
        Mistake{"MatchOfAnError", shot("expect-error = true") + shot("name = 'b'\nmatch = 'teapot'"),
                "7:9 suite-E12 match: 'teapot' expects an error, so it makes no picture\n"},
        Mistake{"MatchAndDiffer", shot("") + shot("name = 'b'\nmatch = 'teapot'\ndiffer = 'teapot'"),
                "8:10 suite-E12 match and differ both name 'teapot'\n"},
        Mistake{"WarningExpected", shot("expect-error = 'glib-W37'"),
                "1:1 suite-E12 expect-error: glib-W37 is a warning, which fails a scene only with strict = "
                "true\n"},
        Mistake{"NoShots", "[defaults]\nsamples = 4\n", "1:1 suite-E14 the suite has no [[shot]]\n"},
        Mistake{"UnknownError", shot("expect-error = 'glsl-E1'"),
                "3:16 suite-E17 expect-error: there is no message 'glsl-E1'; did you mean 'glsl-E01'?\n"},
        Mistake{"ColumnAfterAByteOrderMark", "\xef\xbb\xbfgolds = 1\n" + shot(""),
                "1:1 suite-E02 unknown key 'golds' at the top of the file; the keys are goldens, store, "
                "defaults, "
                "shot\n"},
        Mistake{"ColumnsAfterUmlauts", shot("set = { \"\xc3\xa4\xc3\xb6\" = 1, uA = nan }"),
                "3:9 suite-E05 set: '\xc3\xa4\xc3\xb6' is not the name of a uniform\n"
                "3:26 suite-E04 set.uA: nan is not a finite 32-bit number\n"}),
    [](const testing::TestParamInfo<Mistake>& mistake) { return std::string(mistake.param.name); });

TEST(SuiteMistakes, OfAHugeSweepAreReportedBeforeItIsMade) {
    const SceneFolder folder{"a.glib"};
    std::string values;
    for (int i = 0; i < 1000; ++i) values += std::to_string(i) + ", ";
    std::string text = "[[shot]]\nscript = 'a.glib'\nsweep = { ";
    for (int i = 0; i < 30; ++i) text += "u" + std::to_string(i) + " = [" + values + "], ";
    text += "last = [1] }\n";
    const auto suite = folder.read(text);
    ASSERT_EQ(suite.diagnostics.size(), 1U);
    EXPECT_EQ(suite.diagnostics[0].id, "suite-E11");
    EXPECT_EQ(suite.diagnostics[0].place.line, 3);
}

TEST(SuiteMistakes, HaveTheirColumnInBytesInLongLinesToo) {
    const SceneFolder folder{"a.glib"};
    std::string text = "expect-error = { text = \"";
    for (int i = 0; i < 3000; ++i) text += i % 2 == 0 ? "\xc3\xa4" : "\xe2\x82\xac";
    text += "\", line = ";
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a.glib'\n" + text + "0 }\n"),
              "3:" + std::to_string(text.size() + 1) +
                  " suite-E04 expect-error.line: 0 is not between 1 and 2147483647\n");
}

TEST(SuiteMistakes, AreCountedBeyondAHundred) {
    const SceneFolder folder{"a.glib"};
    std::string text = "[[shot]]\nscript = 'a.glib'\n";
    for (int i = 0; i < 150; ++i) text += "key" + std::to_string(i) + " = 1\n";
    const auto suite = folder.read(text);
    ASSERT_EQ(suite.diagnostics.size(), 101U);
    EXPECT_EQ(suite.diagnostics.back().text, "50 more errors are not shown");
}

TEST(SuiteMistakes, OfFilesAreReported) {
    const SceneFolder folder{"a.glib", "start.toml", "empty/notes.txt", "twice/a b.glib", "twice/a_b.glib"};
    const auto message = [&](const char* name) { return folder.shown(readSuite(folder.path() / name)); };
    EXPECT_EQ(message("strat.toml"), "1:1 file-E01 cannot find 'strat.toml'; nearest: 'start.toml'\n");
    EXPECT_EQ(message("a.glib"),
              "1:1 suite-E13 this is a scene; a suite is a .toml file or a folder of scenes\n");
    EXPECT_EQ(message("start.toml"), "1:1 file-E02 'start.toml' is empty\n");
    EXPECT_EQ(message("empty"), "1:1 suite-E14 there is no .glib file in the folder\n");
    EXPECT_EQ(
        message("twice"),
        "1:1 suite-E06 'twice/a b.glib' and 'twice/a_b.glib' would both be the shot 'a_b'; rename one\n");
}

TEST(SuiteMistakes, OfALongRingShowItsBeginning) {
    const SceneFolder folder{"a.glib"};
    std::string text;
    for (int i = 0; i < 3000; ++i)
        text += "[[shot]]\nscript = 'a.glib'\nname = 's" + std::to_string(i) + "'\nmatch = 's" +
                std::to_string((i + 1) % 3000) + "'\n";
    const auto suite = folder.read(text);
    ASSERT_EQ(suite.diagnostics.size(), 1U);
    EXPECT_EQ(suite.diagnostics[0].text,
              "match: the shots name each other in a cycle: s0, s1, s2, s3, s4, s5, ..., s0");
}

}  // namespace
}  // namespace glibra::suite::test
