#include "classroom/similarity.h"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <unordered_map>

#include "base/hash.h"

namespace glibra::classroom {
namespace {

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
