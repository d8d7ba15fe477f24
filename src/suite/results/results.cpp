#include "suite/results/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "base/text.h"
#include "image/format.h"
#include "suite/golden/picture_store.h"

namespace glibra::suite {
namespace {

struct VerdictRow {
    const char* word;
    Verdict verdict;
    bool failure;
    const char* meaning;
};

constexpr VerdictRow kVerdicts[] = {
    {"passed", Verdict::passed, false, ""},
    {"failed", Verdict::failed, true, "the picture is not as expected"},
    {"missing", Verdict::missing, true, "there is no golden picture yet"},
    {"unstable", Verdict::unstable, true, "two renderings on this machine differ"},
    {"updated", Verdict::updated, false, "the golden picture was written"},
    {"refused", Verdict::refused, true,
     "the golden picture was kept: the new one is blank, of one colour or not finite"},
    {"crashed", Verdict::crashed, true, "the process that drew it ended"},
    {"timed-out", Verdict::timedOut, true, "it was not drawn in time"},
    {"flaky", Verdict::flaky, false, "one of its drawings was right, others were not"},
    {"quarantined", Verdict::quarantined, false, "it failed during its quarantine"},
    {"skipped", Verdict::skipped, false, "it was not run"},
};

const VerdictRow& rowOf(Verdict verdict) {
    const auto* row = std::ranges::find(kVerdicts, verdict, &VerdictRow::verdict);
    return row != std::end(kVerdicts) ? *row : kVerdicts[1];  // a verdict without a row counts as failed
}

}  // namespace

const char* name(Verdict verdict) {
    return rowOf(verdict).word;
}

const char* meaning(Verdict verdict) {
    return rowOf(verdict).meaning;
}

std::optional<Verdict> verdictOf(std::string_view word) {
    for (const VerdictRow& row : kVerdicts)
        if (row.word == word) return row.verdict;
    return std::nullopt;
}

bool isFailure(Verdict verdict) {
    return rowOf(verdict).failure;
}

bool wasNotDrawn(const ShotResult& shot) {
    return shot.verdict == Verdict::crashed || shot.verdict == Verdict::timedOut ||
           (shot.verdict == Verdict::failed && shot.width == 0);
}

bool isChangedPass(const ShotResult& shot) {
    return shot.verdict == Verdict::passed && shot.changed;
}

bool needsALook(const ShotResult& shot) {
    return isFailure(shot.verdict) || shot.verdict == Verdict::flaky ||
           shot.verdict == Verdict::quarantined || isChangedPass(shot);
}

void makeFlaky(ShotResult& shot, int drawing, const ShotResult& before) {
    shot.reason =
        fmt::format("drawing {} is right; before: {}, {}", drawing, name(before.verdict), before.reason);
    shot.verdict = Verdict::flaky;
    shot.accept.clear();
}

void countFlakyAsFailure(ShotResult& shot) {
    if (shot.verdict == Verdict::flaky) shot.verdict = Verdict::unstable;
}

std::vector<ShotKey> missingShots(const RunResult& run) {
    std::set<ShotKey> judged;
    for (const ShotResult& each : run.shots)
        if (each.verdict != Verdict::skipped) judged.emplace(each.suite, each.shot);
    std::vector<ShotKey> missing;
    if (run.planned)
        for (const PlannedShots& suite : *run.planned)
            for (const std::string& shot : suite.shots)
                if (!judged.contains({suite.suite, shot})) missing.emplace_back(suite.suite, shot);
    return missing;
}

std::string shortfall(const RunResult& run) {
    const std::string shots = shortfall(missingShots(run), plannedCount(run));
    return run.missingShards + (run.missingShards.empty() || shots.empty() ? "" : "; ") + shots;
}

std::string shortfall(const std::vector<ShotKey>& missing, std::size_t planned) {
    if (missing.empty()) return {};
    constexpr std::size_t kMostNames = 5;
    std::string names;
    for (std::size_t i = 0; i < std::min(missing.size(), kMostNames); ++i)
        names += fmt::format("{}{}/{}", i == 0 ? "" : ", ", missing[i].first, missing[i].second);
    return fmt::format("{} of {} planned shots have no verdict: {}{}", missing.size(), planned, names,
                       missing.size() > kMostNames ? ", ..." : "");
}

std::vector<std::string> orphanLines(const RunResult& run, std::size_t most) {
    std::map<std::string, std::vector<std::string>> bySuite;
    for (const OrphanGolden& each : run.orphans) bySuite[each.suite].push_back(each.file);
    std::vector<std::string> lines;
    for (const auto& [suite, files] : bySuite) {
        std::string line = fmt::format(
            "{} of no shot of '{}' (--prune removes them):", base::counted(files.size(), "golden"), suite);
        for (std::size_t i = 0; i < std::min(files.size(), most); ++i) line += " " + files[i];
        if (files.size() > most) line += fmt::format(" and {} more", files.size() - most);
        lines.push_back(std::move(line));
    }
    return lines;
}

std::string awaitedLine(const RunResult& run) {
    std::set<std::filesystem::path> goldens;
    for (const ShotResult& each : run.shots)
        if (!each.awaitsStore) goldens.insert(each.awaits.begin(), each.awaits.end());
    if (goldens.empty()) return {};
    return fmt::format("{} of Git LFS {} downloaded for a comparison; run `{}`, then continue with --resume",
                       base::counted(goldens.size(), "picture"),
                       goldens.size() == 1 ? "has to be" : "have to be",
                       pullCommand(std::vector(goldens.begin(), goldens.end())));
}

std::size_t plannedCount(const RunResult& run) {
    std::size_t count = 0;
    if (run.planned)
        for (const PlannedShots& each : *run.planned) count += each.shots.size();
    return count;
}

namespace {

bool isFloat(const ShotResult& shot) {
    return image::holdsFloats(shot.got) || image::holdsFloats(shot.expected);
}

std::string of255(double value) {
    return fmt::format("{:.4g}/255", value);
}

std::string share(std::uint64_t pixels, double all) {
    if (all < 1) return fmt::format("{}", pixels);
    return fmt::format("{} ({:.3g} %)", pixels, 100 * static_cast<double>(pixels) / all);
}

Figure largest(const ShotResult& shot) {
    constexpr std::array kComponents{"red", "green", "blue", "alpha"};
    const image::Comparison& measured = shot.judgement.comparison;
    const std::size_t component = static_cast<std::size_t>(std::clamp(measured.component, 0, 3));
    const std::string place =
        fmt::format(" ({}, at {} {})", kComponents.at(component), measured.x, measured.y);
    Figure figure{"largest difference", "", "", false};
    if (std::isinf(measured.largest)) {
        figure.value = "not a number" + place;
        figure.beyond = true;
    } else if (isFloat(shot)) {
        figure.value = fmt::format("{:.4g}", measured.largest) + place;
        figure.limit =
            fmt::format("{:.4g} + {:.4g} of the value", shot.tolerance.absolute, shot.tolerance.relative);
        figure.beyond = shot.judgement.beyond > 0;
    } else {
        figure.value = of255(measured.largest * 255);
        if (measured.largest > 0) figure.value += place;
        figure.limit = of255(shot.tolerance.largest);
        figure.beyond = measured.largest * 255 > shot.tolerance.largest * (1 + 1e-12);
    }
    return figure;
}

Figure perceptual(const char* title, double value, std::optional<double> limit) {
    const auto text = [](double number) {
        return std::abs(number) < 1000 ? fmt::format("{:.5f}", number) : fmt::format("{:.5g}", number);
    };
    return {title, text(value), limit ? text(*limit) : "", limit && value > *limit};
}

}  // namespace

std::vector<Figure> figures(const ShotResult& shot) {
    const image::Judgement& judgement = shot.judgement;
    const double pixels = static_cast<double>(shot.width) * shot.height;
    std::vector<Figure> list;
    if (shot.compared < 1)
        list.push_back({"pixels compared",
                        share(static_cast<std::uint64_t>(std::llround(shot.compared * pixels)), pixels), "",
                        false});
    if (judgement.decidedBy == image::Rung::bytes || judgement.decidedBy == image::Rung::size) return list;
    list.push_back(largest(shot));
    list.push_back({"pixels beyond it", share(judgement.beyond, pixels),
                    fmt::format("{:.3g} %", 100 * shot.tolerance.fraction),
                    pixels > 0 && static_cast<double>(judgement.beyond) > shot.tolerance.fraction * pixels});
    if (judgement.cluster > 0)
        list.push_back(
            {"largest group",
             fmt::format("{} (at {} {})", judgement.cluster, judgement.clusterX, judgement.clusterY),
             fmt::format("{}", shot.tolerance.cluster),
             std::cmp_greater(judgement.cluster, shot.tolerance.cluster)});
    if (judgement.line > 0)
        list.push_back({"most in a row or column", fmt::format("{}", judgement.line),
                        fmt::format("{}", shot.tolerance.line),
                        std::cmp_greater(judgement.line, shot.tolerance.line)});
    list.push_back({"pixels that differ", share(judgement.comparison.differingPixels, pixels), "", false});
    if (std::string steps = stepsText(shot); !steps.empty())
        list.push_back({"by more than", std::move(steps), "", false});
    list.push_back(
        {"root mean square", fmt::format("{:.4g}", judgement.comparison.rootMeanSquare), "", false});
    if (!isFloat(shot))
        list.push_back(
            {"bias of a block",
             (image::limitedBias(judgement, shot.tolerance) == image::Limited::wholly ? "at least " : "") +
                 of255(judgement.bias) +
                 (judgement.bias > 0 ? fmt::format(" (at {} {})", judgement.biasX, judgement.biasY) : ""),
             of255(shot.tolerance.bias), judgement.bias > shot.tolerance.bias});
    if (judgement.flip) list.push_back(perceptual("FLIP", *judgement.flip, shot.tolerance.flip));
    if (judgement.structure)
        list.push_back(perceptual("structure", *judgement.structure, shot.tolerance.structure));
    return list;
}

std::string stepsText(const ShotResult& shot) {
    const image::DifferenceSteps& steps = shot.steps;
    std::string text;
    constexpr std::size_t kMost = 8;  // results of others may have any number
    for (std::size_t i = 0; i < std::min({steps.limits.size(), steps.pixels.size(), kMost}); ++i) {
        text += fmt::format("{}{:g}: {}", i == 0 ? "" : ", ", steps.limits[i], steps.pixels[i]);
        if (steps.pixels[i] == 0) break;
    }
    if (text.empty()) return text;
    return text + (isFloat(shot) ? " of the value" : " of 255");
}

std::string decision(const ShotResult& shot) {
    switch (shot.judgement.decidedBy) {
        case image::Rung::size:
            return "size";
        case image::Rung::bytes:
            return shot.exact || shot.judgement.same ? "equal bytes" : "";
        case image::Rung::differences:
            return "differences";
        case image::Rung::bias:
            return "bias of a block";
        case image::Rung::structure:
            return "structure";
        case image::Rung::flip:
            return "FLIP";
    }
    return "";
}

PictureTitles titlesOf(const ShotResult& shot) {
    const std::string what = shot.expected.stem().extension().generic_string();
    if (what == ".again") return {"second drawing", "first drawing"};
    if (what == ".partner") return {"the other shot", "this shot"};
    return {"expected", "got"};
}

std::string reasonOf(const ShotResult& shot) {
    if (!shot.reason.empty()) return shot.reason;
    if (shot.verdict == Verdict::passed && shot.changed)
        return "within the tolerance, but this driver and processor once gave other bytes";
    if (shot.verdict == Verdict::failed && !shot.judgement.reason.empty()) return shot.judgement.reason;
    return meaning(shot.verdict);
}

std::string counts(const RunResult& run) {
    const auto count = [&](Verdict verdict) {
        return std::ranges::count(run.shots, verdict, &ShotResult::verdict);
    };
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    // A golden is missing for pictures that were drawn: that is no failure of a scene.
    const auto drawn = count(Verdict::missing);
    const bool hasGolden = std::ranges::any_of(run.shots, [](const ShotResult& shot) {
        return !shot.expected.empty() || shot.verdict == Verdict::passed ||
               shot.verdict == Verdict::updated || shot.verdict == Verdict::refused;
    });
    if (drawn > 0) add(fmt::format("{} drawn{}", drawn, hasGolden ? " without a golden" : ""));
    for (const Verdict verdict : kVerdictsByConcern)
        if (const auto number = count(verdict); number > 0 && verdict != Verdict::missing)
            add(fmt::format("{} {}", number, name(verdict)));
    if (drawn > 0 && !hasGolden)
        add(drawn == 1 && run.shots.size() == 1 ? "it has no golden yet" : "none has a golden yet");
    return text.empty() ? "no shots" : text;
}

std::string readableTime(double seconds) {
    if (!(seconds >= 0 && seconds < 1e9)) return "unknown time";
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
    const auto whole = static_cast<long long>(std::lround(seconds));
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace glibra::suite
