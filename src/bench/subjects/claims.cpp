#include "bench/subjects/claims.h"

#include <array>
#include <utility>

#include "bench/core/device.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// One computation per texel of 1024 x 1024, in work groups of several shapes.
Figure workGroups(Bench& bench) {
    Figure figure{.name = "a44",
                  .title = "Work groups of one invocation waste the device",
                  .settingName = "invocations per group",
                  .errorName = "error",
                  .reference = "the stress test WorkGroups: the same results",
                  .alternatives = Alternatives::none};
    const int side = bench.pick(128, 1024);
    const gpu::Buffer buffer = need(gpu::Buffer::create(4 * static_cast<std::size_t>(side * side)));
    const auto dispatching = [&](int x, int y) -> Draw {
        const std::string text = fmt::format(R"(#version 430 core
layout(local_size_x = {0}, local_size_y = {1}) in;
layout(std430, binding = 0) buffer Result {{ float result[]; }};
void main() {{
    vec2 c = vec2(gl_GlobalInvocationID.xy) / {2}. * 2. - 1.5, z = vec2(0.);
    int n = 0;
    for (; n < 24 && dot(z, z) < 4.; ++n) z = vec2(z.x * z.x - z.y * z.y, 2. * z.x * z.y) + c;
    result[gl_GlobalInvocationID.y * {2}u + gl_GlobalInvocationID.x] = float(n);
}}
)",
                                             x, y, side);
        const Shader shader(bench, std::array{gpu::StageSource{GL_COMPUTE_SHADER, text}});
        return [shader, &buffer, x = static_cast<GLuint>(side / x), y = static_cast<GLuint>(side / y)] {
            shader.use();
            buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
            glDispatchCompute(x, y, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        };
    };
    const Draw one = dispatching(1, 1);
    std::string all;
    for (const auto& [x, y] : {std::pair(1, 1), {8, 8}, {16, 16}, {32, 1}, {64, 1}}) {
        const PairedTiming timing = timedInTurn(bench, one, dispatching(x, y));
        const std::string label = fmt::format("{} x {}", x, y);
        figure.add("time by the shape of the group", {1. * x * y, label, 0, timing.second, 4. * side * side});
        if (x == 8) figure.note("{}: 1 x 1 / 8 x 8", verdict(timing.ratio, false));
        if (x > 1) all += fmt::format("{}{} {:.2f}", all.empty() ? "" : ", ", label, timing.ratio.median);
    }
    figure.note("1 x 1 in times of the other shapes: {}", all);
    return figure;
}

}  // namespace

PairedTiming timedInTurn(Bench& bench, const Draw& slower, const Draw& faster) {
    const auto waited = [](const Draw& draw) {
        return [&draw] {
            draw();
            glFinish();
        };
    };
    return timePairs(waited(slower), waited(faster), bench.pick(5, 11), bench.capabilities().isSoftware);
}

Figure claimFigure(Bench& bench, const Claim& claim) {
    const PairedTiming timing = timedInTurn(bench, claim.slower.draw, claim.faster.draw);
    Figure figure{.name = claim.name,
                  .title = claim.text,
                  .settingName = "work",
                  .errorName = claim.errorName,
                  .errorUnit = claim.errorUnit,
                  .reference = claim.reference};
    for (const auto& [way, time] : {std::pair(&claim.slower, timing.first), {&claim.faster, timing.second}})
        figure.add(way->name, {1, claim.work, way->error, time, way->memory});
    figure.note("{}: {} / {}", verdict(timing.ratio, claim.mayBeEqual), claim.slower.name, claim.faster.name);
    return figure;
}

std::string pixelsText(int side) {
    return fmt::format("{0} x {0} pixels", side);
}

std::vector<Figure> measureClaims(Bench& bench) {
    std::vector<Figure> figures;
    addFragmentClaims(figures, bench);
    addTextureClaims(figures, bench);
    addMeshClaims(figures, bench);
    if (bench.capabilities().compute) figures.push_back(workGroups(bench));
    return figures;
}

}  // namespace glibra::bench
