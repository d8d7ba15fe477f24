#pragma once
// Shader sources as tokens, and the passages that they share.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace glibra::classroom {

// Shader sources as sequences of tokens that stay the same when somebody renames, reformats or comments them.

/// One token: what it is, and its line, counted from 1.
struct SourceToken {
    std::uint32_t code = 0;
    std::int32_t line = 1;
    std::uint32_t file = 0;  ///< that has the line: 0 is the SourceFile itself, others follow
    friend auto operator<=>(const SourceToken&, const SourceToken&) = default;
};

/// Tokens of a file that stand together.
struct SourceFile {
    std::string path;  ///< as messages name it
    std::vector<SourceToken> tokens;
    std::string place{};                ///< of the file, without links; empty if it is not known
    std::vector<std::string> others{};  ///< included in the middle, or the places of macros
    /// The file that has the line of a token.
    [[nodiscard]] const std::string& pathOf(const SourceToken& token) const {
        return token.file > 0 && token.file <= others.size() ? others[token.file - 1] : path;
    }
};

/// A file is read up to this number of tokens, and so are all files of a submission together. It is far more
/// than anybody writes, so that padding hides nothing behind it without being named.
inline constexpr std::size_t kMostTokens = 1'000'000;

/// The tokens of a GLSL text as it is written, at most `most`. Comments, blanks, preprocessor lines, and
/// global declarations of uniforms, inputs and outputs are left out, because the task gives them; the texts
/// of macros come last. All numbers have one code, and so have all names except those of types, keywords and
/// functions that the text does not define itself, which are the built-in ones. The code is in normal form
/// (normal_form.h), so the lines of neighbouring tokens may go back and forth.
std::vector<SourceToken> comparableTokens(std::string_view glsl, std::size_t most = kMostTokens);

/// A uniform variable, or block, as a text declares it.
struct DeclaredUniform {
    std::string name, type;  ///< of a block: its name, and "block"
    friend bool operator==(const DeclaredUniform&, const DeclaredUniform&) = default;
    friend auto operator<=>(const DeclaredUniform&, const DeclaredUniform&) = default;
};

/// The uniforms that a GLSL text declares, in its order; macros are not expanded.
std::vector<DeclaredUniform> declaredUniforms(std::string_view glsl);

/// The names of its #include lines.
std::vector<std::string> includedNames(std::string_view glsl);

// Which submissions share passages of shader code, by winnowing: Schleimer, Wilkerson, Aiken: "Winnowing:
// Local Algorithms for Document Fingerprinting", SIGMOD 2003, the algorithm of MOSS. Every passage of
// kLongestUnseen + 1 tokens that two submissions share is found, and none shorter than kGram is.

/// A fingerprint is the hash of kGram tokens in a row (k in the paper). Among kWindow hashes in a row the
/// least is kept (w).
inline constexpr std::size_t kGram = 16, kWindow = 10;
inline constexpr std::size_t kLongestUnseen = kGram + kWindow - 2;

/// A place in the files of a submission.
struct TokenPlace {
    std::uint32_t file = 0, token = 0;
    friend bool operator==(const TokenPlace&, const TokenPlace&) = default;
};

/// A hash of kGram tokens that was kept, and where they begin.
struct Fingerprint {
    std::uint64_t hash = 0;
    TokenPlace place;
};

/// The hash of every kGram tokens in a row, in their order; empty if there are fewer tokens.
std::vector<std::uint64_t> gramHashes(std::span<const SourceToken> tokens);

/// The hashes of code that was given to all.
using GivenCode = std::unordered_set<std::uint64_t>;
void addGivenCode(GivenCode& given, std::span<const SourceToken> tokens);

/// Of each kWindow hashes in a row the least, the last of several equal ones; those in `given` are left out.
std::vector<Fingerprint> fingerprintsOf(std::span<const SourceFile> files, const GivenCode& given);

/// Two submissions that share fingerprints.
struct SimilarPair {
    std::size_t a = 0, b = 0;  ///< a < b
    std::size_t shared = 0;    ///< distinct fingerprints that both have
    double ofA = 0, ofB = 0;   ///< the share of the distinct fingerprints of each, 0..1
    [[nodiscard]] double figure() const { return ofA > ofB ? ofA : ofB; }
};

/// Pairs that share at least this many fingerprints (about 45 tokens), and this part of one of them.
inline constexpr std::size_t kLeastShared = 5;
inline constexpr double kLeastFigure = 0.25;

/// All pairs that reach both limits, the most similar first. `files` names the files of each submission, as
/// TokenPlace::file counts them: a fingerprint that two submissions have only in one and the same file is not
/// shared by them. Without it no file belongs to two submissions. Takes time in proportion to the number of
/// pairs that share a fingerprint, counted for each fingerprint.
std::vector<SimilarPair> similarPairs(std::span<const std::vector<Fingerprint>> submissions,
                                      std::span<const std::vector<std::string>> files = {});

/// A passage that two submissions share.
struct SharedPassage {
    TokenPlace a, b;         ///< where it begins
    std::size_t tokens = 0;  ///< its length, at least kGram
};

/// The passages that two submissions share, the longest first, at most `most`. They begin at equal
/// fingerprints and are extended as far as the tokens are equal; none overlaps another. Given code is shown
/// only where it is inside of a passage. Files in one place are one file, which is not compared with itself.
std::vector<SharedPassage> sharedPassages(std::span<const SourceFile> filesA, std::span<const Fingerprint> a,
                                          std::span<const SourceFile> filesB, std::span<const Fingerprint> b,
                                          std::size_t most);

}  // namespace glibra::classroom
