#include "suite/run/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/contained.h"
#include "base/text.h"
#include "gpu/context/capabilities.h"
#include "image/compare/compare.h"
#include "image/read.h"
#include "image/write.h"
#include "suite/file/shot_name.h"
#include "suite/golden/ignored.h"
#include "suite/options/option_words.h"
#include "suite/report/terminal_report.h"
#include "suite/write_below.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// The first error. Its place is left out if it is the whole scene.
std::string firstError(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::error) return toString(each);
    return "nothing was drawn";
}

bool isWhollyTransparent(const image::Image& picture) {
    if (picture.type != image::Component::u8 || picture.components != 4) return false;
    for (std::size_t i = 3; i < picture.data.size(); i += 4)
        if (picture.data[i] != std::byte{0}) return false;
    return true;
}

}  // namespace

std::string whyNoGolden(const image::Image& picture) {
    const image::NonFinite bad = image::countNonFinite(picture);
    if (bad.nan + bad.infinite > 0)
        return fmt::format("{} of its values are NaN, {} infinite; the first at pixel {}, {}", bad.nan,
                           bad.infinite, bad.x, bad.y);
    if (image::isOneColor(picture)) return "it has only one colour";
    if (isWhollyTransparent(picture)) return "it is transparent everywhere";
    return {};
}

bool contains(const Diagnostics& diagnostics, const ExpectedError& expected) {
    return std::ranges::any_of(diagnostics, [&](const Diagnostic& each) {
        return each.severity == Severity::error && (expected.id.empty() || each.id == expected.id) &&
               each.text.find(expected.text) != std::string::npos &&
               (expected.line == 0 || each.place.line == expected.line);
    });
}

std::string toPhrase(const ExpectedError& expected) {
    std::string phrase = expected.id.empty() ? "an error" : "the error " + expected.id;
    if (!expected.text.empty()) phrase += fmt::format(" with '{}'", expected.text);
    if (expected.line > 0) phrase += fmt::format(" in line {}", expected.line);
    return phrase;
}

/// The findings about one rendering. If `golden` has no `picture`, it could not be decoded and `problems` say
/// why.
struct ShotJudge::Findings {
    std::optional<Golden> golden;
    fs::path lost;  ///< a golden that is missing though the list of accepted pixels names it
    std::optional<image::Image> picture;
    std::optional<image::Image>
        seen;  ///< the rendering without what the shot ignores, if it ignores something
    Diagnostics problems;
    image::Judgement judgement;
    bool exact = false, changed = false;
    bool goldenHolds = false;
    std::string relation;  ///< why `match` or `differ` does not hold; empty if they do
    const Rendering* partner = nullptr;
    bool partnerFails = false;
    std::vector<fs::path> awaited;  ///< goldens whose pictures are not on this machine, and may be this one
    std::optional<Hash> pixels;     ///< hash of the rendering, if it was needed
};

ShotJudge::ShotJudge(const Suite& suite, const GoldenStore& goldens, std::string family, std::string key,
                     JudgeOptions options)
    : suite_(suite),
      goldens_(goldens),
      family_(std::move(family)),
      key_(std::move(key)),
      options_(std::move(options)),
      suiteHasGoldens_(goldens.hasAny(suite)) {
    const bool isReplaced = goldens.folder() != suite.goldens;
    if (isReplaced)
        acceptOptions_ = " --goldens " + shellWord(goldens.folder().parent_path().generic_string());
    if (hasError(checkGoldenFolder(suite, isReplaced ? goldens.folder() : fs::path())))
        acceptOptions_ += " --allow-outside";
    for (const Shot& each : suite.shots)
        for (const std::string* name : {&each.match, &each.differ})
            if (!name->empty()) partners_.insert(*name);
}

ShotResult ShotJudge::begin(const Attempt& attempt) const {
    ShotResult result = broken(suite_, *attempt.shot, Verdict::failed, {});
    result.diagnostics = attempt.own.diagnostics;
    result.milliseconds = attempt.own.milliseconds;
    if (attempt.own.picture) {
        if (hasOwnGolden(*attempt.shot))
            result.accept = acceptCommand(suite_, *attempt.shot) + acceptOptions_;
        result.width = attempt.own.picture->width;
        result.height = attempt.own.picture->height;
        if (ignoresSomething(*attempt.shot))
            result.compared = comparedPart(*attempt.shot, result.width, result.height);
    }
    return result;
}

ShotResult ShotJudge::broken(const Suite& suite, const Shot& shot, Verdict verdict, std::string reason) {
    ShotResult result;
    result.suite = suite.name;
    result.shot = shot.name;
    result.verdict = verdict;
    result.reason = std::move(reason);
    result.script = shot.script;
    result.tolerance = shot.tolerance;
    result.reproduce = reproduceCommand(shot);
    return result;
}

bool ShotJudge::isCompared(const Attempt& attempt) const {
    const Shot& shot = *attempt.shot;
    return shot.golden || !shot.match.empty() || !shot.differ.empty() || attempt.own.hasChecks ||
           partners_.contains(shot.name);
}

/// suite-E33 for a picture that only such a tolerance passes as any other passes.
static std::optional<Diagnostic> passedByAll(const Shot& shot, const image::Image& expected,
                                             const image::Judgement& judged) {
    const bool isTolerated = judged.same && judged.decidedBy != image::Rung::bytes && shot.statesTolerance;
    if (!isTolerated || !image::passesAll(expected, shot.tolerance)) return std::nullopt;
    return diagnose("suite-E33", "the tolerance passes every picture, so the shot compares nothing",
                    shot.place);
}

void ShotJudge::compare(const Attempt& attempt, bool everything, Findings& found) const {
    const Shot& shot = *attempt.shot;
    if (found.golden->isAbsent) {
        if (std::optional<Golden> equal = goldens_.equalTo(*found.golden, shot, *attempt.own.picture)) {
            found.golden = std::move(equal);
            found.goldenHolds = found.exact = true;
            found.judgement.same = true;
            found.judgement.reason = "equal";
            return;
        }
        found.awaited.push_back(found.golden->file);
    }
    // Whoever wrote the list of accepted pixels, the golden alone decides.
    const Hash* accepted = goldens_.acceptedPixels(shot, *found.golden, key_);
    Result<image::Image> picture = decode(*found.golden);
    append(found.problems, std::move(picture.diagnostics));
    found.picture = std::move(picture.value);
    if (!found.picture) return;
    const bool ignores = ignoresSomething(shot);
    if (ignores) {
        Result<image::Image> seen = withoutIgnored(shot, *found.picture, *attempt.own.picture);
        if (!seen) return append(found.problems, std::move(seen.diagnostics));
        found.seen = std::move(seen.value);
    }
    found.judgement = image::judge(*found.picture, found.seen ? *found.seen : *attempt.own.picture,
                                   shot.tolerance, everything);
    if (std::optional<Diagnostic> nothing = passedByAll(shot, *found.picture, found.judgement))
        return found.problems.push_back(*std::move(nothing));
    found.goldenHolds = found.judgement.same;
    found.exact = found.judgement.same && found.judgement.decidedBy == image::Rung::bytes && !ignores;
    found.changed = accepted && *accepted != *found.pixels;
}

ShotJudge::Findings ShotJudge::look(const Attempt& attempt, bool everything) const {
    const Shot& shot = *attempt.shot;
    const image::Image& got = *attempt.own.picture;
    Findings found;
    found.goldenHolds = !shot.golden;
    if (shot.golden) {
        Result<Golden> golden = goldens_.find(shot, family_);
        append(found.problems, std::move(golden.diagnostics));
        found.golden = std::move(golden.value);
        if (!found.golden && attempt.own.hasChecks && !options_.update && !hasError(found.problems)) {
            found.lost = goldens_.lostGolden(shot);
            found.goldenHolds = !suiteHasGoldens_ && found.lost.empty();
        }
    }
    if (found.golden) {
        found.pixels = hashOf(got);
        compare(attempt, everything, found);
        // The golden for all drivers is right on each of them, so that a family may draw either picture,
        // perhaps in another version. A golden that cannot be read is an error all the same.
        // So are pictures that were accepted besides.
        const auto tryAnother = [&](Result<Golden> golden) {
            if (found.goldenHolds) return;
            if (!golden) return append(found.problems, std::move(golden.diagnostics));
            Findings other;
            other.golden = std::move(golden.value);
            other.pixels = found.pixels;
            compare(attempt, everything, other);
            if (!other.goldenHolds) {
                found.awaited.insert(found.awaited.end(), other.awaited.begin(), other.awaited.end());
                return append(found.problems, std::move(other.problems));
            }
            if (!found.awaited.empty()) found.problems.clear();  // of pictures that are not needed
            other.problems.insert(other.problems.begin(), found.problems.begin(), found.problems.end());
            found = std::move(other);
        };
        const bool isReadable = found.picture || !found.awaited.empty();
        if (!found.goldenHolds && isReadable && !found.golden->variant.empty())
            if (Result<Golden> general = goldens_.find(shot, ""); general && general->variant.empty())
                tryAnother(std::move(general));
        if (!found.goldenHolds && isReadable)
            for (std::string& variant : goldens_.furtherVariants(shot))
                tryAnother(goldens_.read(shot, std::move(variant)));
    }
    const auto relate = [&](const std::optional<Rendering>& partner, const std::string& name, bool same) {
        if (name.empty() || !found.relation.empty()) return;
        const char* word = same ? "match" : "differ from";
        if (!partner) {
            found.partnerFails = true;
            found.relation = fmt::format("the shot '{}', which it has to {}, was not drawn", name, word);
            return;
        }
        if (!partner->picture) {
            found.partnerFails = true;
            found.relation = fmt::format("the shot '{}', which it has to {}, has errors: {}", name, word,
                                         firstError(partner->diagnostics));
            return;
        }
        Result<image::Image> seen =
            ignoresSomething(shot) ? withoutIgnored(shot, *partner->picture, got) : Result<image::Image>();
        const image::Judgement judged =
            image::judge(*partner->picture, seen ? *seen : got, shot.tolerance, everything);
        if (same)
            if (std::optional<Diagnostic> nothing = passedByAll(shot, *partner->picture, judged))
                found.relation = std::move(nothing->text);
        if (judged.same == same) return;
        found.partner = &*partner;
        found.judgement = judged;
        found.relation = same ? fmt::format("it does not match '{}': {}", name, judged.reason)
                              : fmt::format("it does not differ from '{}'", name);
    };
    relate(attempt.match, shot.match, true);
    relate(attempt.differ, shot.differ, false);
    return found;
}

Judged ShotJudge::passed(const Attempt& attempt, Findings found) const {
    constexpr double kLittle = 0.05;
    Judged judged{begin(attempt)};
    ShotResult& result = judged.result;
    result.verdict = Verdict::passed;
    if (result.compared < kLittle)
        result.diagnostics.push_back(diagnose("suite-W04",
                                              fmt::format("only {:.3g} % of the picture of '{}' is compared",
                                                          100 * result.compared, attempt.shot->name),
                                              attempt.shot->place));
    append(result.diagnostics, std::move(found.problems));
    result.judgement = std::move(found.judgement);
    result.exact = found.exact;
    result.changed = found.changed;
    if (!found.golden) return judged;
    result.goldenVariant = found.golden->variant;
    if (found.changed) {
        result.got = write(*attempt.shot, "got", *attempt.own.picture, result);
        result.acceptKey = key_;
        showGolden(*attempt.shot, found, *attempt.own.picture, result);
    } else if (!found.golden->pointer) {
        result.expected = found.golden->file;
    }
    if (options_.update && !options_.onlyMissing && goldens_.belongsIntoStore(*found.golden)) {
        const Diagnostics problems = goldens_.moveIntoStore(*attempt.shot, *found.golden);
        result.verdict = hasError(problems) ? Verdict::failed : Verdict::updated;
        result.reason = hasError(problems) ? firstError(problems)
                                           : "golden moved into the store; its file is a pointer now";
        append(result.diagnostics, problems);
    }
    if (options_.update && !options_.onlyMissing)
        judged.accepted = AcceptedHash{attempt.shot->name, found.golden->variant, found.golden->identity,
                                       *found.pixels, key_};
    return judged;
}

std::optional<Judged> ShotJudge::first(const Attempt& attempt) const {
    const Shot& shot = *attempt.shot;
    if (shot.expectedError) {
        Judged judged{begin(attempt)};
        if (attempt.own.picture)
            judged.result.reason = fmt::format("expected {}, but the scene rendered without errors",
                                               toPhrase(*shot.expectedError));
        else if (contains(attempt.own.diagnostics, *shot.expectedError))
            judged.result.verdict = Verdict::passed;
        else
            judged.result.reason =
                fmt::format("expected {}, found another error: {}", toPhrase(*shot.expectedError),
                            firstError(attempt.own.diagnostics));
        return judged;
    }
    if (!attempt.own.picture) {
        Judged judged{begin(attempt)};
        if (attempt.own.failsAsExpected)
            judged.result.verdict = Verdict::passed;
        else
            judged.result.reason = firstError(attempt.own.diagnostics);
        return judged;
    }
    if (!attempt.own.failedChecks.empty()) {
        Judged judged = refused(attempt, attempt.own.failedChecks);
        if (std::string command = checkCommand(shot); !command.empty())
            judged.result.reproduce = std::move(command);
        return judged;
    }
    if (const Diagnostics problems =
            wrongIgnored(shot, attempt.own.picture->width, attempt.own.picture->height);
        hasError(problems))
        return refused(attempt, problems);
    if (!isCompared(attempt)) {
        Judged judged{begin(attempt)};
        judged.result.diagnostics.push_back(diagnose(
            "suite-E21",
            fmt::format(
                "the picture of '{}' is compared with nothing: golden = false, no match, no differ, and "
                "no Expect in the scene",
                shot.name),
            shot.place));
        judged.result.reason = judged.result.diagnostics.back().text;
        judged.result.got = write(shot, "got", *attempt.own.picture, judged.result);
        return judged;
    }
    Findings found = look(attempt, false);
    if (found.goldenHolds && found.relation.empty()) return passed(attempt, std::move(found));
    if (found.awaited.empty() || options_.update) return std::nullopt;
    // A second drawing would not bring the picture.
    Judged judged{begin(attempt)};
    judged.result.got = write(shot, "got", *attempt.own.picture, judged.result);
    judged.result.acceptKey = key_;
    fail(attempt, found, judged.result);
    return judged;
}

Judged ShotJudge::refused(const Attempt& attempt, const Diagnostics& problems) const {
    Judged judged{begin(attempt)};
    judged.result.accept.clear();
    judged.result.reason = firstError(problems);
    append(judged.result.diagnostics, problems);
    judged.result.got = write(*attempt.shot, "got", *attempt.own.picture, judged.result);
    return judged;
}

fs::path ShotJudge::write(const Shot& shot, std::string_view what, const image::Image& picture,
                          ShotResult& result) const {
    const fs::path name =
        fs::path(suite_.name) /
        fmt::format("{}.{}{}", shot.name, what, picture.type == image::Component::f32 ? ".exr" : ".png");
    const fs::path file = options_.results / name;
    // A results folder may have been unpacked from somebody else's archive, with links in it.
    const int problem = base::prepareBeneath(options_.results, name);
    Diagnostics problems = problem == 0
                               ? image::writeImage(picture, file, image::writtenAs(image::NamedBy::program))
                               : Diagnostics{cannotWrite(file, problem)};
    const bool bad = hasError(problems);
    append(result.diagnostics, std::move(problems));
    return bad ? fs::path() : name;
}

void ShotJudge::showDifference(const Shot& shot, const image::Image& expected, const image::Image& got,
                               ShotResult& result) const {
    if (expected.width == got.width && expected.height == got.height)
        result.difference = write(shot, "difference", image::differenceHeatMap(expected, got), result);
}

/// Copies the pictures that a report shows, so that a results folder can be moved.
void ShotJudge::showGolden(const Shot& shot, const Findings& found, const image::Image& got,
                           ShotResult& result) const {
    if (!found.golden) return;
    result.goldenVariant = found.golden->variant;
    if (!found.picture) {
        if (!found.golden->isAbsent) result.expected = found.golden->file;
        return;
    }
    result.expected = write(shot, "expected", *found.picture, result);
    showDifference(shot, *found.picture, found.seen ? *found.seen : got, result);
}

bool ShotJudge::needsForce(const Findings& found, const image::Image& got) {
    const bool oldIsNoBetter = found.picture && !whyNoGolden(*found.picture).empty();
    return !oldIsNoBetter && !whyNoGolden(got).empty();
}

void ShotJudge::propose(const Shot& shot, const image::Image& expected, const image::Image& got,
                        ShotResult& result) const {
    constexpr double kOtherStructure = .1;
    result.steps = image::differenceSteps(expected, got);
    const image::NearestTolerance nearest =
        image::nearestTolerance(expected, got, shot.tolerance, result.judgement);
    if (nearest.tolerance)
        result.toPass = toleranceLine(*nearest.tolerance, shot.statesTolerance, shot.options.floatPixels);
    result.noTolerance = nearest.whyNone;
    const std::optional<double>& structure = result.judgement.structure;
    if (!result.noTolerance.empty() && structure && *structure > kOtherStructure)
        result.noTolerance += fmt::format(", and the structure differs by {:.2g} of 1", *structure);
}

void ShotJudge::fail(const Attempt& attempt, const Findings& found, ShotResult& result) const {
    const Shot& shot = *attempt.shot;
    const image::Image& got = *attempt.own.picture;
    result.verdict = Verdict::failed;
    result.judgement = found.judgement;
    result.awaits = found.awaited;
    result.awaitsStore = goldens_.pictures().isNamed();
    if (found.goldenHolds) {
        result.reason = found.relation;
        result.accept.clear();
        if (!found.partner) return;
        if (!found.judgement.same) {
            const auto seen = ignoresSomething(shot) ? withoutIgnored(shot, *found.partner->picture, got)
                                                     : Result<image::Image>();
            propose(shot, *found.partner->picture, seen ? *seen : got, result);
        }
        result.expected = write(shot, "partner", *found.partner->picture, result);
        showDifference(shot, *found.partner->picture, got, result);
        return;
    }
    showGolden(shot, found, got, result);
    if (found.picture && found.relation.empty() && !hasError(found.problems))
        propose(shot, *found.picture, found.seen ? *found.seen : got, result);
    result.accept += acceptOptions(shot, found, got);
    if (hasError(found.problems)) {
        result.reason =
            (found.awaited.empty() ? "" : "not exactly the golden, whose picture is needed now: ") +
            firstError(found.problems);
        append(result.diagnostics, found.problems);
    } else if (found.picture) {
        result.reason = found.judgement.reason;
    } else {
        result.verdict = Verdict::missing;
        result.reason = fmt::format("there is no golden '{}'", goldens_.file(shot, "").generic_string());
        if (options_.orphans) result.renamedFrom = options_.orphans->find(got);
        if (!result.renamedFrom.empty()) {
            result.reason += fmt::format(
                "; the picture equals '{}', which belongs to no shot: if it was "
                "renamed, --rename moves the golden",
                result.renamedFrom.generic_string());
            result.accept = renameCommand(suite_, shot) + acceptOptions_;
        } else if (!found.lost.empty())
            result.reason = fmt::format(
                "there is no golden '{}', though '{}' names it; restore it, or write golden = false if the "
                "Expect statements suffice",
                found.lost.generic_string(), goldens_.hashFile().generic_string());
        else if (!showNear(shot, got, result) && attempt.own.hasChecks)
            result.reason +=
                ", though the suite has goldens; write golden = false if the Expect statements suffice";
    }
}

bool ShotJudge::showNear(const Shot& shot, const image::Image& got, ShotResult& result) const {
    if (!options_.orphans) return false;
    const std::filesystem::path near = options_.orphans->findNear(got, shot.name);
    const Result<image::Image> golden =
        near.empty() ? Result<image::Image>() : image::readImage(near, {}, {.limits = image::kDrawnLimits});
    if (!golden) return false;
    result.nearTo = near;
    result.judgement = image::judge(*golden, got, shot.tolerance, true);
    result.expected = write(shot, "expected", *golden, result);
    if (result.judgement.comparison.sameSize) showDifference(shot, *golden, got, result);
    result.reason += fmt::format(
        "; '{}' belongs to no shot and may be that of this one before it was renamed and changed ({}): '{}' "
        "moves it, and the picture is compared with it",
        near.generic_string(), result.judgement.reason, renameCommand(suite_, shot));
    return true;
}

std::set<std::string> ShotJudge::otherFamilies(const Shot& shot, const Findings& found) const {
    std::set<std::string> known = goldens_.familiesOf(shot, found.picture);
    if (known.contains(gpu::familyOf(key_))) known.clear();
    return known;
}

std::string ShotJudge::acceptOptions(const Shot& shot, const Findings& found, const image::Image& got) const {
    const bool isForAll = !found.golden || found.golden->variant.empty();
    return fmt::format("{}{}{}", isForAll && !otherFamilies(shot, found).empty() ? " --variant" : "",
                       needsForce(found, got) ? " --force" : "",
                       hasError(found.problems) ? " --replace-unreadable" : "");
}

std::string ShotJudge::whyKept(const Shot& shot, const Findings& found, const image::Image& got) const {
    if (hasError(found.problems) && !options_.replaceUnreadable)
        return firstError(found.problems) + "; --update keeps a golden that cannot be read";
    if (needsForce(found, got) && !options_.force)
        return fmt::format("not accepted as the golden: {}; --force accepts it", whyNoGolden(got));
    const bool isForAll = !options_.variant && (!found.golden || found.golden->variant.empty());
    if (isForAll && !options_.anyDriver && !(options_.also && found.golden)) {
        const std::string family = gpu::familyOf(key_);
        if (const auto known = otherFamilies(shot, found); !known.empty())
            return fmt::format(
                "not accepted as the golden for all drivers: {} drawn by {}, and this driver is {}; "
                "--variant "
                "makes a golden for {} beside it, --any-driver {}",
                found.picture ? "it was" : "the goldens of the suite were", fmt::join(known, " and "), family,
                family, found.picture ? "replaces it" : "makes it all the same");
    }
    if (options_.prune && options_.orphans && !found.golden && !options_.orphans->isEmpty() &&
        options_.orphans->find(got).empty())
        return fmt::format(
            "not accepted as the golden: {} of no shot {} left, which --prune would remove, and none equals "
            "this picture; if the shot was renamed, its picture has changed: compare them, then use --update "
            "and --prune one after the other",
            base::counted(options_.orphans->files().size(), "golden"),
            options_.orphans->files().size() == 1 ? "is" : "are");
    return {};
}

void ShotJudge::update(const Attempt& attempt, const Findings& found, Judged& judged) const {
    const Shot& shot = *attempt.shot;
    const image::Image& got = *attempt.own.picture;
    ShotResult& result = judged.result;
    showGolden(shot, found, got, result);
    result.judgement = found.judgement;
    result.awaits = found.awaited;
    result.awaitsStore = goldens_.pictures().isNamed();
    result.accept += acceptOptions(shot, found, got);
    if (std::string why = whyKept(shot, found, got); !why.empty()) {
        result.verdict = Verdict::refused;
        result.reason = std::move(why);
        append(result.diagnostics, found.problems);
        return;
    }
    const bool isFurther = options_.also && found.golden;
    const std::string variant = isFurther          ? goldens_.freeVariant(shot)
                                : options_.variant ? family_
                                : found.golden     ? found.golden->variant
                                                   : "";
    if (isFurther && variant.empty()) {
        result.verdict = Verdict::failed;
        result.diagnostics.push_back(
            diagnose("suite-E31",
                     fmt::format("'{}' has {} further accepted pictures; remove one before another is added",
                                 shot.name, kMostFurther),
                     shot.place));
        result.reason = result.diagnostics.back().text;
        return;
    }
    Result<Golden> golden = goldens_.replace(shot, variant, got);
    if (!golden) {
        result.verdict = Verdict::failed;
        result.reason = firstError(golden.diagnostics);
        append(result.diagnostics, std::move(golden.diagnostics));
        return;
    }
    result.verdict = Verdict::updated;
    result.goldenVariant = variant;
    if (options_.orphans && !found.golden) result.renamedFrom = options_.orphans->find(got);
    const bool isBeside = isFurther || (found.golden && variant != found.golden->variant);
    const bool isUnreadable = hasError(found.problems);
    result.reason = isFurther       ? "golden added: " + found.judgement.reason
                    : isBeside      ? fmt::format("golden for {} added: {}", variant, found.judgement.reason)
                    : isUnreadable  ? "golden replaced: the old one could not be read"
                    : found.picture ? "golden replaced: " + found.judgement.reason
                                    : fmt::format("golden made: {} x {} pixels", got.width, got.height);
    if (!result.renamedFrom.empty())
        result.reason +=
            fmt::format(", equal to '{}', which belongs to no shot", result.renamedFrom.generic_string());
    judged.accepted = AcceptedHash{shot.name, variant, golden->identity, hashOf(got), key_};
}

Judged ShotJudge::second(const Attempt& attempt, const Attempt& again) const {
    const Shot& shot = *attempt.shot;
    const image::Image& got = *attempt.own.picture;
    Judged judged{begin(attempt)};
    ShotResult& result = judged.result;
    result.milliseconds += again.own.milliseconds;
    if (!again.own.picture || !drawingsAgree(shot, got, *again.own.picture)) {
        result.verdict = Verdict::unstable;
        result.accept.clear();  // no picture of it becomes a golden
        result.got = write(shot, "got", got, result);
        if (!again.own.picture) {
            result.reason = "the second rendering failed: " + firstError(again.own.diagnostics);
            return judged;
        }
        result.judgement = image::judge(got, *again.own.picture, shot.tolerance, true);
        const image::Comparison& figures = result.judgement.comparison;
        result.reason = figures.sameSize
                            ? fmt::format("two renderings differ: {} pixels, by up to {:.3g}/255",
                                          figures.differingPixels, figures.largest * 255)
                            : "two renderings differ in size";
        result.expected = write(shot, "again", *again.own.picture, result);
        showDifference(shot, *again.own.picture, got, result);
        return judged;
    }
    const Findings found = look(attempt, true);
    if (found.goldenHolds && found.relation.empty()) return passed(attempt, found);
    result.got = write(shot, "got", got, result);
    if (!found.goldenHolds) result.acceptKey = key_;
    const bool isMissing = !found.golden && !hasError(found.problems);
    if (options_.update && !found.goldenHolds && (isMissing || !options_.onlyMissing))
        update(attempt, found, judged);
    else
        fail(attempt, found, result);
    // A golden can be new while the pair of the shot is still wrong.
    if (!found.relation.empty() && !found.goldenHolds && !isFailure(result.verdict)) {
        result.verdict = Verdict::failed;
        result.reason += "; " + found.relation;
    }
    return judged;
}

}  // namespace glibra::suite
