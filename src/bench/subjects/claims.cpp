#include <fmt/format.h>

#include <iterator>

#include "bench/core/fit.h"
#include "bench/subjects/claim.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// Ratios within this of 1 are no difference.
constexpr double kNoDifference = .03;

Curve curveOf(const Way& way, const std::string& work, const Timing& time) {
    return {
        .name = way.name,
        .points = {{.setting = 1, .label = work, .error = way.error, .time = time, .memory = way.memory}}};
}

}  // namespace

PairedTiming ClaimSetup::time(const std::function<void()>& slower,
                              const std::function<void()>& faster) const {
    const auto waited = [](const std::function<void()>& draw) {
        return [&draw] {
            draw();
            glFinish();
        };
    };
    return timePairs(waited(slower), waited(faster), pairs(), capabilities().isSoftware);
}

std::string verdict(const Timing& ratio, bool mayBeEqual) {
    const std::string range = fmt::format("{:.2f} ({:.2f} .. {:.2f})", ratio.median, ratio.low, ratio.high);
    if (ratio.low > 1 + kNoDifference) return "true here, by " + range;
    if (ratio.high < 1 - kNoDifference)
        return fmt::format("false here: the ratio is {}, so the other way is faster by {:.2f}", range,
                           1 / ratio.median);
    return fmt::format("{}: no difference here, the ratio is {}", mayBeEqual ? "true here" : "false here",
                       range);
}

Result<std::shared_ptr<gpu::Target>> targetOf(const ClaimSetup& setup, int side, gpu::TexelFormat format) {
    Result<gpu::Target> target = gpu::Target::window(setup.capabilities(), side, side, format);
    if (!target) return std::move(target.diagnostics);
    return shared(std::move(*target));
}

Figure figureOf(const ClaimSetup& setup, const Claim& claim) {
    const PairedTiming timing = setup.time(claim.slower.draw, claim.faster.draw);
    return {.name = claim.name,
            .title = claim.text,
            .settingName = "work",
            .errorName = claim.errorName,
            .errorUnit = claim.errorUnit,
            .reference = claim.reference,
            .curves = {curveOf(claim.slower, claim.work, timing.first),
                       curveOf(claim.faster, claim.work, timing.second)},
            .findings = {fmt::format("{}: {} / {}", verdict(timing.ratio, claim.mayBeEqual),
                                     claim.slower.name, claim.faster.name)}};
}

Result<std::vector<Figure>> measureClaims(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const ClaimSetup setup{bench, **context};
    std::vector<Figure> figures;
    for (auto* measure :
         {measureFragmentClaims, measureTextureClaims, measureMeshClaims, measureGroupClaims}) {
        Result<std::vector<Figure>> found = measure(setup);
        if (!found) return found;
        std::move(found->begin(), found->end(), std::back_inserter(figures));
    }
    return figures;
}

}  // namespace glibra::bench
