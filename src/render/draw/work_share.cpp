#include "render/draw/work_share.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cstddef>

#include "base/text.h"

namespace glibra::render {
namespace {

/// Rows that are done first, and show how long the others take, at these parts of the height: what is slow
/// need not cover the picture.
constexpr std::array<int, 3> kProbes{1, 3, 5};  // sixths
constexpr int kRowsOfProbe = 128;               ///< as a part of the height
constexpr int kFewestRows = 16;                 ///< of a draw that is cut
constexpr int kMostParts = 64;                  ///< that a draw is cut into because of what each costs

}  // namespace

Shares doInShares(int rows, double share, const std::function<void(int first, int end)>& work,
                  const std::function<double()>& wait) {
    const auto whole = [&] {
        work(0, rows);
        return Shares{1, wait()};
    };
    if (rows < kFewestRows) return whole();
    work(0, 0);
    const double own = wait();
    if (own > share) return whole();  // what every part repeats is the longest of all
    const int height = std::max(1, rows / kRowsOfProbe);
    int done = 0;
    std::array<std::array<int, 2>, kProbes.size() + 1> gaps{};
    for (std::size_t i = 0; i < kProbes.size(); ++i) {
        const int first = rows * kProbes.at(i) / 6;
        work(first, first + height);
        gaps.at(i) = {done, first};
        done = first + height;
    }
    gaps.back() = {done, rows};
    Shares shares{static_cast<int>(kProbes.size()), wait()};
    // Of a row, as if one probe had taken all of the time.
    double slowest = std::max(0., shares.seconds - own) / height;
    const bool isQuick = slowest * rows < kQuickShare * share;
    const int fewest = own > share / kMostParts ? std::max(1, rows / kMostParts) : 1;
    for (const auto& [begin, end] : gaps)
        for (int first = begin; first < end; ++shares.parts) {
            const double fitting = isQuick || slowest <= 0 ? rows : share / slowest;
            const int count = std::max(1, static_cast<int>(std::clamp<double>(fitting, fewest, end - first)));
            work(first, first + count);
            first += count;
            if (isQuick) continue;
            const double taken = wait();
            shares.seconds += taken;
            slowest = std::max(slowest, (taken - own) / count);
        }
    if (isQuick) shares.seconds = slowest * rows + own;
    return shares;
}

// ---- Dispatches

std::string lackOfCompute(const gpu::Capabilities& driver) {
    if (driver.compute) return {};
    return fmt::format("OpenGL 4.3; this one has {}.{}", driver.major, driver.minor);
}

Result<std::array<unsigned, 3>> checkedGroups(const GroupCounts& groups, const gpu::Capabilities& driver,
                                              const Place& place) {
    std::array<unsigned, 3> checked{};
    constexpr const char* kAxes = "xyz";
    for (std::size_t axis = 0; axis < groups.size(); ++axis) {
        const auto most = static_cast<std::uint64_t>(std::max(0, driver.maxComputeGroups[axis]));
        if (groups[axis] > most)
            return diagnose("memory-E06",
                            fmt::format("Dispatch: {} groups along {}; this driver allows {}",
                                        base::groupedText(static_cast<long long>(
                                            std::min<std::uint64_t>(groups[axis], std::uint64_t{1} << 62))),
                                        kAxes[axis], base::groupedText(most)),
                            place);
        checked[axis] = static_cast<unsigned>(groups[axis]);
    }
    if (!driver.isSoftware) return checked;
    // llvmpipe: lp_cs_tpool_queue_task() takes an int.
    constexpr std::uint64_t kMostOfSoftware = (std::uint64_t{1} << 31) - 1;
    const std::uint64_t all = groups[0] * groups[1] * groups[2];  // each count has 16 bits there
    if (all <= kMostOfSoftware) return checked;
    return {
        checked,
        {diagnose("draw-W18",
                  fmt::format("Dispatch: {} groups in all; this driver counts at most {}, and may not run "
                              "the others; dispatch fewer groups, or divide them with tiles",
                              base::groupedText(all), base::groupedText(kMostOfSoftware)),
                  place)}};
}

// ---- Patches

namespace {

constexpr const char* kFirstPatch = "glibra_FirstPatch";
constexpr const char* kPatch = "glibra_Patch";  // in a geometry stage

bool reads(const glsl::TranslatedStage& stage, const char* name) {
    return stage.source.find(name) != std::string::npos;
}

bool anyReads(const glsl::TranslatedProgram& program, const char* name) {
    return std::ranges::any_of(program.stages,
                               [name](const glsl::TranslatedStage& each) { return reads(each, name); });
}

bool hasStage(const glsl::TranslatedProgram& program, glsl::Stage stage) {
    return std::ranges::any_of(program.stages,
                               [stage](const glsl::TranslatedStage& each) { return each.stage == stage; });
}

/// Without translation a stage reads the driver's numbers, those within one draw. A fragment stage after a
/// geometry stage gets what that stage writes.
bool numbersWithinDraw(const glsl::TranslatedProgram& program) {
    const bool hasGeometry = hasStage(program, glsl::Stage::geometry);
    return std::ranges::any_of(program.stages, [&](const glsl::TranslatedStage& each) {
        if (each.stage == glsl::Stage::geometry)
            return reads(each, "gl_PrimitiveIDIn") && !reads(each, kPatch);
        if (each.stage == glsl::Stage::fragment && hasGeometry) return false;
        return reads(each, "gl_PrimitiveID") && !reads(each, kFirstPatch);
    });
}

/// The location in the program in use, or -1.
GLint locationOf(const glsl::TranslatedProgram& program, const char* name) {
    if (!anyReads(program, name)) return -1;
    GLint inUse = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &inUse);
    return glGetUniformLocation(static_cast<GLuint>(inUse), name);
}

/// The number of patches to draw per call, at least 1.
int patchesAtOnce(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program,
                  int patchVertices) {
    constexpr int kAll = 1 << 24;  // times 32 vertices per patch still fits an int
    if (!driver.tessellatesInSoftware || numbersWithinDraw(program)) return kAll;
    // The vertices along one side of a patch at the highest level; without a control stage all levels are 1.
    const int side = hasStage(program, glsl::Stage::tessControl) ? driver.maxTessellationLevel + 1 : 2;
    const int most = std::max(1, 65'536 / (side * side));
    return anyReads(program, kFirstPatch) ? std::min(most, std::max(1, 1024 / patchVertices)) : most;
}

}  // namespace

void setFirstPatch(const glsl::TranslatedProgram& program, int patch) {
    if (const GLint location = locationOf(program, kFirstPatch); location >= 0) glUniform1i(location, patch);
}

void drawPatches(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program, int patchVertices,
                 int indexCount, const std::function<void(int first, int count)>& drawPart) {
    const int atOnce = patchesAtOnce(driver, program, patchVertices);
    const int indices = atOnce * patchVertices;
    const GLint firstPatch = locationOf(program, kFirstPatch);
    for (int first = 0, patch = 0; first < indexCount; first += indices, patch += atOnce) {
        if (firstPatch >= 0) glUniform1i(firstPatch, patch);
        drawPart(first, std::min(indices, indexCount - first));
    }
}

}  // namespace glibra::render
