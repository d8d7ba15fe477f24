#include "classroom/tokens.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "base/hash.h"
#include "classroom/normal_form.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

using glsl::Token;
using glsl::TokenKind;

/// The significant tokens of a text, and its preprocessor lines.
class Text {
  public:
    explicit Text(std::string_view glsl) : text_(glsl::normalizeLines(glsl)) {
        tokens_ = glsl::lex(text_, joined_);
        std::vector<const Token*> line;
        for (const Token& each : tokens_) {
            if (each.kind == TokenKind::newline) {
                addLine(line);
                line.clear();
            } else if (glsl::isSignificant(each.kind)) {
                line.push_back(&each);
            }
        }
        addLine(line);
    }

    [[nodiscard]] std::span<const Token* const> code() const { return code_; }
    /// The texts of all macros, one after another.
    [[nodiscard]] std::span<const Token* const> macros() const { return macros_; }
    [[nodiscard]] std::span<const std::vector<const Token*>> directives() const { return directives_; }

  private:
    void addLine(const std::vector<const Token*>& line) {
        if (line.empty() || line.front()->text != "#") {
            code_.insert(code_.end(), line.begin(), line.end());
            return;
        }
        directives_.push_back(line);
        // What a macro computes is code like any other.
        if (line.size() > 1 && line[1]->text == "define")
            macros_.insert(macros_.end(), line.begin(), line.end());
    }

    std::string text_;
    std::deque<std::string> joined_;
    std::vector<Token> tokens_;
    std::vector<const Token*> code_, macros_;
    std::vector<std::vector<const Token*>> directives_;
};

std::vector<CodeToken> codeOf(std::span<const Token* const> tokens) {
    std::vector<CodeToken> code;
    for (const Token* each : tokens)
        code.push_back(
            {each->text, 0, {each->line, 0}, each->kind == TokenKind::word, each->kind == TokenKind::number});
    dropPrecisions(code);
    return code;
}

constexpr std::uint64_t kSeveral = std::numeric_limits<std::uint64_t>::max();

/// A hash that a submission has, and the file in which it has it.
struct Owned {
    std::uint64_t hash = 0;
    std::uint32_t submission = 0;
    std::uint64_t file = kSeveral;  ///< kSeveral: it is in several files
};

/// Numbers for files; two submissions have the same number for a file that both use.
class FileNumbers {
  public:
    explicit FileNumbers(std::span<const std::vector<std::string>> files) : files_(files) {}

    std::uint64_t of(std::size_t submission, std::uint32_t file) {
        if (submission >= files_.size() || file >= files_[submission].size())
            return std::uint64_t{1} << 63U | submission << 32U | file;
        return numbers_.try_emplace(files_[submission][file], numbers_.size()).first->second;
    }

  private:
    std::span<const std::vector<std::string>> files_;
    std::unordered_map<std::string, std::uint64_t> numbers_;
};

/// The distinct hashes of a submission.
std::vector<Owned> ownedHashes(const std::vector<Fingerprint>& fingerprints, std::size_t submission,
                               FileNumbers& numbers) {
    std::vector<Owned> all;
    all.reserve(fingerprints.size());
    for (const Fingerprint& each : fingerprints)
        all.push_back(
            {each.hash, static_cast<std::uint32_t>(submission), numbers.of(submission, each.place.file)});
    std::ranges::sort(all, {}, &Owned::hash);
    std::vector<Owned> distinct;
    for (const Owned& each : all) {
        if (distinct.empty() || distinct.back().hash != each.hash)
            distinct.push_back(each);
        else if (distinct.back().file != each.file)
            distinct.back().file = kSeveral;
    }
    return distinct;
}

/// The tokens that passages already have.
class Covered {
  public:
    explicit Covered(std::span<const SourceFile> files) {
        for (const SourceFile& each : files) tokens_.emplace_back(each.tokens.size(), false);
    }
    [[nodiscard]] bool at(const TokenPlace& place) const { return tokens_[place.file][place.token]; }
    void cover(const TokenPlace& from, std::size_t count) {
        std::fill_n(tokens_[from.file].begin() + static_cast<std::ptrdiff_t>(from.token), count, true);
    }

  private:
    std::vector<std::vector<bool>> tokens_;
};

}  // namespace

/// FNV-1a, by Fowler, Noll and Vo.
std::uint32_t codeOfText(std::string_view text) {
    std::uint32_t code = 2166136261U;
    for (const char each : text) code = (code ^ static_cast<unsigned char>(each)) * 16777619U;
    return code;
}

void dropPrecisions(std::vector<CodeToken>& code) {
    constexpr std::array<std::string_view, 4> kWords{"highp", "mediump", "lowp", "precise"};
    bool isStatement = false;  // "precision highp float;"
    std::erase_if(code, [&](const CodeToken& each) {
        const bool begins = each.text == "precision", isWithin = isStatement || begins;
        isStatement = isWithin && each.text != ";";
        return isWithin || std::ranges::find(kWords, each.text) != kWords.end();
    });
}

std::vector<CodeToken> comparedCode(std::span<const CodeToken> tokens, const OwnFunctions& own) {
    std::vector<CodeToken> kept;
    const CodeTree tree(tokens);
    for (const glsl::Declaration& declaration : tree.declarations()) {
        if (declaration.qualifiers.isInterface()) continue;
        for (std::size_t i = declaration.tokens.first; i < declaration.tokens.end; ++i) {
            CodeToken& one = kept.emplace_back(tokens[i]);
            one.code = codeOfText(one.text);
            if (one.isNumber) {
                one.code = kNumberCode;
            } else if (one.isWord) {
                const bool isCall = i + 1 < tokens.size() && tokens[i + 1].text == "(";
                const bool isBuiltIn = one.text.starts_with("gl_") || (isCall && !own.contains(one.text));
                if (glsl::keywordSince(one.text) == 0 && !isBuiltIn) one.code = kNameCode;
            }
        }
    }
    return kept;
}

std::vector<SourceToken> comparableTokens(std::string_view glsl, std::size_t most) {
    const Text text(glsl);
    const std::vector<CodeToken> written = codeOf(text.code()), macros = codeOf(text.macros());
    const OwnFunctions own = ownFunctions(written);
    std::deque<std::string> names;
    std::vector<CodeToken> all =
        withoutDetours(withoutDeadCode(withoutLists(comparedCode(written, own)), own), own, {}, names);
    all = inStatementOrder(inOrder(all, kNumberCode), own);
    const std::vector<CodeToken> last = inOrder(comparedCode(macros, own), kNumberCode);
    all.insert(all.end(), last.begin(), last.end());
    std::vector<SourceToken> tokens;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
        tokens.push_back({all[i].code, all[i].line.number});
    return tokens;
}

std::vector<DeclaredUniform> declaredUniforms(std::string_view glsl) {
    const Text text(glsl);
    const std::vector<CodeToken> code = codeOf(text.code());
    const CodeTree tree(code);
    std::vector<DeclaredUniform> found;
    const auto add = [&](std::uint32_t name, std::string_view type) {
        DeclaredUniform one{std::string(code[name].text), std::string(type)};
        if (std::ranges::find(found, one) == found.end()) found.push_back(std::move(one));
    };
    for (const glsl::Declaration& each : tree.declarations()) {
        if (each.qualifiers.storage != glsl::Storage::uniform) continue;
        if (each.kind == glsl::DeclarationKind::block) add(each.name, "block");
        if (each.kind == glsl::DeclarationKind::variable)
            for (const glsl::Declarator& one : each.declarators) add(one.name, each.type.name);
    }
    return found;
}

std::vector<std::string> includedNames(std::string_view glsl) {
    const Text text(glsl);
    std::vector<std::string> names;
    for (const std::vector<const Token*>& line : text.directives()) {
        if (line.size() < 3 || line[1]->text != "include") continue;
        const char* begin = line[2]->text.data();
        const std::string_view rest(
            begin, static_cast<std::size_t>(line.back()->text.data() + line.back()->text.size() - begin));
        const std::size_t open = rest.find_first_of("\"<");
        const std::size_t close = rest.find_first_of("\">", open + 1);
        if (open != std::string_view::npos && close != std::string_view::npos)
            names.emplace_back(rest.substr(open + 1, close - open - 1));
    }
    return names;
}

std::vector<std::uint64_t> gramHashes(std::span<const SourceToken> tokens) {
    if (tokens.size() < kGram) return {};
    std::uint64_t highest = 1;  // kGolden to the power of kGram - 1
    for (std::size_t i = 1; i < kGram; ++i) highest *= base::kGolden;
    std::vector<std::uint64_t> hashes;
    hashes.reserve(tokens.size() - kGram + 1);
    std::uint64_t rolling = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (i >= kGram) rolling -= highest * tokens[i - kGram].code;
        rolling = rolling * base::kGolden + tokens[i].code;
        // Mixed, because the order of rolling hashes would prefer some tokens.
        if (i + 1 >= kGram) hashes.push_back(base::murmurMixed(rolling));
    }
    return hashes;
}

void addGivenCode(GivenCode& given, std::span<const SourceToken> tokens) {
    for (const std::uint64_t each : gramHashes(tokens)) given.insert(each);
}

std::vector<Fingerprint> fingerprintsOf(std::span<const SourceFile> files, const GivenCode& given) {
    std::vector<Fingerprint> kept;
    for (std::size_t file = 0; file < files.size(); ++file) {
        const std::vector<std::uint64_t> hashes = gramHashes(files[file].tokens);
        // A text with fewer hashes than a window has one window.
        const std::size_t window = std::min(kWindow, hashes.size());
        std::size_t last = hashes.size();  // the hash that was kept last
        for (std::size_t end = window; window > 0 && end <= hashes.size(); ++end) {
            std::size_t least = end - 1;
            for (std::size_t i = end - 1; i-- > end - window;)
                if (hashes[i] < hashes[least]) least = i;
            if (least == last) continue;
            last = least;
            if (!given.contains(hashes[least]))
                kept.push_back(
                    {hashes[least], {static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(least)}});
        }
    }
    return kept;
}

std::vector<SimilarPair> similarPairs(std::span<const std::vector<Fingerprint>> submissions,
                                      std::span<const std::vector<std::string>> files) {
    std::vector<Owned> all;
    std::vector<std::size_t> counts;
    FileNumbers numbers(files);
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        const std::vector<Owned> own = ownedHashes(submissions[i], i, numbers);
        counts.push_back(own.size());
        all.insert(all.end(), own.begin(), own.end());
    }
    std::ranges::sort(all, [](const Owned& one, const Owned& other) {
        return std::tuple(one.hash, one.submission) < std::tuple(other.hash, other.submission);
    });
    // The number of shared fingerprints of each pair (a, b), a < b, at row b of a triangle.
    const std::size_t count = submissions.size();
    std::vector<std::uint32_t> shared(count * (count > 0 ? count - 1 : 0) / 2, 0);
    const auto at = [](std::size_t a, std::size_t b) { return b * (b - 1) / 2 + a; };
    for (std::size_t begin = 0; begin < all.size();) {
        std::size_t end = begin;
        while (end < all.size() && all[end].hash == all[begin].hash) ++end;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = begin; k < i; ++k)
                if (all[k].file != all[i].file || all[k].file == kSeveral)
                    ++shared[at(all[k].submission, all[i].submission)];
        begin = end;
    }
    std::vector<SimilarPair> pairs;
    for (std::size_t b = 1; b < count; ++b)
        for (std::size_t a = 0; a < b; ++a) {
            const std::size_t both = shared[at(a, b)];
            if (both < kLeastShared) continue;
            const SimilarPair pair{a, b, both, static_cast<double>(both) / static_cast<double>(counts[a]),
                                   static_cast<double>(both) / static_cast<double>(counts[b])};
            if (pair.figure() >= kLeastFigure) pairs.push_back(pair);
        }
    std::ranges::sort(pairs, [](const SimilarPair& one, const SimilarPair& other) {
        return std::tuple(-one.figure(), -std::min(one.ofA, one.ofB), other.shared, one.a, one.b) <
               std::tuple(-other.figure(), -std::min(other.ofA, other.ofB), one.shared, other.a, other.b);
    });
    return pairs;
}

std::vector<SharedPassage> sharedPassages(std::span<const SourceFile> filesA, std::span<const Fingerprint> a,
                                          std::span<const SourceFile> filesB, std::span<const Fingerprint> b,
                                          std::size_t most) {
    constexpr std::size_t kMostCandidates =
        16;  // of one fingerprint; code may repeat itself thousands of times
    std::unordered_map<std::uint64_t, std::vector<TokenPlace>> places;
    for (const Fingerprint& each : b)
        if (std::vector<TokenPlace>& known = places[each.hash]; known.size() < kMostCandidates)
            known.push_back(each.place);
    Covered coveredA(filesA), coveredB(filesB);
    std::size_t steps = 20'000'000;  // code that repeats itself may be compared with itself again and again
    const auto isSame = [&](const TokenPlace& one, const TokenPlace& other) {
        if (steps == 0) return false;
        --steps;
        return filesA[one.file].tokens[one.token].code == filesB[other.file].tokens[other.token].code &&
               !coveredA.at(one) && !coveredB.at(other);
    };
    const auto extended = [&](TokenPlace one, TokenPlace other) {
        while (one.token > 0 && other.token > 0 &&
               isSame({one.file, one.token - 1}, {other.file, other.token - 1})) {
            --one.token;
            --other.token;
        }
        SharedPassage passage{one, other, 0};
        const auto length = [](const SourceFile& file) {
            return static_cast<std::uint32_t>(file.tokens.size());
        };
        for (; one.token < length(filesA[one.file]) && other.token < length(filesB[other.file]) &&
               isSame(one, other);
             ++one.token, ++other.token)
            ++passage.tokens;
        return passage;
    };
    std::vector<SharedPassage> passages;
    for (const Fingerprint& each : a) {
        const auto known = places.find(each.hash);
        if (known == places.end() || coveredA.at(each.place)) continue;
        SharedPassage longest;
        for (const TokenPlace& other : known->second) {
            const std::string& place = filesA[each.place.file].place;
            if ((!place.empty() && place == filesB[other.file].place) || !isSame(each.place, other)) continue;
            const SharedPassage passage = extended(each.place, other);
            if (passage.tokens > longest.tokens) longest = passage;
        }
        if (longest.tokens < kGram) continue;
        coveredA.cover(longest.a, longest.tokens);
        coveredB.cover(longest.b, longest.tokens);
        passages.push_back(longest);
    }
    std::ranges::stable_sort(passages, [](const SharedPassage& one, const SharedPassage& other) {
        return one.tokens > other.tokens;
    });
    if (passages.size() > most) passages.resize(most);
    return passages;
}

}  // namespace glibra::classroom
