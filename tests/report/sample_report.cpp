// usage: glibra_sample_report FOLDER [PASSES]
// Writes FOLDER/results with a shot of every verdict, and
// FOLDER/report with its HTML report. browser_test.py expects exactly these.

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/compare/compare.h"
#include "image/write.h"
#include "suite/report/report_files.h"
#include "suite/report/terminal_report.h"
#include "suite/results/results_file.h"

namespace {

using namespace glibra;
namespace fs = std::filesystem;

constexpr int kWidth = 64, kHeight = 48;

/// Red increases to the right, green downwards; blue is 128.
image::Image gradient(int width = kWidth, int height = kHeight) {
    image::Image picture{width, height, 3, image::Component::u8, {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::byte* pixel =
                picture.data.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(x)) *
                                          3;
            pixel[0] = static_cast<std::byte>(x * 3);
            pixel[1] = static_cast<std::byte>(y * 4);
            pixel[2] = std::byte{128};
        }
    return picture;
}

/// The gradient with 5 more red and 9 less blue in the square from 20, 10 to 29, 19.
image::Image withSquare() {
    image::Image picture = gradient();
    for (std::size_t y = 10; y < 20; ++y)
        for (std::size_t x = 20; x < 30; ++x) {
            std::byte* pixel = picture.data.data() + (y * kWidth + x) * 3;
            pixel[0] = static_cast<std::byte>(std::to_integer<int>(pixel[0]) + 5);
            pixel[2] = static_cast<std::byte>(std::to_integer<int>(pixel[2]) - 9);
        }
    return picture;
}

image::Image heatOf(const image::Image& a, const image::Image& b) {
    image::Image picture = a;
    for (std::size_t i = 0; i < a.data.size(); ++i) {
        const int difference = std::abs(std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i]));
        picture.data[i] = static_cast<std::byte>(std::min(255, 20 * difference));
    }
    return picture;
}

/// 16 bits with alpha. The pixel at 3, 2 has a colour but alpha 0, which a canvas would lose.
image::Image deep(std::uint16_t red) {
    image::Image picture{8, 8, 4, image::Component::u16, {}};
    for (int pixel = 0; pixel < 64; ++pixel) {
        const std::uint16_t alpha = pixel == 2 * 8 + 3 ? 0 : 65535;
        const std::uint16_t values[] = {red, 20000, 30001, alpha};
        const auto* bytes = reinterpret_cast<const std::byte*>(values);
        picture.data.insert(picture.data.end(), bytes, bytes + sizeof values);
    }
    return picture;
}

suite::ShotResult shot(const std::string& name, suite::Verdict verdict) {
    suite::ShotResult made;
    made.suite = "sample";
    made.shot = name;
    made.verdict = verdict;
    made.script = "scene.glib";
    made.width = kWidth;
    made.height = kHeight;
    made.milliseconds = 12.5;
    made.reproduce = "glibra render scene.glib --set 'uName=<b>\"x\" & y</b>' -o " + name + ".png";
    made.accept = "glibra test sample.toml --only " + name + " --update";
    return made;
}

/// A shot with pictures and the figures of their comparison.
suite::ShotResult compared(const fs::path& results, const std::string& name, suite::Verdict verdict,
                           const image::Image& expected, const image::Image& got) {
    suite::ShotResult made = shot(name, verdict);
    made.expected = "goldens/" + name + (verdict == suite::Verdict::unstable ? ".again.png" : ".png");
    made.got = "got/" + name + ".png";
    made.judgement.comparison = image::compare(expected, got);
    made.judgement.decidedBy =
        made.judgement.comparison.sameSize ? image::Rung::differences : image::Rung::size;
    made.judgement.beyond = made.judgement.comparison.differingPixels;
    made.judgement.bias = 1.25;
    made.judgement.flip = 0.0123;
    made.judgement.reason = "100 pixels differ by more than 3/255 (allowed: 0)";
    made.width = got.width;
    made.height = got.height;
    (void)image::writeImage(expected, results / made.expected);
    (void)image::writeImage(got, results / made.got);
    if (made.judgement.comparison.sameSize && got.type == image::Component::u8) {
        made.difference = "difference/" + name + ".png";
        (void)image::writeImage(heatOf(expected, got), results / made.difference);
    }
    return made;
}

void writeScene(const fs::path& path) {
    std::ofstream(path) << "##OpenGL GLIB\n"
                           "# </script><script>window.hacked = 1</script>\n"
                           "Vertex <img src=x onerror=window.hacked=2>.vert\n"
                           "Program P uA \"&amp; {{data}}\"\n"
                           "Sphere 1 60 60\n";
}

suite::RunResult sampleRun(const fs::path& results, int passes) {
    using suite::Verdict;
    suite::RunResult run;
    run.driver = "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6";
    run.machine = "a machine <of> two processors";
    run.command = "glibra test sample.toml --report report";
    run.seconds = 75.4;
    run.began = "2026-01-31T12:00:00Z";

    const image::Image golden = gradient(), changed = withSquare();
    for (int i = 0; i < passes; ++i) {
        char name[16];
        std::snprintf(name, sizeof name, "pass%05d", i);
        suite::ShotResult pass = shot(name, Verdict::passed);
        pass.exact = true;
        pass.got = "goldens/failed.png";
        run.shots.push_back(pass);
    }
    run.shots.push_back(compared(results, "within", Verdict::passed, golden, changed));
    run.shots.push_back(compared(results, "changed", Verdict::passed, golden, changed));
    run.shots.back().changed = true;
    run.shots.push_back(shot("skipped", Verdict::skipped));
    run.shots.push_back(compared(results, "updated", Verdict::updated, golden, changed));
    run.shots.push_back(shot("missing", Verdict::missing));
    run.shots.back().got = "got/failed.png";
    run.shots.push_back(compared(results, "unstable", Verdict::unstable, golden, changed));
    run.shots.push_back(compared(results, "refused", Verdict::refused, golden, changed));
    run.shots.push_back(compared(results, "failed", Verdict::failed, golden, changed));
    run.shots.push_back(compared(results, "deep", Verdict::failed, deep(10000), deep(10300)));
    run.shots.push_back(compared(results, "size", Verdict::failed, golden, gradient(32, 24)));
    run.shots.back().reason = "the golden picture has 64 x 48 pixels, this one 32 x 24";
    run.shots.push_back(shot("scene", Verdict::failed));
    run.shots.back().reason = "the scene has errors: </script><b>bold</b>";
    run.shots.back().diagnostics = {
        diagnose("file-E01", "cannot find '<img src=x onerror=window.hacked=2>.vert'", {"scene.glib", 3, 8}),
        diagnose("glib-W02", "text after the continuation backslash ignored", {"scene.glib", 4, 1}),
        diagnose("glsl-E01", "a place <outside>", {"other.frag", 1, 1})};
    run.shots.push_back(shot("crashed", Verdict::crashed));
    run.shots.push_back(shot("timed-out", Verdict::timedOut));
    return run;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) return 2;
    const fs::path folder = arguments[1];
    int passes = 30;
    if (count > 2) std::from_chars(arguments[2], arguments[2] + std::strlen(arguments[2]), passes);
    fs::create_directories(folder / "results/goldens");
    fs::create_directories(folder / "results/got");
    fs::create_directories(folder / "results/difference");
    writeScene(folder / "results/scene.glib");
    const suite::RunResult run = sampleRun(folder / "results", passes);
    Diagnostics problems = suite::writeResults(run, folder / "results");
    append(problems, suite::writeHtmlReport(run, folder / "results", folder / "report"));
    for (const Diagnostic& each : problems) std::fprintf(stderr, "%s\n", toString(each).c_str());
    std::ofstream(folder / "junit.xml") << suite::toJunit(run);
    std::ofstream(folder / "summary.txt") << suite::toText(run, {.resultsFolder = folder / "results"});
    std::ofstream(folder / "summary.ansi")
        << suite::toText(run, {.color = true, .resultsFolder = folder / "results"});
    return problems.empty() ? 0 : 1;
}
