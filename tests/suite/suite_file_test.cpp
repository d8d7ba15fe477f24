// Correct suite files and the shots that they make.

#include "suite/file/suite_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "suite/file/shot_name.h"
#include "suite_text.h"

namespace glibra::suite::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

constexpr const char* kShift = "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1]";

TEST(SuiteFile, ReadsTheViewOfAWindow) {
    const SceneFolder folder{"a.glib"};
    const std::string shift = kShift;
    const auto suite =
        folder.read("[[shot]]\nscript = 'a.glib'\nscene-transform = " + shift + "\neye-transform = " + shift +
                    "\ntexture-transform = " + shift + "\nobject-transform = { 12 = " + shift +
                    " }\nprojection = 'orthographic'\nbackground = [0, 0.5, 1]\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    Matrix shifted = kIdentity;
    shifted[12] = .5;
    ViewState wanted;
    wanted.scene = wanted.eye = wanted.texture = shifted;
    wanted.objects = {{12, shifted}};
    wanted.projection = ProjectionMode::orthographic;
    wanted.background = {0, .5, 1, 1};
    EXPECT_EQ(suite->shots.at(0).options.viewState, wanted);
}

TEST(SuiteFile, ATagCanBelongToOneProgram) {
    const SceneFolder folder{"a.glib"};
    const auto suite = folder.read(
        "[[shot]]\nscript = 'a.glib'\nset = { 'Dots:uKd' = 0.5, '12:uKd' = 1 }\n"
        "sweep = { 'Dots:uAd' = [1, 2] }\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    EXPECT_EQ(suite->shots.at(0).options.set, (Strings{"Dots:uKd=0.5", "12:uKd=1", "Dots:uAd=1"}));
    EXPECT_EQ(suite->shots.at(1).name, "a@Dots.uAd=2");
}

TEST(SuiteFile, ReadsEveryKeyOfAShot) {
    const SceneFolder folder{"a.glib", "lib/x.glib"};
    const auto suite = folder.read(R"(
goldens = "pictures/gold"
[[shot]]
script = "a.glib"
name = "left/one"
size = [320, 240]
time = 1.5
set = { uKd = 0.5, uColor = [1, 0.5, 0], uOn = true, uCount = 3, uRange = "<0 .5 1>", light = { pos = [1, 2, 3] } }
samples = 4
max-error = 0.25
override-counts = true
view = "glman"
axes = true
alpha = true
float = true
strict = true
shim = false
tile = 64
library = "lib"
timeout = 12.5
tolerance = { max = 5, fraction = 0.01, cluster = 6, line = 7, bias = 1.5, flip = 0.02, structure = 0.03, relative = 0.001, absolute = 1e-5 }
tags = ["slow", "gpu", "slow"]
golden = false
[[shot]]
script = "a.glib"
match = "left/one"
)");
    ASSERT_TRUE(suite) << folder.shown(suite);
    EXPECT_EQ(suite->name, "s");
    EXPECT_EQ(suite->file, folder.path() / "s.toml");
    EXPECT_EQ(suite->goldens, folder.path() / "pictures/gold");
    ASSERT_EQ(suite->shots.size(), 2U);
    const Shot& shot = suite->shots[0];
    EXPECT_EQ(shot.name, "left/one");
    EXPECT_EQ(shot.script, folder.path() / "a.glib");
    EXPECT_EQ(shot.place, (Place{(folder.path() / "s.toml").string(), 3, 1}));
    const RenderOptions& options = shot.options;
    EXPECT_EQ(options.width, 320);
    EXPECT_EQ(options.height, 240);
    EXPECT_EQ(options.time, 1.5);
    EXPECT_EQ(options.set, (Strings{"uKd=0.5", "uColor=1,0.5,0", "uOn=true", "uCount=3", "uRange=<0 .5 1>",
                                    "light.pos=1,2,3"}));
    EXPECT_EQ(options.samples, 4);
    EXPECT_EQ(options.maxError, .25);
    EXPECT_TRUE(options.overrideCounts);
    EXPECT_EQ(options.view, ViewPolicy::glman);
    EXPECT_TRUE(options.axes && options.alpha && options.floatPixels && options.strict && !options.shim);
    EXPECT_EQ(options.tileSize, 64);
    EXPECT_EQ(options.libraryRoots, std::vector<fs::path>{folder.path() / "lib"});
    EXPECT_EQ(shot.timeout, 12.5);
    EXPECT_EQ(shot.tolerance.largest, 5);
    EXPECT_EQ(shot.tolerance.fraction, .01);
    EXPECT_EQ(shot.tolerance.cluster, 6);
    EXPECT_EQ(shot.tolerance.line, 7);
    EXPECT_EQ(shot.tolerance.bias, 1.5);
    EXPECT_EQ(shot.tolerance.flip, .02);
    EXPECT_EQ(shot.tolerance.structure, .03);
    EXPECT_EQ(shot.tolerance.relative, .001);
    EXPECT_EQ(shot.tolerance.absolute, 1e-5);
    EXPECT_EQ(shot.tags, (Strings{"slow", "gpu"}));
    EXPECT_FALSE(shot.golden);
    EXPECT_EQ(suite->shots[1].match, "left/one");
}

TEST(SuiteFile, MissingKeysKeepTheirDefaults) {
    const SceneFolder folder{"a.glib"};
    const auto suite = folder.read("[[shot]]\nscript = 'a.glib'\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    const Shot& shot = suite->shots.at(0);
    const Shot standard;
    EXPECT_EQ(shot.name, "a");
    EXPECT_EQ(suite->goldens, folder.path() / "golden/s");
    EXPECT_EQ(shot.options.width, 0);
    EXPECT_EQ(shot.options.time, 0);
    EXPECT_EQ(shot.timeout, standard.timeout);
    EXPECT_EQ(shot.tolerance.largest, image::Tolerance{}.largest);
    EXPECT_FALSE(shot.tolerance.flip);
    EXPECT_TRUE(shot.golden && shot.options.shim && !shot.expectedError);
}

TEST(SuiteFile, MergesDefaultsKeyByKey) {
    const SceneFolder folder{"a.glib"};
    const auto suite = folder.read(R"(
[[shot]]
script = "a.glib"
size = "64x48"
set = { uB = 3 }
tolerance = { max = 9 }
tags = "mine"
[defaults]
size = [8, 8]
samples = 2
set = { uA = 1, uB = 2 }
tolerance = { max = 1, bias = 2 }
tags = "all"
)");
    ASSERT_TRUE(suite) << folder.shown(suite);
    const Shot& shot = suite->shots.at(0);
    EXPECT_EQ(shot.options.width, 64);
    EXPECT_EQ(shot.options.samples, 2);
    EXPECT_EQ(shot.options.set, (Strings{"uA=1", "uB=3"}));
    EXPECT_EQ(shot.tolerance.largest, 9);
    EXPECT_EQ(shot.tolerance.bias, 2);
    EXPECT_EQ(shot.tags, (Strings{"all", "mine"}));
}

TEST(SuiteFile, MakesAShotOfEveryValueOfASweep) {
    const SceneFolder folder{"oval.glib"};
    const auto suite = folder.read("[[shot]]\nscript = 'oval.glib'\n[shot.sweep]\nuTol = [0, 0.1, 0.2]\n");
    EXPECT_EQ(folder.shown(suite), "oval@uTol=0\noval@uTol=0.1\noval@uTol=0.2\n");
    ASSERT_TRUE(suite);
    EXPECT_EQ(suite->shots[1].options.set, (Strings{"uTol=0.1"}));
}

TEST(SuiteFile, SweepsOverTheWordsOfAChoice) {
    const SceneFolder folder{"oval.glib"};
    const auto suite = folder.read("[[shot]]\nscript = 'oval.glib'\nsweep = { method = ['lit', 'toon'] }\n");
    EXPECT_EQ(folder.shown(suite), "oval@method=lit\noval@method=toon\n");
    ASSERT_TRUE(suite);
    EXPECT_EQ(suite->shots[1].options.set, (Strings{"method=toon"}));
}

TEST(SuiteFile, AListIsAVectorInSetAndSeveralValuesInSweep) {
    const SceneFolder folder{"a.glib"};
    const auto one = folder.read("[[shot]]\nscript = 'a.glib'\nset = { uColor = [0, 0.1, 0.2] }\n");
    ASSERT_TRUE(one);
    ASSERT_EQ(one->shots.size(), 1U);
    EXPECT_EQ(one->shots[0].options.set, (Strings{"uColor=0,0.1,0.2"}));
    const auto two =
        folder.read("[[shot]]\nscript = 'a.glib'\nsweep = { uColor = [[1, 0.5, 0], [0, 0, 1]] }\n");
    EXPECT_EQ(folder.shown(two), "a@uColor=1,0.5,0\na@uColor=0,0,1\n");
    ASSERT_TRUE(two);
    EXPECT_EQ(two->shots[0].options.set, (Strings{"uColor=1,0.5,0"}));
}

TEST(SuiteFile, CombinesSweepsAndTimesInTheOrderOfTheFile) {
    const SceneFolder folder{"a.glib"};
    EXPECT_EQ(
        folder.show("[[shot]]\nscript = 'a.glib'\ntime = [0, 0.5]\n"
                    "sweep = { uZ = [1, 2], uA = [true, -1e30] }\n"),
        "a@uZ=1@uA=true@time=0\na@uZ=1@uA=true@time=0.5\na@uZ=1@uA=-1e+30@time=0\na@uZ=1@uA=-1e+30@time=0.5\n"
        "a@uZ=2@uA=true@time=0\na@uZ=2@uA=true@time=0.5\na@uZ=2@uA=-1e+30@time=0\na@uZ=2@uA=-1e+30@time=0."
        "5\n");
}

TEST(SuiteFile, NamesArraysAndLongValuesSoThatTheyNameFiles) {
    const SceneFolder folder{"a.glib"};
    EXPECT_EQ(
        folder.show(
            "[[shot]]\nscript = 'a.glib'\nsweep = { 'uW[2]' = [1], uM = [[1,0,0,1], [1,0,0,0,1,0,0,0,1]], "
            "uS = ['{1 .5 0}'] }\n"),
        "a@uW.2=1@uM=1,0,0,1@uS=1,0.5,0\na@uW.2=1@uM=v2@uS=1,0.5,0\n");
}

TEST(SuiteFile, LetsASweepTakeThePlaceOfADefault) {
    const SceneFolder folder{"a.glib"};
    const auto suite = folder.read(
        "[defaults]\nset = { uA = 1, uB = 2 }\n[[shot]]\nscript = 'a.glib'\nsweep = { uA = [5] }\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    EXPECT_EQ(suite->shots.at(0).options.set, (Strings{"uB=2", "uA=5"}));
}

TEST(SuiteFile, KnowsWhichUniformsAShotItselfNames) {
    const SceneFolder folder{"a.glib", "b.glib"};
    const auto suite = folder.read(
        "[defaults]\nset = { uA = 1, uB = 2 }\n"
        "[[shot]]\nscript = 'a.glib'\nset = { uB = 3 }\nsweep = { 'P:uC' = [1, 2] }\n"
        "[[shot]]\nscript = '*.glib'\nname = 'all'\nset = { uD = 3 }\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    ASSERT_EQ(suite->shots.size(), 4U);
    for (const std::size_t one : {0U, 1U}) {
        const std::vector<PlacedUniform>& own = suite->shots[one].ownUniforms;
        ASSERT_EQ(own.size(), 2U);
        EXPECT_EQ(own[0].name, "uB");
        EXPECT_EQ(own[0].place, (Place{(folder.path() / "s.toml").string(), 5, 9}));
        EXPECT_EQ(own[1].name, "P:uC");
    }
    EXPECT_TRUE(suite->shots[2].ownUniforms.empty()) << "several scenes need not all have it";
}

TEST(SuiteFile, NamesAListOfTimesEvenIfItHasOne) {
    const SceneFolder folder{"a.glib"};
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a.glib'\ntime = [2]\n"), "a@time=2\n");
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a.glib'\ntime = 2\n"), "a\n");
}

TEST(SuiteFile, TakesPatternsListsAndExceptions) {
    const SceneFolder folder{"a/x.glib", "a/y.glib", "a/n/z.glib", "b.glib"};
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a/*.glib'\n"), "x\ny\n");
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a/**/*.glib'\nname = 'all'\n"), "all/n/z\nall/x\nall/y\n");
    EXPECT_EQ(folder.show("[[shot]]\nscript = ['b.glib', 'a/*.glib', 'a/x.glib']\n"), "b\nx\ny\n");
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a/**/*.glib'\nexcept = ['a/x.glib', 'a/n/*']\n"), "y\n");
}

TEST(SuiteFile, TakesANameWithWildcardsThatIsAFile) {
    const SceneFolder folder{"a[1].glib", "a1.glib"};
    EXPECT_EQ(folder.show("[[shot]]\nscript = 'a[1].glib'\n"), "a_1_\n");
}

TEST(SuiteFile, ShortensPathsOfScripts) {
    const SceneFolder folder{"glib/a.glib", "scenes/x.glib"};
    const auto suite =
        readSuiteText("[[shot]]\nscript = '../glib/a.glib'\n", folder.path() / "scenes/s.toml");
    ASSERT_TRUE(suite);
    EXPECT_EQ(suite->shots.at(0).script, folder.path() / "glib/a.glib");
    // Through a link, the shortened path would lead to another place.
    fs::create_directories(folder.path() / "far/away");
    fs::create_directory_symlink(folder.path() / "scenes", folder.path() / "far/away/link");
    const auto linked =
        readSuiteText("[[shot]]\nscript = '../glib/a.glib'\n", folder.path() / "far/away/link/s.toml");
    ASSERT_TRUE(linked) << folder.shown(linked);
    EXPECT_TRUE(fs::exists(linked->shots.at(0).script));
}

TEST(SuiteFile, ReadsExpectedErrorsInTheirThreeForms) {
    const SceneFolder folder{"a.glib", "b.glib", "c.glib", "d.glib"};
    const auto suite = folder.read(
        "[[shot]]\nscript = 'a.glib'\nexpect-error = 'glsl-E01'\n"
        "[[shot]]\nscript = 'b.glib'\nexpect-error = { id = 'glib-E04', text = 'LookAt', line = 7 }\n"
        "[[shot]]\nscript = 'c.glib'\nexpect-error = true\n"
        "[[shot]]\nscript = 'd.glib'\nstrict = true\nexpect-error = 'glib-W37'\n");
    ASSERT_TRUE(suite) << folder.shown(suite);
    EXPECT_EQ(suite->shots[0].expectedError->id, "glsl-E01");
    EXPECT_EQ(suite->shots[1].expectedError->id, "glib-E04");
    EXPECT_EQ(suite->shots[1].expectedError->text, "LookAt");
    EXPECT_EQ(suite->shots[1].expectedError->line, 7);
    EXPECT_TRUE(suite->shots[2].expectedError);
    EXPECT_EQ(suite->shots[2].expectedError->id, "");
    EXPECT_EQ(suite->shots[3].expectedError->id, "glib-W37");
}

TEST(SuiteFile, PairsSweepsValueByValue) {
    const SceneFolder folder{"a.glib", "b.glib"};
    const auto suite = folder.read(
        "[[shot]]\nscript = 'a.glib'\nsweep = { uT = [1, 2] }\n"
        "[[shot]]\nscript = 'b.glib'\nsweep = { uT = [1, 2] }\nmatch = 'a'\ndiffer = 'a@uT=2'\ngolden = "
        "false\n");
    EXPECT_FALSE(suite);  // b@uT=2 would match and differ from the same one
    const auto good = folder.read(
        "[[shot]]\nscript = 'a.glib'\nsweep = { uT = [1, 2] }\n"
        "[[shot]]\nscript = 'b.glib'\nsweep = { uT = [1, 2] }\nmatch = 'a'\n"
        "[[shot]]\nscript = 'b.glib'\nname = 'c'\ndiffer = 'a@uT=2'\n");
    ASSERT_TRUE(good) << folder.shown(good);
    EXPECT_EQ(good->shots[2].match, "a@uT=1");
    EXPECT_EQ(good->shots[3].match, "a@uT=2");
    EXPECT_EQ(good->shots[4].differ, "a@uT=2");
}

TEST(SuiteFile, SeveralShotsMayNameOneOfThem) {
    const SceneFolder folder{"a.glib", "b.glib", "c.glib"};
    const auto pattern = folder.read("[[shot]]\nscript = '*.glib'\ndiffer = 'b'\n");
    ASSERT_TRUE(pattern) << folder.shown(pattern);
    EXPECT_EQ(pattern->shots[0].differ, "b");
    EXPECT_EQ(pattern->shots[1].differ, "");
    EXPECT_EQ(pattern->shots[2].differ, "b");
    const auto sweep =
        folder.read("[[shot]]\nscript = 'a.glib'\nsweep = { uT = [1, 2] }\nmatch = 'a@uT=1'\n");
    ASSERT_TRUE(sweep) << folder.shown(sweep);
    EXPECT_EQ(sweep->shots[0].match, "");
    EXPECT_EQ(sweep->shots[1].match, "a@uT=1");
}

TEST(SuiteFile, MakesASuiteOfAFolder) {
    const SceneFolder folder{"b.glib",      "a/x y.GLIB", "a/x.glib", "M\xc3\xbcller.glib",
                             ".git/c.glib", "notes.txt"};
    const auto suite = readSuite(folder.path());
    EXPECT_EQ(folder.shown(suite), "M_ller\na/x_y\na/x\nb\n");
    ASSERT_TRUE(suite);
    EXPECT_EQ(suite->name, folder.path().filename().string());
    EXPECT_EQ(suite->goldens, folder.path() / "golden");
    EXPECT_EQ(readSuite(folder.path().string() + "/")->name, folder.path().filename().string());
}

TEST(SuiteFile, IsReadFromDisk) {
    const SceneFolder folder{"a.glib"};
    folder.write("suite.toml", "\xef\xbb\xbf[[shot]]\r\nscript = \"a.glib\"\r\n");
    const auto suite = readSuite(folder.path() / "suite.toml");
    EXPECT_EQ(folder.shown(suite), "a\n");
    EXPECT_EQ(suite->name, "suite");
}

TEST(SuiteFile, HoldsTensOfThousandsOfShots) {
    const SceneFolder folder{"a.glib"};
    std::string values;
    for (int i = 0; i < 300; ++i) values += std::to_string(i) + ", ";
    const auto suite = folder.read("[[shot]]\nscript = 'a.glib'\nsweep = { uA = [" + values + "], uB = [" +
                                   values + "] }\n");
    ASSERT_TRUE(suite);
    EXPECT_EQ(suite->shots.size(), 90'000U);
    EXPECT_EQ(suite->shots.back().name, "a@uA=299@uB=299");
}

TEST(ShippedSuites, ShowEveryScene) {
    std::set<fs::path> shown;
    std::set<fs::path> goldens;
    int suites = 0;
    for (const auto& each : fs::directory_iterator(GLIBRA_SOURCE_DIR "/scenes")) {
        if (each.path().extension() != ".toml") continue;
        const auto suite = readSuite(each.path());
        for (const Diagnostic& problem : suite.diagnostics) ADD_FAILURE() << toString(problem);
        ASSERT_TRUE(suite);
        ++suites;
        EXPECT_TRUE(goldens.insert(suite->goldens).second) << each.path();
        EXPECT_EQ(suite->goldens, fs::path(GLIBRA_SOURCE_DIR "/tests/golden") / suite->name);
        for (const Shot& shot : suite->shots)
            if (!shot.expectedError) shown.insert(fs::weakly_canonical(shot.script));
    }
    EXPECT_GE(suites, 13);
    int scenes = 0;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib")) {
        // Students complete the exercises, and `glibra class` compares them with a scene that is shown.
        const bool isExercise = each.path().parent_path().parent_path().filename() == "exercises";
        if (each.path().extension() != ".glib" || isExercise) continue;
        ++scenes;
        EXPECT_TRUE(shown.contains(fs::weakly_canonical(each.path()))) << each.path() << " is in no suite";
    }
    EXPECT_GE(scenes, 66);
}

/// The name as Windows tells it from others: the file system ignores case, and dots at the end of a folder.
std::string onWindows(const std::string& name) {
    std::filesystem::path path;
    for (const std::filesystem::path& part : std::filesystem::path(name)) {
        std::string text = part.string();
        std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
        path /= text;
    }
    std::string text = path.string();
    for (std::size_t at = 0; (at = text.find("./")) != std::string::npos;) text.erase(at, 1);
    return text;
}

TEST(ShotNames, AreToldApartOnEveryDisk) {
    const std::string alphabet = "aAb./";
    std::vector<std::string> all{""};
    std::vector<std::string> valid;
    for (std::size_t begin = 0, length = 1; length <= 4; ++length) {
        const std::size_t end = all.size();
        for (; begin < end; ++begin)
            for (const char c : alphabet) all.push_back(all[begin] + c);
    }
    for (const std::string& each : all)
        if (whyNotAName(each).empty()) valid.push_back(each);
    EXPECT_GT(valid.size(), 200U);
    for (const std::string& each : valid) EXPECT_EQ(nameOnAnyDisk(each), onWindows(each)) << each;
}

TEST(SuiteFile, NamesThatShareAGoldenOnSomeDiskAreRefused) {
    const auto suiteOf = [](const std::string& first, const std::string& second) {
        return "[[shot]]\nscript = 'x.glib'\nname = '" + first + "'\n[[shot]]\nscript = 'x.glib'\nname = '" +
               second + "'\n";
    };
    const SceneFolder folder{"x.glib", "scenes/Ab.glib", "scenes/aB.glib", "other/a/b.glib", "other/A.glib"};
    for (const auto& [first, second] :
         {std::pair("Ab", "aB"), {"a/b", "A/b"}, {"a./b", "a/b"}, {"teapot", "TEAPOT"}, {"a", "A.nvidia"}})
        EXPECT_EQ(
            folder.show(suiteOf(first, second)),
            std::string("6:8 suite-E23 the goldens of '") + first + "' and '" + second +
                "' would be one file on disks that ignore upper and lower case; rename one; the other one "
                "is on line 3\n");
    for (const auto& [first, second] : {std::pair("ab", "abc"), {"a/b", "ab"}, {"a.", "a"}})
        EXPECT_EQ(folder.show(suiteOf(first, second)), std::string(first) + "\n" + second + "\n");
    EXPECT_NE(folder.shown(readSuite(folder.path() / "scenes")).find("suite-E23"), std::string::npos);
    EXPECT_TRUE(readSuite(folder.path() / "other"));
}

}  // namespace
}  // namespace glibra::suite::test
