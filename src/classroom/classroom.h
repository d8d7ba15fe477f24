#pragma once
// A class as a value: what was handed in, its pictures, and what was found out about them. Pages and tables
// are made from it.

#include <glibra/diagnostic.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "classroom/submissions.h"
#include "classroom/tokens.h"
#include "suite/file/sweep.h"
#include "suite/results/results.h"

namespace glibra::classroom {

using suite::Moment;

/// How a picture differs from the reference's at the same moment; 0 is no difference.
struct Score {
    double flip = 0;       ///< mean FLIP, 0..1 (image/compare/flip.h)
    double structure = 0;  ///< 0..1 (image/compare/compare.h)
    /// 0, nothing in common, to 1 (likeness.h): colours, model and camera are free. Where the reference's
    /// pictures differ from one another in a small part, it depends on how alike that is (effect.h).
    double likeness = 0;
    std::optional<double> effect{};  ///< how alike that part changes; nothing: the picture counts as a whole
    double kept = 1;                 ///< the part of the likeness of the whole picture that this leaves
    std::string unsolved{};  ///< why it is not the reference's picture (suite::whyUnsolved); empty: it is
};

/// How the pictures of one entry change with a value.
struct Change {
    double mean = 0, strength = 0;  ///< classroom::Reaction (likeness.h)
    bool isOtherwise = false;       ///< in another way than the reference's (effect.h)
};

/// Moments that differ in nothing but one value.
struct Slider {
    std::string name;  ///< of the uniform, or "time"
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

/// The picture of one moment.
struct Picture {
    suite::Verdict verdict = suite::Verdict::skipped;  ///< passed: it was drawn
    std::string reason;                                ///< why it was not drawn
    std::string file;                                  ///< relative to the page; empty if there is none
    int width = 0, height = 0;
    double milliseconds = 0;
    std::optional<Score> score;  ///< of the reference: nothing
    bool showsNothing = false;   ///< it has one colour
    bool isIncomplete = false;   ///< there is a picture, of a scene with errors (RenderOptions::incomplete)
    std::string small{};         ///< smallPicture() of it, for the page of a student; may be empty
};

/// What one check of the rubric, or the teacher, gave to a submission.
struct Mark {
    std::string check;
    double points = 0, most = 0;
    bool isBonus = false;
    std::string reason;                      ///< one phrase
    std::optional<std::size_t> moment = {};  ///< whose picture shows it
    bool isOwn = false;                      ///< the teacher's own points
    bool isOpen = false;                     ///< by hand, and not yet typed
};

/// A shader program as the scene composes it.
struct UsedProgram {
    std::string name;
    std::vector<std::string> stages;        ///< "vertex", "fragment"
    std::vector<DeclaredUniform> uniforms;  ///< that its shaders declare, sorted
    std::vector<std::string> idle{};        ///< those of the stages that no picture is drawn with
};

/// A uniform or variable of a scene that has a range.
struct RangedUniform {
    std::string name;
    double least = 0, largest = 0;
};

/// A file with a picture that a scene reads, of its own folder.
struct ReadPicture {
    std::string name, digest;
    bool isLikeReference = false;  ///< it looks like a picture that the reference draws
};

/// What is found out about a submission without drawing it (review.h).
struct Findings {
    std::vector<UsedProgram> programs;
    std::vector<SourceFile> files;  ///< what runs of the shaders, of a submission those of its own folder
    /// What was left out of the search for similar code, and why: one phrase each.
    std::vector<std::string> notCompared;
    /// For each slider of the class how its own pictures change; nothing if they were not drawn.
    std::vector<std::optional<Change>> reactions{};
    std::vector<RangedUniform> ranges{};
    std::vector<std::string> calls{};  ///< names of the functions that its pictures call, sorted
    std::vector<ReadPicture> readPictures{};
    std::string digest{};  ///< of the files that were handed in; empty if they were not read
};

/// Everything about one submission, or about the reference.
struct Entry : Findings {
    Submission submission;
    std::vector<Picture> pictures;  ///< one per moment; empty without a scene
    Diagnostics diagnostics;        ///< each once
    std::string reproduce;          ///< the command that draws its first picture
    bool drawsNothing = false;      ///< no picture shows anything, though the reference does
    std::vector<Mark> marks{};      ///< one per check of the rubric; empty without one
    double lateFactor = 1;          ///< what the late rule leaves of the points
    std::string lateReason{};
    std::string comment{};  ///< the teacher's own
};

struct Classroom {
    std::string folder;  ///< of the submissions, as the user named it
    Entry reference;     ///< without a scene if the class has none
    std::vector<Entry> entries;
    std::vector<Moment> moments;
    std::vector<Slider> sliders{};         ///< that the moments vary
    std::vector<std::string> leftOut;      ///< files that are no submissions
    std::vector<Entry> earlier{};          ///< of earlier folders: their code alone
    std::vector<std::string> absent;       ///< students of the roster who handed nothing in
    std::vector<std::string> strangers{};  ///< who handed something in and is not in the roster
    std::vector<std::string> unplaced{};   ///< typed points that belong to nobody here
    /// Of each entry, and of each earlier one after them, without given code.
    std::vector<std::vector<Fingerprint>> fingerprints;
    std::size_t common = 0;              ///< what more submissions than this have does not count as similar
    std::size_t commonFingerprints = 0;  ///< how many were left out for that
    /// The most similar first, of two entries, or of an entry and an earlier one (comparedEntry).
    std::vector<SimilarPair> pairs;
    bool isAnonymous = false;  ///< names are numbers (class_page.h)
    std::string driver, machine, command, began;
    double seconds = 0;
};

/// True if there is a reference.
bool hasReference(const Classroom& classroom);
/// The points of a submission, after the late rule; nothing without a rubric.
std::optional<double> pointsOf(const Entry& entry);
/// The number of checks without bonus that nobody has marked by hand yet.
std::size_t openCount(const Entry& entry);
/// The most points without bonus; 0 without a rubric.
double mostPoints(const Classroom& classroom);
/// The number of moments that were drawn.
std::size_t drawnCount(const Entry& entry);
/// True if all pictures were drawn.
bool isDrawn(const Entry& entry);
/// "drawn", "nothing", "failed", "crashed", "timed-out", "no-scene": the class of an entry, by its worst
/// picture. "nothing": all pictures were drawn, and none shows anything.
std::string stateOf(const Entry& entry);
/// Why not all pictures were drawn; one sentence, or empty.
std::string reasonOf(const Entry& entry);
std::size_t countOf(const Entry& entry, Severity severity);

/// Figures over the pictures that have a score; nothing if none has.
struct Scores {
    double flip = 0, worstFlip = 0;            ///< mean and largest
    double structure = 0, worstStructure = 0;  ///< likewise
    double likeness = 0;                       ///< mean
};
std::optional<Scores> scoresOf(const Entry& entry);

/// Whether a submission reacts to a slider, beside the reference's reaction.
enum class Reacts { unknown, no, weakly, yes };
/// yes: its strength is at least a quarter of the reference's, and it does not change otherwise; weakly: at
/// least a twentieth; unknown: one of the two was not measured, or the reference itself does not react.
/// Without a reference every visible change is a yes.
Reacts reactsOf(const Classroom& classroom, const Entry& entry, std::size_t slider);
const char* name(Reacts reacts);
/// A mean that nobody sees.
inline constexpr double kLeastReaction = 5e-4;

/// What a number in a pair stands for: the entries come first, then the earlier ones.
const Entry& comparedEntry(const Classroom& classroom, std::size_t index);

/// The other entry of the listed pairs that has the largest share of this one's code, and that share (0..1).
struct Nearest {
    std::size_t entry = 0;  ///< as comparedEntry counts
    double share = 0;
};
std::optional<Nearest> nearestOf(const Classroom& classroom, std::size_t entry);

/// The pictures that a submission reads, the reference does not, and that look like one of the reference's.
std::vector<std::string> lookalikesOf(const Classroom& classroom, const Entry& entry);

/// "200 submissions: 30 drawn, 8 failed ..."
std::string summary(const Classroom& classroom);

// Compares the shader code of all submissions of a class with each other.

/// Sets the fingerprints and pairs of a class, and names in each entry what was not compared. Code of the
/// reference and of `given` is left out, and so is what more than `common` submissions have (MOSS's -m): it
/// comes from a lecture or a book. 0: usualCommon().
void compareSources(Classroom& classroom, const std::vector<SourceFile>& given, std::size_t common);

/// A third of the class, but at least 4 and at most 10, as for MOSS.
std::size_t usualCommon(std::size_t submissions);

}  // namespace glibra::classroom
