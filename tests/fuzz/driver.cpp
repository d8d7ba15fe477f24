// Runs a fuzz target without libFuzzer: first on every file of the corpus, then on a number of changed files,
// the same on every machine. Coverage does not guide it. With clang, -DGLIBRA_FUZZ=ON links libFuzzer
// instead.
//
//     fuzz_TARGET [-runs=N] [-seed=N] [-keep=FILE] FILE|FOLDER...
//
// -keep writes every input to FILE before it is tried, so that it exists after a crash.

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "check.h"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kLargestInput = 1U << 16;  ///< bytes

/// splitmix64 (Steele, Lea, Flood 2014) of a counter: the same sequence everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// 0 .. count - 1; 0 if count is 0.
    std::size_t below(std::size_t count) { return count ? static_cast<std::size_t>(next() % count) : 0; }

  private:
    std::uint64_t state_;
};

/// Numbers at the limits of common types and sizes.
constexpr std::string_view kNumbers[] = {
    "0",   "-1",    "1e38", "-1e-45", "1e999", "nan",        "inf",
    "255", "65536", ".",    "1e-400", "0x7f",  "2147483648", "99999999999999999999"};
constexpr std::uint8_t kBytes[] = {0,   1,   0x7F, 0x80, 0xFE, 0xFF, '\n', '\r',
                                   ' ', '"', '#',  '<',  '[',  '{',  '(',  '\\'};

Bytes read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    Bytes bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (bytes.size() > kLargestInput) bytes.resize(kLargestInput);
    return bytes;
}

std::vector<Bytes> corpusOf(const std::vector<fs::path>& places) {
    std::vector<fs::path> files;
    for (const fs::path& place : places) {
        if (!fs::is_directory(place)) {
            files.push_back(place);
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(place))
            if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    std::vector<Bytes> corpus;
    for (const fs::path& file : files) corpus.push_back(read(file));
    return corpus;
}

void insert(Bytes& bytes, std::size_t at, const std::uint8_t* begin, std::size_t count) {
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), begin, begin + count);
}

/// One change: a bit, a byte, a number; a piece removed, doubled or copied from another input; an early end.
void change(Bytes& bytes, const Bytes& other, Random& random) {
    const std::size_t at = random.below(bytes.size() + 1);
    const std::size_t rest = bytes.size() - at;
    const std::size_t length = std::min(rest, std::size_t{1} << random.below(8));
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(8)) {
        case 0:
            if (rest) bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << random.below(8)));
            break;
        case 1:
            if (rest) bytes[at] = kBytes[random.below(std::size(kBytes))];
            break;
        case 2: {
            const std::string_view number = kNumbers[random.below(std::size(kNumbers))];
            const auto* digits = reinterpret_cast<const std::uint8_t*>(number.data());
            insert(bytes, at, digits, number.size());
            break;
        }
        case 3:
            bytes.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
            break;
        case 4: {
            const Bytes piece(begin, begin + static_cast<std::ptrdiff_t>(length));
            insert(bytes, at, piece.data(), piece.size());
            break;
        }
        case 5: {
            const std::size_t from = random.below(other.size() + 1);
            insert(bytes, at, other.data() + from,
                   std::min(other.size() - from, std::size_t{1} << random.below(9)));
            break;
        }
        case 6: {
            const std::uint8_t byte = kBytes[random.below(std::size(kBytes))];
            insert(bytes, at, &byte, 1);
            break;
        }
        default:
            if (random.below(4) == 0) bytes.resize(at);
            break;
    }
    if (bytes.size() > kLargestInput) bytes.resize(kLargestInput);
}

struct Arguments {
    std::uint64_t runs = 0;
    std::uint64_t seed = 0;
    fs::path keep;
    std::vector<fs::path> corpus;
};

Arguments argumentsOf(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = words[i];
        const auto number = [&](std::string_view option, std::uint64_t& value) {
            if (!word.starts_with(option)) return false;
            std::from_chars(word.data() + option.size(), word.data() + word.size(), value);
            return true;
        };
        if (number("-runs=", arguments.runs) || number("-seed=", arguments.seed)) continue;
        if (word.starts_with("-keep="))
            arguments.keep = word.substr(6);
        else
            arguments.corpus.emplace_back(word);
    }
    return arguments;
}

}  // namespace

int main(int count, char** words) {
    const Arguments arguments = argumentsOf(count, words);
    const std::vector<Bytes> corpus = corpusOf(arguments.corpus);
    if (corpus.empty()) {
        std::fprintf(stderr, "usage: %s [-runs=N] [-seed=N] [-keep=FILE] FILE|FOLDER...\n", words[0]);
        return 2;
    }
    const auto attempt = [&](const Bytes& bytes) {
        if (!arguments.keep.empty())
            std::ofstream(arguments.keep, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    };
    for (const Bytes& bytes : corpus) attempt(bytes);
    for (std::uint64_t run = 0; run < arguments.runs; ++run) {
        Random random(arguments.seed * 0x100000001B3U + run);
        Bytes bytes = corpus[random.below(corpus.size())];
        const Bytes& other = corpus[random.below(corpus.size())];
        for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) change(bytes, other, random);
        attempt(bytes);
    }
    std::printf("%zu files and %llu changed ones\n", corpus.size(),
                static_cast<unsigned long long>(arguments.runs));
    return 0;
}
