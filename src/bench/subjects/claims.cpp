#include "bench/subjects/claims.h"

#include <fmt/format.h>

#include <iterator>

#include "bench/core/fit.h"
#include "bench/subjects/claim.h"

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

Figure figureOf(const ClaimSetup& setup, const Claim& claim) {
    const PairedTiming timing = setup.time(claim.slower.draw, claim.faster.draw);
    Figure figure{.name = claim.name,
                  .title = claim.text,
                  .settingName = "work",
                  .errorName = claim.errorName,
                  .errorUnit = claim.errorUnit,
                  .reference = claim.reference,
                  .curves = {curveOf(claim.slower, claim.work, timing.first),
                             curveOf(claim.faster, claim.work, timing.second)},
                  .alternatives = Alternatives::figure};
    figure.findings.push_back(fmt::format("{}: {} / {}", verdict(timing.ratio, claim.mayBeEqual),
                                          claim.slower.name, claim.faster.name));
    figure.findings.insert(figure.findings.end(), claim.findings.begin(), claim.findings.end());
    return figure;
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
