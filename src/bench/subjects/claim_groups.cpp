// A claim about the shapes of work groups.

#include <fmt/format.h>

#include <array>
#include <string>

#include "bench/draw/offscreen.h"
#include "bench/subjects/claim.h"
#include "gpu/object/buffer.h"

namespace glibra::bench {
namespace {

/// One computation per texel of 1024 x 1024, in work groups of several shapes.
Result<Figure> workGroups(const ClaimSetup& setup) {
    Figure figure{.name = "a44",
                  .title = "Work groups of one invocation waste the device",
                  .settingName = "invocations per group",
                  .errorName = "error",
                  .errorUnit = "",
                  .reference = "the stress test WorkGroups: the same results",
                  .curves = {{"time by the shape of the group"}},
                  .alternatives = Alternatives::none};
    const int side = setup.bench.isQuick() ? 128 : 1024;
    struct Dispatch {
        gpu::Program program;
        gpu::Buffer buffer;
        GLuint x, y;
        void run() const {
            program.use();
            buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
            glDispatchCompute(x, y, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        }
    };
    std::vector<std::shared_ptr<Dispatch>> dispatches;
    std::vector<std::string> labels;
    constexpr std::array<std::array<int, 2>, 5> kShapes{{{1, 1}, {8, 8}, {16, 16}, {32, 1}, {64, 1}}};
    for (const auto& [x, y] : kShapes) {
        const std::string text = fmt::format(
            "#version 430 core\nlayout(local_size_x = {}, local_size_y = {}) in;\n"
            "layout(std430, binding = 0) buffer Result {{ float result[]; }};\nvoid main() {{\n"
            "    vec2 c = vec2(gl_GlobalInvocationID.xy) / {}. * 2. - 1.5, z = vec2(0.);\n"
            "    int n = 0;\n    for (; n < 24 && dot(z, z) < 4.; ++n) z = vec2(z.x * z.x - z.y * z.y, 2. * "
            "z.x * "
            "z.y) + c;\n"
            "    result[gl_GlobalInvocationID.y * {}u + gl_GlobalInvocationID.x] = float(n);\n}}\n",
            x, y, side, side);
        const std::vector<gpu::StageSource> stages{{GL_COMPUTE_SHADER, text}};
        Result<gpu::Program> built = program(setup.capabilities(), stages);
        if (!built) return std::move(built.diagnostics);
        Result<gpu::Buffer> buffer = gpu::Buffer::create(4 * static_cast<std::size_t>(side * side));
        if (!buffer) return std::move(buffer.diagnostics);
        dispatches.push_back(shared(Dispatch{std::move(*built), std::move(*buffer),
                                             static_cast<GLuint>(side / x), static_cast<GLuint>(side / y)}));
        labels.push_back(fmt::format("{} x {}", x, y));
    }
    Timing first;
    std::string all;
    for (std::size_t i = 0; i < dispatches.size(); ++i) {
        const auto &one = dispatches[0], &other = dispatches[i];
        const PairedTiming timing = setup.time([one] { one->run(); }, [other] { other->run(); });
        figure.curves[0].points.push_back({.setting = 1. * kShapes.at(i)[0] * kShapes.at(i)[1],
                                           .label = labels[i],
                                           .time = timing.second,
                                           .memory = 4. * side * side});
        if (i == 1) first = timing.ratio;
        if (i > 0) all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", labels[i], timing.ratio.median);
    }
    figure.findings = {verdict(first, false) + ": 1 x 1 / 8 x 8",
                       "1 x 1 in times of the other shapes: " + all};
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureGroupClaims(const ClaimSetup& setup) {
    if (!setup.capabilities().compute) return std::vector<Figure>();
    return measureEach({workGroups}, setup);
}

}  // namespace glibra::bench
