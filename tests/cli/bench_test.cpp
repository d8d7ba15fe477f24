// The program glibra-bench, as started by glibra bench (subjects, files, comparison, exit status) and by
// glibra info --precision.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

TEST(BenchCommand, ListsItsSubjects) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "bench --list");
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(contains(run.out, "primitives ")) << run.out;
    EXPECT_TRUE(contains(run.out, "ray-sphere ")) << run.out;
}

TEST(BenchCommand, SuggestsASubject) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "bench ray-shpere xyzzy");
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err, "unknown subject 'ray-shpere'; did you mean 'ray-sphere'? [bench-E01]"))
        << run.err;
    EXPECT_TRUE(contains(run.err, "unknown subject 'xyzzy'; --list names them")) << run.err;
    EXPECT_EQ(run.out, "");
}

/// A picture that is white up to the share that `steps` halvings leave of it.
constexpr const char* kSteps =
    "WindowSize 64 8\nLet steps <1 4 16>\nFragment inline\n#version 330\nin vec2 vST;\nuniform float steps;\n"
    "out vec4 c;\nvoid main() { c = vec4(floor(vST.s*steps)/steps); }\nEndFragment\nProgram P\n"
    "Fill window with P\n";

TEST(BenchCommand, MeasuresASceneAgainstItsFinestValue) {
    const Folder folder;
    folder.write("a.glib", kSteps);
    const Finished run =
        glibra(folder.path(), "bench --quick --scene a.glib --sweep 'steps=[2, 4,8,16]' -o out");
    ASSERT_EQ(run.status, 0) << run.err;
    const auto report = nlohmann::json::parse(readFile(folder / "out/bench.json"));
    const auto& points = report.at("subjects").at(0).at("figures").at(0).at("curves").at(0).at("points");
    ASSERT_EQ(points.size(), 4U) << run.out;
    // The difference of two staircases: errors fall, and the last one is the reference.
    for (std::size_t i = 0; i + 1 < 4; ++i)
        EXPECT_GT(points.at(i).at("error").get<double>(), points.at(i + 1).at("error").get<double>()) << i;
    EXPECT_EQ(points.at(3).at("error").get<double>(), 0);
    EXPECT_GT(points.at(0).at("time").at("median").get<double>(), 0);
}

TEST(BenchCommand, ReportsASweepThatItCannotRead) {
    const Folder folder;
    folder.write("a.glib", kSteps);
    for (const char* sweep : {"steps", "steps=[4]", "=1,2", "steps=[1,x]"}) {
        const Finished run =
            glibra(folder.path(), "bench --quick --scene a.glib --sweep '" + std::string(sweep) + "'");
        EXPECT_EQ(run.status, 2) << sweep << run.out;
        EXPECT_TRUE(contains(run.err, "[bench-E03]")) << sweep << run.err;
    }
    EXPECT_EQ(glibra(folder.path(), "bench --quick --scene a.glib").status, 2);
    EXPECT_EQ(glibra(folder.path(), "bench --quick --scene none.glib --sweep 'steps=1,2'").status, 3);
}

TEST(BenchCommand, WritesItsFilesAndComparesWithThem) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "bench --quick ray-sphere -o out/deep --csv more.csv");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "[1/1] Ray and sphere: textbook and stable formulas\n") << "a log gets plain lines";
    EXPECT_TRUE(contains(run.out, "Ray and sphere")) << run.out;
    EXPECT_EQ(readFile(folder / "more.csv"), readFile(folder / "out/deep/bench.csv"));
    EXPECT_TRUE(contains(readFile(folder / "out/deep/bench.html"), "</html>"));

    const Finished same = glibra(folder.path(), "bench --quick ray-sphere --against out/deep/bench.json");
    EXPECT_EQ(same.status, 0) << same.out;
    EXPECT_TRUE(contains(same.out, "error worse at 0")) << same.out;

    const std::string before = readFile(folder / "out/deep/bench.json");
    const Finished spared =
        glibra(folder.path(), "bench --quick ray-sphere --against out/deep/bench.json -o out/deep");
    EXPECT_EQ(spared.status, 3) << spared.out;
    EXPECT_TRUE(contains(spared.err, "-o: 'out/deep/bench.json' is not written over")) << spared.err;
    EXPECT_EQ(readFile(folder / "out/deep/bench.json"), before);

    // The earlier run doctored: it was ten times as accurate.
    std::string json = readFile(folder / "out/deep/bench.json");
    const std::string key = "\"error\": ";
    const std::size_t at = json.find(key) + key.size(), end = json.find_first_of(",\n", at);
    json.replace(at, end - at, std::to_string(std::stod(json.substr(at, end - at)) / 10));
    folder.write("better.json", json);
    const Finished worse = glibra(folder.path(), "bench --quick ray-sphere --against better.json");
    EXPECT_EQ(worse.status, 1) << worse.out;
    EXPECT_TRUE(contains(worse.out, "worse   ray-sphere/hit, ")) << worse.out;
}

TEST(BenchCommand, RejectsAFileThatIsNoEarlierRun) {
    const Folder folder;
    folder.write("broken.json", "{\n  \"format\": }");
    const Finished broken = glibra(folder.path(), "bench --quick ray-sphere --against broken.json");
    EXPECT_EQ(broken.status, 2);
    EXPECT_TRUE(contains(broken.err, "broken.json:2:13: error: not valid JSON:")) << broken.err;
    EXPECT_EQ(glibra(folder.path(), "bench --quick ray-sphere --against none.json").status, 2);
    EXPECT_EQ(glibra(folder.path(), "bench --quick --time-factor .5").status, 2);
}

TEST(BenchCommand, MeasuresWhatItCanWithoutADriver) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "bench --quick ray-sphere --driver egl-device -o out",
                                "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null LIBGL_DRIVERS_PATH=/nowhere");
    EXPECT_EQ(run.status, 4) << run.err;
    EXPECT_TRUE(contains(run.err, "[gpu-E01]")) << run.err;
    EXPECT_TRUE(contains(run.out, "CPU, float, stable")) << run.out;
    EXPECT_FALSE(contains(run.out, "shader, stable")) << run.out;
    EXPECT_TRUE(contains(readFile(folder / "out/bench.html"), "no driver"));
}

TEST(BenchCommand, HasItsOwnHelp) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "bench --help");
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(contains(run.out, "glibra bench [OPTIONS]")) << run.out;
    EXPECT_TRUE(contains(run.out, "--against")) << run.out;
}

TEST(BenchCommand, SaysHowToBuildTheProgramThatIsMissing) {
    const Folder folder;
    for (const char* arguments : {"bench --list", "info --precision"}) {
        // Nothing lies beside a copy of the program.
        const Finished run =
            shell(folder.path(), "cp '" GLIBRA_PROGRAM "' copy && exec ./copy " + std::string(arguments));
        EXPECT_EQ(run.status, 4);
        EXPECT_EQ(run.err,
                  "glibra: error: the program glibra-bench is missing; build it with `cmake --build "
                  "BUILD_FOLDER --target glibra_bench_program` (this needs Boost)\n");
        EXPECT_EQ(run.out, "");
    }
}

TEST(InfoPrecision, ReportsThePrecisionOfEveryFunctionAsJson) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "info --precision --json");
    ASSERT_EQ(finished.status, 0) << finished.err;
    const auto json = nlohmann::json::parse(finished.out);
    bool hasDivision = false, hasSine = false;
    for (const auto& row : json.at("precision")) {
        const std::string function = row.at("function");
        for (const char* stage : {"vertex", "fragment"}) {
            EXPECT_GT(row.at(stage).at("samples").get<int>(), 1000) << function;
            EXPECT_GE(row.at(stage).at("meanUlp").get<double>(), 0) << function;
        }
        if (function == "division") {
            hasDivision = true;
            EXPECT_EQ(row.at("bound"), "2.5 ULP");
            EXPECT_TRUE(row.at("fragment").contains("timesTheBound"));
        }
        if (function == "sin") {
            hasSine = true;
            EXPECT_FALSE(row.at("fragment").contains("timesTheBound"));
        }
    }
    EXPECT_TRUE(hasDivision && hasSine);
}

TEST(InfoPrecision, ReportsInWordsWhichBoundsAreBroken) {
    const Folder folder;
    const Finished finished = glibra(folder.path(), "info --precision");
    ASSERT_EQ(finished.status, 0) << finished.err;
    EXPECT_NE(finished.out.find("inversesqrt"), std::string::npos);
    EXPECT_NE(finished.out.find("bounds are broken"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
