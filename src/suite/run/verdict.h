#pragma once
// Judges renderings: by hashes accepted before, by the golden and the tolerance, by a second rendering; and
// replaces goldens for --update. No GL here.

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "image/image.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/orphans.h"
#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

/// One rendering of a shot: its picture, or the errors.
struct Rendering {
    std::optional<image::Image> picture;
    Diagnostics diagnostics;
    /// The scene has Expect statements: it needs no golden in a suite that has none.
    bool hasChecks = false;
    Diagnostics failedChecks;      ///< those that do not hold
    bool failsAsExpected = false;  ///< no picture, and Expect error names all errors
    double milliseconds = 0;       ///< load, draw and read back
};

/// A shot with everything that its verdict needs.
struct Attempt {
    const Shot* shot = nullptr;
    Rendering own;
    std::optional<Rendering> match, differ;  ///< the shots that it must match or differ from
};

struct JudgeOptions {
    bool update = false;              ///< what differs becomes the golden
    bool onlyMissing = false;         ///< ... only where there is none
    bool force = false;               ///< ... even a picture of one colour, or with NaN
    bool variant = false;             ///< ... for this family of drivers alone
    bool also = false;                ///< ... beside the golden that there is
    bool replaceUnreadable = false;   ///< ... even of a golden that cannot be read
    bool anyDriver = false;           ///< ... even of a golden for all drivers that another family drew
    bool prune = false;               ///< goldens of no shot are removed afterwards
    std::filesystem::path results{};  ///< folder for what a report shows
    std::shared_ptr<const Orphans> orphans{};  ///< the goldens of no shot of the suite, or null
};

/// A verdict, and the pixels that --update accepted.
struct Judged {
    ShotResult result;
    std::optional<AcceptedHash> accepted{};
};

class ShotJudge {
  public:
    ShotJudge(const Suite& suite, const GoldenStore& goldens, std::string family, std::string key,
              JudgeOptions options);

    /// The verdict, or nothing if the shot has to be rendered again.
    std::optional<Judged> first(const Attempt& attempt) const;
    /// The verdict after a second rendering from a new load. Writes the pictures that explain it to the
    /// results folder, or the new golden.
    Judged second(const Attempt& attempt, const Attempt& again) const;

    /// The verdict on a shot that has no picture to judge.
    static ShotResult broken(const Suite& suite, const Shot& shot, Verdict verdict, std::string reason);

  private:
    struct Findings;
    [[nodiscard]] ShotResult begin(const Attempt& attempt) const;
    /// False for a picture that nothing is compared with, neither here nor as the partner of another shot.
    [[nodiscard]] bool isCompared(const Attempt& attempt) const;
    [[nodiscard]] Findings look(const Attempt& attempt, bool everything) const;
    /// The verdict on a picture with errors that no golden mends: in the scene's checks, `ignore` or `mask`.
    [[nodiscard]] Judged refused(const Attempt& attempt, const Diagnostics& problems) const;
    /// Says in `found` whether the picture equals `found.golden`.
    void compare(const Attempt& attempt, bool everything, Findings& found) const;
    [[nodiscard]] Judged passed(const Attempt& attempt, Findings found) const;
    /// True for a picture that --update refuses without --force.
    static bool needsForce(const Findings& found, const image::Image& got);
    /// The families of drivers that drew the golden for all drivers, or those of the suite if there is none;
    /// empty if this family is among them, or nothing is known.
    [[nodiscard]] std::set<std::string> otherFamilies(const Shot& shot, const Findings& found) const;
    /// Why --update does not write the golden, and which option lets it; empty if it does.
    [[nodiscard]] std::string whyKept(const Shot& shot, const Findings& found, const image::Image& got) const;
    /// The options of acceptCommand() that this picture needs besides.
    [[nodiscard]] std::string acceptOptions(const Shot& shot, const Findings& found,
                                            const image::Image& got) const;
    /// Says which tolerance would pass the picture that has failed.
    void propose(const Shot& shot, const image::Image& expected, const image::Image& got,
                 ShotResult& result) const;
    void fail(const Attempt& attempt, const Findings& found, ShotResult& result) const;
    void update(const Attempt& attempt, const Findings& found, Judged& judged) const;
    /// Writes a picture into the results folder. Returns its path relative to that folder, or an empty path
    /// if it could not be written.
    std::filesystem::path write(const Shot& shot, std::string_view what, const image::Image& picture,
                                ShotResult& result) const;
    void showDifference(const Shot& shot, const image::Image& expected, const image::Image& got,
                        ShotResult& result) const;
    /// Names and shows a golden of no shot that may be this shot's former one. False if there is none.
    bool showNear(const Shot& shot, const image::Image& got, ShotResult& result) const;
    void showGolden(const Shot& shot, const Findings& found, const image::Image& got,
                    ShotResult& result) const;

    const Suite& suite_;
    const GoldenStore& goldens_;
    std::set<std::string> partners_;  ///< the shots that others have to match or to differ from
    std::string family_, key_;
    JudgeOptions options_;
    bool suiteHasGoldens_ = false;
    std::string acceptOptions_;  ///< that acceptCommand() needs besides
};

/// Returns why a picture should not become a golden (one colour, NaN, all transparent), or nothing if it may.
std::string whyNoGolden(const image::Image& picture);
/// True if one of the errors is the expected one.
bool contains(const Diagnostics& diagnostics, const ExpectedError& expected);
/// "an error glsl-E01 with 'undeclared' in line 7".
std::string toPhrase(const ExpectedError& expected);

}  // namespace glibra::suite
