// Runs a fuzz target without libFuzzer: first on every file of the corpus, then on a number of changed files,
// the same on every machine. Coverage does not guide it. tools/fuzz runs the targets with libFuzzer instead.
//
//     fuzz_TARGET [-runs=N] [-seed=N] [-keep=FILE] [-apart] FILE|FOLDER...
//
// -keep writes every input to FILE before it is tried, so that it exists after a crash. -apart tries every
// input in a process of its own with limits; one that crashes in there, or takes too long, is counted and is
// no failure.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "check.h"
#include "random.h"

// The mutators of a target, if it has them, with the interface of libFuzzer.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t largest, unsigned seed);
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomCrossOver(
    const std::uint8_t* first, std::size_t firstSize, const std::uint8_t* second, std::size_t secondSize,
    std::uint8_t* out, std::size_t largest, unsigned seed);

namespace {

namespace fs = std::filesystem;
using glibra::fuzz::Random;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kLargestInput = 1U << 16;  ///< bytes

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
            if (rest) bytes[at] = random.oneOf(kBytes);
            break;
        case 2: {
            const std::string_view number = random.oneOf(glibra::fuzz::kExtremeNumbers);
            insert(bytes, at, reinterpret_cast<const std::uint8_t*>(number.data()), number.size());
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
            const std::uint8_t byte = random.oneOf(kBytes);
            insert(bytes, at, &byte, 1);
            break;
        }
        default:
            if (random.oneIn(4)) bytes.resize(at);
            break;
    }
    if (bytes.size() > kLargestInput) bytes.resize(kLargestInput);
}

/// What the mutators of a target call for changes of bytes; driven by the run in progress.
struct {
    Random random{0};
    Bytes other;
} current;

/// One to six changes by the target's own mutator, or of bytes.
Bytes changed(Bytes bytes, const Bytes& other, std::uint64_t seed) {
    Random random(seed);
    current.random = Random(random.next());
    current.other = other;
    const auto draw = [&] { return static_cast<unsigned>(random.next()); };
    if (LLVMFuzzerCustomCrossOver && random.oneIn(8)) {
        Bytes both(kLargestInput);
        both.resize(LLVMFuzzerCustomCrossOver(bytes.data(), bytes.size(), other.data(), other.size(),
                                              both.data(), both.size(), draw()));
        bytes = std::move(both);
    }
    for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
        if (!LLVMFuzzerCustomMutator) {
            change(bytes, other, random);
            continue;
        }
        const std::size_t size = bytes.size();
        bytes.resize(kLargestInput);
        bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), draw()));
    }
    return bytes;
}

/// Tries one input in a process of its own; false if that was ended by a signal or a sanitizer.
bool endsWell(const Bytes& bytes) {
    constexpr int kBroken = 3;
    constexpr rlim_t kSeconds = 5;
    const pid_t child = fork();
    glibra::fuzz::check(child >= 0, "a process can be started");
    if (child == 0) {
        const rlimit seconds{kSeconds, kSeconds};
        setrlimit(RLIMIT_CPU, &seconds);
        alarm(static_cast<unsigned>(4 * kSeconds));
        const rlimit noCore{0, 0};
        setrlimit(RLIMIT_CORE, &noCore);
        glibra::fuzz::statusOfBroken = kBroken;
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        std::_Exit(0);
    }
    int status = 0;
    glibra::fuzz::check(waitpid(child, &status, 0) == child, "a process can be waited for");
    glibra::fuzz::check(!WIFEXITED(status) || WEXITSTATUS(status) != kBroken, "the conditions hold");
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

struct Arguments {
    std::uint64_t runs = 0;
    std::uint64_t seed = 0;
    bool apart = false;
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
        else if (word == "-apart")
            arguments.apart = true;
        else
            arguments.corpus.emplace_back(word);
    }
    return arguments;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest) {
    Bytes bytes(data, data + size);
    change(bytes, current.other, current.random);
    size = std::min(bytes.size(), largest);
    std::copy_n(bytes.begin(), size, data);
    return size;
}

int main(int count, char** words) {
    const Arguments arguments = argumentsOf(count, words);
    const std::vector<Bytes> corpus = corpusOf(arguments.corpus);
    if (corpus.empty()) {
        std::fprintf(stderr, "usage: %s [-runs=N] [-seed=N] [-keep=FILE] [-apart] FILE|FOLDER...\n",
                     words[0]);
        return 2;
    }
    std::size_t ended = 0;
    const auto attempt = [&](const Bytes& bytes) {
        if (!arguments.keep.empty())
            std::ofstream(arguments.keep, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        if (!arguments.apart)
            LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        else if (!endsWell(bytes))
            ++ended;
    };
    for (const Bytes& bytes : corpus) attempt(bytes);
    for (std::uint64_t run = 0; run < arguments.runs; ++run) {
        Random random(arguments.seed * 0x100000001B3U + run);
        const Bytes& bytes = corpus[random.below(corpus.size())];
        const Bytes& other = corpus[random.below(corpus.size())];
        attempt(changed(bytes, other, random.next()));
    }
    std::printf("%zu files and %llu changed ones\n", corpus.size(),
                static_cast<unsigned long long>(arguments.runs));
    if (ended > 0) std::printf("%zu of them ended their process\n", ended);
    return 0;
}
