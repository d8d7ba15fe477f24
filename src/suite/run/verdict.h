#pragma once
// From a rendering to a verdict: what was accepted before, the golden, the tolerance, a second rendering, and
// what --update does instead. No GL here.

#include <optional>

#include "image/image.h"
#include "suite/golden/golden_store.h"
#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

/// One attempt at a shot: its picture, or what prevented it.
struct Rendering {
    std::optional<image::Image> picture;
    Diagnostics diagnostics;
    double milliseconds = 0;  ///< load, draw and read back
};

/// A shot with all that its verdict needs.
struct Attempt {
    const Shot* shot = nullptr;
    Rendering own;
    std::optional<Rendering> match, differ;  ///< of the shots that it has to match or to differ from
};

struct JudgeOptions {
    bool update = false;              ///< what differs becomes the golden
    bool force = false;               ///< ... even a picture of one colour, or with NaN
    bool variant = false;             ///< ... for this family of drivers alone
    std::filesystem::path results{};  ///< folder for what a report shows
};

/// A verdict, and the pixels that --update accepted.
struct Judged {
    ShotResult result;
    std::optional<AcceptedHash> accepted;
};

class ShotJudge {
  public:
    ShotJudge(const Suite& suite, const GoldenStore& goldens, std::string family, std::string key,
              JudgeOptions options);

    /// The verdict, if one rendering is enough for it; nothing if the shot has to be rendered once more.
    std::optional<Judged> first(const Attempt& attempt) const;
    /// The verdict after a second rendering in a fresh load. Writes the pictures that explain it into the
    /// results folder, or the new golden.
    Judged second(const Attempt& attempt, const Attempt& again) const;

    /// The verdict on a shot whose process ended or was ended.
    static ShotResult broken(const Suite& suite, const Shot& shot, Verdict verdict, std::string reason);

  private:
    struct Findings;
    [[nodiscard]] ShotResult begin(const Attempt& attempt) const;
    [[nodiscard]] Findings look(const Attempt& attempt, bool everything) const;
    [[nodiscard]] Judged passed(const Attempt& attempt, Findings found) const;
    void fail(const Attempt& attempt, const Findings& found, ShotResult& result) const;
    void update(const Attempt& attempt, const Findings& found, Judged& judged) const;
    /// Writes into the results folder; the path is relative to it, empty if it could not be written.
    std::filesystem::path write(const Shot& shot, std::string_view what, const image::Image& picture,
                                ShotResult& result) const;
    void showDifference(const Shot& shot, const image::Image& expected, const image::Image& got,
                        ShotResult& result) const;
    void showGolden(const Shot& shot, const Findings& found, const image::Image& got,
                    ShotResult& result) const;

    const Suite& suite_;
    const GoldenStore& goldens_;
    std::string family_, key_;
    JudgeOptions options_;
};

/// Why a picture should not become a golden: one colour, NaN, nothing but transparency. Empty if it may.
std::string whyNoGolden(const image::Image& picture);
/// True if one of the errors is the expected one.
bool contains(const Diagnostics& diagnostics, const ExpectedError& expected);
/// "an error glsl-E01 with 'undeclared' in line 7".
std::string toPhrase(const ExpectedError& expected);

}  // namespace glibra::suite
