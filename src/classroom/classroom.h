#pragma once
// A class as a value: what was handed in, its pictures, and what was found out about them. Pages and tables
// are made from it.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "classroom/similarity.h"
#include "classroom/submissions.h"
#include "classroom/tokens.h"
#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::classroom {

/// What all scenes are drawn with: a time, values of uniforms, and the other options of a picture.
struct Moment {
    std::string label;  ///< "uTol=0.1", "time=2.5"; empty if it is the only one
    suite::Shot shot;   ///< without a name; its script is the reference
};

/// How a picture differs from the reference's at the same moment; 0 is no difference.
struct Score {
    double flip = 0;       ///< mean FLIP, 0..1 (image/compare/flip.h)
    double structure = 0;  ///< 0..1 (image/compare/structure.h)
};

/// The picture of one moment.
struct Picture {
    suite::Verdict verdict = suite::Verdict::skipped;  ///< passed: it was drawn
    std::string reason;                                ///< why it was not drawn
    std::string file;                                  ///< relative to the page; empty if there is none
    int width = 0, height = 0;
    double milliseconds = 0;
    std::optional<Score> score;  ///< of the reference: nothing
};

/// A shader program as the scene composes it.
struct UsedProgram {
    std::string name;
    std::vector<std::string> stages;        ///< "vertex", "fragment"
    std::vector<DeclaredUniform> uniforms;  ///< that its shaders declare, sorted
};

/// Everything about one submission, or about the reference.
struct Entry {
    Submission submission;
    std::vector<Picture> pictures;  ///< one per moment; empty without a scene
    Diagnostics diagnostics;        ///< each once
    std::vector<UsedProgram> programs;
    std::vector<SourceFile> files;  ///< shaders of its own folder
    /// What was left out of the search for similar code, and why: one phrase each.
    std::vector<std::string> notCompared;
    std::string reproduce;  ///< the command that draws its first picture
};

struct Classroom {
    std::string folder;  ///< of the submissions, as the user named it
    Entry reference;
    std::vector<Entry> entries;
    std::vector<Moment> moments;
    std::vector<std::string> leftOut;                    ///< files that are no submissions
    std::vector<std::vector<Fingerprint>> fingerprints;  ///< of each entry, without given code
    std::vector<SimilarPair> pairs;                      ///< of entries, the most similar first
    std::string driver, machine, command, began;
    double seconds = 0;
};

/// The number of moments that were drawn.
std::size_t drawnCount(const Entry& entry);
/// True if all pictures were drawn.
bool isDrawn(const Entry& entry);
/// "drawn", "failed", "crashed", "timed-out", "no-scene": the class of an entry, by its worst picture.
std::string stateOf(const Entry& entry);
/// Why not all pictures were drawn; one sentence, or empty.
std::string reasonOf(const Entry& entry);
std::size_t countOf(const Entry& entry, Severity severity);

/// Figures over the pictures that have a score; nothing if none has.
struct Scores {
    double flip = 0, worstFlip = 0;            ///< mean and largest
    double structure = 0, worstStructure = 0;  ///< likewise
};
std::optional<Scores> scoresOf(const Entry& entry);

/// The other entry of the listed pairs that has the largest share of this one's code, and that share (0..1).
struct Nearest {
    std::size_t entry = 0;
    double share = 0;
};
std::optional<Nearest> nearestOf(const Classroom& classroom, std::size_t entry);

/// "200 submissions: 30 drawn, 8 failed ..."
std::string summary(const Classroom& classroom);

}  // namespace glibra::classroom
