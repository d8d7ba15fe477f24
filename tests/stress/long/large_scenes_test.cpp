// The largest scenes that the language allows: a model of ten million triangles, a million draws, a thousand
// programs, and pictures of 16,384 pixels per side (exercises' accuracy table 30). The tests print their
// times and memory.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "render/scene_renderer.h"
#include "scene/primitives.h"
#include "support.h"

namespace glibra::stress {
namespace {

namespace fs = std::filesystem;

/// A temporary folder. The destructor removes it with its files.
class Folder {
  public:
    Folder() {
        char name[] = "/tmp/glibra-large-XXXXXX";
        if (!::mkdtemp(name)) throw std::runtime_error("mkdtemp");
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }
    fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The peak resident memory of this process in MiB; 0 if the system does not report it.
long peakMemory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stol(line.substr(6)) / 1024;
    return 0;
}

class Stopwatch {
  public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A torus around z with ring radius 1 and tube radius 1/2 as OBJ text. Each vertex occurs once; there is no
/// seam.
constexpr int kRings = 2240;
constexpr int kSides = 2236;
fs::path writeTorus(const Folder& folder) {
    fs::path path = folder.path() / "torus.obj";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
    if (!file) throw std::runtime_error("cannot write " + path.string());
    std::string text;
    const auto flush = [&](std::size_t least) {
        if (text.size() < least) return;
        if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size())
            throw std::runtime_error("disk full");
        text.clear();
    };
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kSides; ++j) {
            const double u = 2 * std::numbers::pi * i / kRings;
            const double v = 2 * std::numbers::pi * j / kSides;
            const double r = 1 + .5 * std::cos(v);
            fmt::format_to(std::back_inserter(text), "v {:.7f} {:.7f} {:.7f}\n", r * std::cos(u),
                           r * std::sin(u), .5 * std::sin(v));
            flush(1 << 20);
        }
    const auto index = [](int i, int j) { return i % kRings * kSides + j % kSides + 1; };
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kSides; ++j) {
            fmt::format_to(std::back_inserter(text), "f {0} {1} {2}\nf {0} {2} {3}\n", index(i, j),
                           index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
            flush(1 << 20);
        }
    flush(0);
    return path;
}

TEST(LargeModel, OfTenMillionTrianglesIsReadWhole) {
    const Folder folder;
    const fs::path file = writeTorus(folder);
    const auto bytes = static_cast<double>(fs::file_size(file));
    const scene::Scene scene = interpreted("Obj torus.obj\n", folder.path().string());
    ASSERT_EQ(scene.shapes.size(), 1U);
    const long before = peakMemory();
    const Stopwatch reading;
    const Result<geometry::Mesh> mesh = scene::makeMesh(scene, scene::ShapeIndex(0), false);
    const double seconds = reading.seconds();
    ASSERT_TRUE(mesh) << text(mesh.diagnostics);
    const std::size_t triangles = mesh->indices.size() / 3;
    EXPECT_EQ(triangles, std::size_t{2} * kRings * kSides);
    EXPECT_EQ(mesh->vertexCount(), std::size_t{kRings} * kSides);
    std::printf(
        "%.1f million triangles, file of %.0f MiB: read in %.2f s (%.0f MiB/s), peak memory %ld MiB (%ld "
        "before)\n",
        static_cast<double>(triangles) / 1e6, bytes / 1048576, seconds, bytes / 1048576 / seconds,
        peakMemory(), before);

    // The volume is 2 pi^2 R r^2, reduced by the factor sin(2 pi / n) / (2 pi / n) of a polygon with n
    // corners for the tube, and by about the same factor for the ring. Normals are those of the torus.
    const geometry::Attribute& positions = *mesh->attribute(geometry::kPosition);
    const geometry::Attribute& normals = *mesh->attribute(geometry::kNormal);
    const auto at = [](const geometry::Attribute& attribute, std::uint32_t i) {
        const float* v = attribute.values.data() + std::size_t{3} * i;
        return glm::dvec3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
    };
    double volume = 0;
    for (std::size_t i = 0; i < mesh->indices.size(); i += 3)
        volume += glm::dot(at(positions, mesh->indices[i]), glm::cross(at(positions, mesh->indices[i + 1]),
                                                                       at(positions, mesh->indices[i + 2]))) /
                  6;
    EXPECT_NEAR(volume, 2 * std::numbers::pi * std::numbers::pi * .25, 2e-5);
    double worst = 0;
    for (std::uint32_t i = 0; i < mesh->vertexCount(); ++i) {
        const glm::dvec3 p = at(positions, i);
        const double ring = std::hypot(p.x, p.y);
        const glm::dvec3 n((1 - 1 / ring) * p.x, (1 - 1 / ring) * p.y, p.z);
        worst = std::max(worst, glm::length(2. * n - at(normals, i)));
    }
    EXPECT_LT(worst, 2e-3);  // the file has seven digits, and faces have a size of .001
}

TEST(LargeModel, OfTenMillionTrianglesIsDrawn) {
    const Folder folder;
    writeTorus(folder);
    const std::string view = "WindowSize 400 400\nBackground 0\nPerspective 40\nLookAt 1 2 3 0 0 0 0 1 0\n";
    const Files files = shaded("normalize(vN)");
    for (const auto& [name, content] : files) folder.write(name, content);
    const fs::path large = folder.write("large.glib", view + kProgram + "Obj torus.obj\n");
    RenderOptions options;
    options.floatPixels = true;
    render::Stats stats;
    const Stopwatch drawing;
    auto loaded = render::SceneRenderer::load(context(), large, options, stats);
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    const auto picture = loaded->draw(0, stats);
    ASSERT_TRUE(picture) << text(picture.diagnostics);
    std::printf("drawn in %.2f s, peak memory %ld MiB\n", drawing.seconds(), peakMemory());
    const FloatPicture smooth = draw(view + kProgram + "Torus 1 .5 400 400\n", files);
    ASSERT_EQ(picture->data.size(), smooth.values.size() * sizeof(float));
    std::size_t differing = 0;
    for (std::size_t i = 0; i < smooth.values.size(); i += 3) {
        std::array<float, 3> seen{};
        std::memcpy(seen.data(), picture->data.data() + i * sizeof(float), sizeof seen);
        bool same = true;
        for (std::size_t k = 0; k < 3; ++k) same = same && std::abs(seen[k] - smooth.values[i + k]) < .02F;
        differing += same ? 0 : 1;
    }
    EXPECT_LT(differing, 200U);  // pixels of the silhouette
}

TEST(ManyDraws, AMillionCoverEachPixelOncePerFrame) {
    // The largest number of draws that 200,000 statements per scene allow, in eleven frames.
    constexpr int kSide = 307;
    std::string scene = fmt::format(
        "WindowSize {0} {0}\nBackground 0\nOrtho 0 {0} 0 {0}\nLookAt -.5 -.5 5 -.5 -.5 0 0 1 0\n{1}", kSide,
        kProgram);
    for (int y = 0; y < kSide; ++y) {
        scene += "PushMatrix\n";
        for (int x = 0; x < kSide; ++x)
            scene += x == 0 ? "QuadXY 0 .5 1 1\n" : "Translate 1 0 0\nQuadXY 0 .5 1 1\n";
        scene += "PopMatrix\nTranslate 0 1 0\n";
    }
    const Folder folder;
    folder.write("v.vert",
                 "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
    folder.write("f.frag", addingFragment("1., Timer, 0."));
    RenderOptions options;
    options.floatPixels = true;
    render::Stats stats;
    auto loaded = render::SceneRenderer::load(context(), folder.write("scene.glib", scene), options, stats);
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    const Stopwatch watch;
    std::size_t draws = 0;
    for (int frame = 0; draws < 1'000'000; ++frame) {
        const auto picture = loaded->draw(frame * .625, stats);
        ASSERT_TRUE(picture);
        draws += std::size_t{kSide} * kSide;
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < std::size_t{kSide} * kSide; ++i) {
            std::array<float, 2> seen{};
            std::memcpy(seen.data(), picture->data.data() + 12 * i, sizeof seen);
            wrong += seen[0] == 1 && seen[1] == static_cast<float>(frame * .0625) ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0U) << frame;
    }
    std::printf("%zu draws in %.2f s: %.2f microseconds per draw, peak memory %ld MiB\n", draws,
                watch.seconds(), watch.seconds() / static_cast<double>(draws) * 1e6, peakMemory());
}

TEST(ManyDraws, BeyondTheStatementsOfASceneAreRejected) {
    std::string scene;
    for (int i = 0; i < 200'001; ++i) scene += "Box\n";
    const Result<FloatPicture> picture = tryDraw(scene);
    EXPECT_FALSE(picture);
    EXPECT_TRUE(has(picture.diagnostics, "glib-E15")) << text(picture.diagnostics);
}

TEST(ManyPrograms, AThousandDifferentOnesDrawTheirOwnColours) {
    const Stopwatch watch;
    for (int scene = 0; scene < 4; ++scene) {
        Files files{
            {"v.vert",
             "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"}};
        std::string script =
            "WindowSize 1 250\nBackground 0\nOrtho 0 1 0 250\nLookAt -.5 -.5 5 -.5 -.5 0 0 1 0\nVertex "
            "v.vert\n";
        for (int i = 0; i < 250; ++i) {
            files[fmt::format("{}.frag", i)] = fmt::format(
                "#version 330 core\nuniform float uScale;\nout vec4 fColor;\n"
                "void main() {{ fColor = vec4(uScale * {}., {}., gl_FragCoord.y, 1.); }}\n",
                i, scene);
            script +=
                fmt::format("Fragment {0}.frag\nProgram P{0} uScale {1}\nQuadXY 0 .5 1 1\nTranslate 0 1 0\n",
                            i, 2 + i % 3);
        }
        // A quad of half size .5 around y = i covers the pixel whose centre lies i + .5 above the box's lower
        // edge at -.5.
        const FloatPicture picture = draw(script, files);
        ASSERT_EQ(picture.height, 250);
        std::size_t wrong = 0;
        for (int i = 0; i < 250; ++i) {
            const auto seen = picture.at(0, 249 - i);
            wrong += seen[0] == static_cast<float>((2 + i % 3) * i) && seen[1] == static_cast<float>(scene)
                         ? 0
                         : 1;
        }
        EXPECT_EQ(wrong, 0U) << scene;
    }
    std::printf("1000 programs in %.2f s, peak memory %ld MiB\n", watch.seconds(), peakMemory());
}

TEST(ManyPrograms, MoreThanASceneMayHaveAreRejected) {
    std::string scene;
    for (int i = 0; i < 257; ++i) scene += fmt::format("Program P{}\n", i);
    const Result<FloatPicture> picture = tryDraw(scene);
    EXPECT_FALSE(picture);
    EXPECT_TRUE(has(picture.diagnostics, "glib-E15")) << text(picture.diagnostics);
}

TEST(LargePicture, Of16384PixelsPerSideEqualsSmallPicturesOfItsStrips) {
    constexpr int kSide = 16384;
    const Folder folder;
    for (const auto& [name, content] : shaded("fract(vMC.xyz * .75) * (gl_FrontFacing ? 1. : .5)"))
        folder.write(name, content);
    const auto sceneFor = [&](const std::string& name, int x, int y, int width, int height) {
        return folder.write(
            name, fmt::format("WindowSize {} {}\nBackground 0\nOrtho {} {} {} {} -20000 20000\nLookAt 0 0 0 "
                              "0 0 -1 0 1 0\n{}"
                              "Translate 8192.3 8192.7 0\nRotate 33 1 2 3\nScale 4000\nTorus 1.3 .6 90 180\n",
                              width, height, x, x + width, y, y + height, kProgram));
    };
    RenderOptions options;
    render::Stats stats;
    const auto drawn = [&](const fs::path& scene) {
        auto loaded = render::SceneRenderer::load(context(), scene, options, stats);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        auto picture = loaded->draw(0, stats);
        EXPECT_TRUE(picture) << text(picture.diagnostics);
        return std::move(*picture);
    };
    const Stopwatch watch;
    const image::Image whole = drawn(sceneFor("whole.glib", 0, 0, kSide, kSide));
    ASSERT_EQ(whole.width, kSide);
    ASSERT_EQ(whole.data.size(), std::size_t{3} * kSide * kSide);
    std::printf("16384 x 16384 drawn in %.2f s, peak memory %ld MiB\n", watch.seconds(), peakMemory());
    struct Strip {
        int x, y, width, height;
    };
    // Strips across the joints of the tiles at 4096, along the border, and in the middle.
    for (const Strip& strip :
         {Strip{0, 4080, kSide, 32}, Strip{8180, 0, 24, kSide}, Strip{0, 8192, 2048, 512},
          Strip{kSide - 64, 0, 64, 64}, Strip{12'200, 12'200, 300, 300}}) {
        const image::Image part = drawn(sceneFor("part.glib", strip.x, strip.y, strip.width, strip.height));
        std::size_t differing = 0;
        for (int row = 0; row < strip.height; ++row) {
            const std::byte* a = part.row(row).data();
            const std::byte* b = whole.row(kSide - strip.y - strip.height + row).data() +
                                 std::size_t{3} * static_cast<std::size_t>(strip.x);
            for (int x = 0; x < strip.width; ++x) {
                int most = 0;
                for (int k = 0; k < 3; ++k)
                    most = std::max(most, std::abs(std::to_integer<int>(a[3 * x + k]) -
                                                   std::to_integer<int>(b[3 * x + k])));
                differing += most > 2 ? 1 : 0;
            }
        }
        const std::size_t pixels =
            static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height);
        // Pixels on an edge, and pixels where the colour jumps from 1 to 0.
        EXPECT_LT(differing, pixels / 200) << strip.x << " " << strip.y;
        std::printf("strip %d x %d: %zu of %zu pixels differ\n", strip.width, strip.height, differing,
                    pixels);
    }
}

}  // namespace
}  // namespace glibra::stress
