#include "noise/cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <system_error>

#include "noise/checksum.h"
#include "noise/noise.h"
#include "noise/tables.h"

namespace glibra::noise {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a cache file, in the machine's own byte order: a file of another order has another
/// checksum.
struct Header {
    std::array<char, 8> magic{'g', 'l', 'i', 'b', 'n', 'o', 'i', '1'};
    std::uint64_t tables = 0;  ///< checksum of the tables the texels were made from
    std::uint32_t dimensions = 0, size = 0;
    std::uint64_t checksum = 0;  ///< of the texels, seeded with `tables`

    friend bool operator==(const Header&, const Header&) = default;
};

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    explicit operator bool() const { return number_ >= 0; }
    [[nodiscard]] int number() const { return number_; }

  private:
    int number_;
};

bool readAll(const Descriptor& file, void* to, std::size_t size) {
    auto* at = static_cast<std::uint8_t*>(to);
    while (size > 0) {
        const ssize_t got = ::read(file.number(), at, size);
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

bool writeAll(const Descriptor& file, const void* from, std::size_t size) {
    const auto* at = static_cast<const std::uint8_t*>(from);
    while (size > 0) {
        const ssize_t put = ::write(file.number(), at, size);
        if (put <= 0) return false;
        at += put;
        size -= static_cast<std::size_t>(put);
    }
    return true;
}

/// Texel bytes of a texture, or 0 where there is no such texture.
std::size_t texelBytes(int dimensions, int n) {
    if ((dimensions != 2 && dimensions != 3) || n < 1) return 0;
    if (n > (dimensions == 2 ? kLargestSize2 : kLargestSize3)) return 0;
    const auto size = static_cast<std::size_t>(n);
    return 4 * size * size * (dimensions == 3 ? size : 1);
}

TexelBytes compute(int dimensions, int n) {
    TexelBytes texels(texelBytes(dimensions, n));
    dimensions == 3 ? writeNoise3(n, texels) : writeNoise2(n, texels);
    return texels;
}

template <class Values>
std::uint64_t absorbValues(std::uint64_t sum, const Values& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return checksum({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, sum);
}

std::uint64_t tableChecksum() {
    std::uint64_t sum = 0;
    for (const tables::Octave3& each : tables::kOctaves3)
        sum = absorbValues(absorbValues(absorbValues(sum, each.p), each.q), each.gradients);
    for (const tables::Octave2& each : tables::kOctaves2)
        sum = absorbValues(absorbValues(sum, each.p), each.gradients);
    return sum;
}

Header headerFor(int dimensions, int n, std::span<const std::uint8_t> texels) {
    Header header;
    header.tables = tableChecksum();
    header.dimensions = static_cast<std::uint32_t>(dimensions);
    header.size = static_cast<std::uint32_t>(n);
    header.checksum = checksum(texels, header.tables);
    return header;
}

fs::path fileFor(const fs::path& folder, int dimensions, int n) {
    return folder / ("noise" + std::to_string(dimensions) + "d." + std::to_string(n) + ".texels");
}

fs::path absoluteFromEnvironment(const char* variable) {
    const char* value = std::getenv(variable);
    const fs::path path = value != nullptr ? value : "";
    return path.is_absolute() ? path : fs::path();  // the XDG rules have a relative path ignored
}

}  // namespace

fs::path cacheFolder() {
    if (const fs::path cache = absoluteFromEnvironment("XDG_CACHE_HOME"); !cache.empty())
        return cache / "glibra";
    if (const fs::path home = absoluteFromEnvironment("HOME"); !home.empty())
        return home / ".cache" / "glibra";
    return {};
}

std::optional<TexelBytes> loadTexels(const fs::path& folder, int dimensions, int n) {
    const std::size_t bytes = texelBytes(dimensions, n);
    if (bytes == 0 || folder.empty()) return std::nullopt;
    // Non-blocking, so that something else under that name (a pipe) cannot stop the program.
    const Descriptor file(::open(fileFor(folder, dimensions, n).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!file || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    if (static_cast<std::uint64_t>(status.st_size) != sizeof(Header) + bytes) return std::nullopt;

    Header stored;
    TexelBytes texels(bytes);
    if (!readAll(file, &stored, sizeof stored) || !readAll(file, texels.data(), bytes)) return std::nullopt;
    if (stored != headerFor(dimensions, n, texels)) return std::nullopt;
    return texels;
}

bool storeTexels(const fs::path& folder, int dimensions, int n, std::span<const std::uint8_t> texels) {
    if (folder.empty() || texels.empty() || texels.size() != texelBytes(dimensions, n)) return false;
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return false;

    const fs::path path = fileFor(folder, dimensions, n);
    std::string temporary = path.string() + ".XXXXXX";
    const Header header = headerFor(dimensions, n, texels);
    bool whole = false;
    {
        const Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
        if (!file) return false;
        whole = writeAll(file, &header, sizeof header) && writeAll(file, texels.data(), texels.size());
    }
    if (whole) fs::rename(temporary, path, failed);
    if (!whole || failed) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        return false;
    }
    return true;
}

TexelBytes cachedTexels(int dimensions, int n, const fs::path& folder, std::size_t smallest) {
    const std::size_t bytes = texelBytes(dimensions, n);
    if (bytes == 0) return {};
    if (bytes < smallest || folder.empty()) return compute(dimensions, n);
    if (auto stored = loadTexels(folder, dimensions, n)) return std::move(*stored);
    TexelBytes texels = compute(dimensions, n);
    storeTexels(folder, dimensions, n,
                texels);  // a cache that cannot be written changes nothing for the caller
    return texels;
}

}  // namespace glibra::noise
