#pragma once
// Hashes of pixels and files, and the file that has those of a suite's goldens.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.h"
#include "gpu/context/capabilities.h"
#include "image/image.h"

namespace glibra::suite {

// Hashes of pixels and files, and their texts.

using base::Hash;

/// Hash of the size, the component count, the component type and all pixels. It is the same on all machines
/// with the same byte order.
Hash hashOf(const image::Image& picture);
/// Hash of the bytes of a file.
Hash hashOf(std::span<const std::byte> bytes);

/// 32 hexadecimal digits, and back.
std::string toText(const Hash& hash);
std::optional<Hash> parseHash(std::string_view text);

// The list of the exact pixels that were accepted, per driver, in a file beside the goldens of a suite. It is
// a text file of sorted lines, one per shot and driver, so that git can merge it. A lost line costs time, and
// a shot that no line names may do without a golden if its scene checks itself.
//
//     teapot - 0f3c...golden 9a41...pixels llvmpipe (LLVM 15.0.6, 256 bits); 4.5 ...
//
// A line is valid only for the golden file and the tolerance that it was written for. So replacing a golden
// by hand, merging two branches or changing a tolerance invalidates its lines.

// What can change the bits of a picture: the driver, its version and, for software drivers, the processor.

/// Returns one line: GL_RENDERER, GL_VERSION and, if the processor draws, its vendor, the features that
/// shader compilers use, and the environment variables that choose between them.
std::string driverKey(const gpu::Capabilities& driver);

/// The words of golden variants that apply to a family of drivers, the nearest first: "osmesa-llvmpipe" gives
/// "osmesa-llvmpipe" and "llvmpipe". The golden for all drivers comes after them.
std::vector<std::string> variantsFor(std::string_view family);

/// Processor model and system, for reports: "Intel(R) Xeon(R), Linux 6.1 x86_64".
std::string describeMachine();

struct AcceptedHash {
    std::string shot;
    std::string variant;  ///< variant of the golden; empty: the one for all drivers
    Hash golden;          ///< hash of the golden's file and the shot's tolerance
    Hash pixels;          ///< hash of the rendered picture
    std::string key;      ///< driverKey()
};

/// True for a driverKey() as it stands in a line: not empty, one line, and of at most 1000 bytes.
bool isKey(std::string_view text);
/// True if a text can be an AcceptedHash::variant, which names a file: one that shotOfVariant() knows.
bool isVariant(std::string_view word);
/// Writes and reads one line without its line end.
std::string toLine(const AcceptedHash& accepted);
Result<AcceptedHash> parseLine(std::string_view line, const Place& place);

class HashList {
  public:
    HashList() = default;
    /// Reads the list. A missing file is an empty list. Lines that cannot be read are left out and reported
    /// as suite-W01. A file that cannot be read is an empty list with the reason as a warning; isUnknown()
    /// is true then.
    static Result<HashList> read(const std::filesystem::path& file);

    /// The pixels that were accepted with that driver for the golden of that content, or null.
    [[nodiscard]] const Hash* find(const std::string& shot, const std::string& variant, const Hash& golden,
                                   const std::string& key) const;
    /// The names of the shots that it has lines for.
    [[nodiscard]] std::set<std::string> shots() const;
    /// The lines of a shot, sorted.
    [[nodiscard]] std::vector<AcceptedHash> linesOf(const std::string& shot) const;
    /// The file is there, but what it says is not known.
    [[nodiscard]] bool isUnknown() const { return isUnknown_; }
    /// Adds lines. They replace lines of the same shot, variant and driver, and lines for other content of
    /// the same golden.
    void accept(std::span<const AcceptedHash> accepted);
    /// Replaces the lines of one golden of a shot.
    void restore(const std::string& shot, const std::string& variant, std::span<const AcceptedHash> lines);
    /// Makes the lines of a shot those of another one.
    void rename(const std::string& shot, const std::string& to);
    [[nodiscard]] std::string toText() const;

  private:
    std::map<std::string, std::vector<AcceptedHash>> ofShot_;
    bool isUnknown_ = false;
};

/// Adds lines to the file, which other processes may change at the same time. Returns nothing if that worked.
/// A file that is a link is not written (file-E10).
Diagnostics acceptHashes(const std::filesystem::path& file, std::span<const AcceptedHash> accepted);
/// Replaces the lines of one golden of a shot in the file; otherwise as acceptHashes.
Diagnostics restoreHashes(const std::filesystem::path& file, const std::string& shot,
                          const std::string& variant, std::span<const AcceptedHash> lines);
/// Makes the lines of a shot in the file those of another one; otherwise as acceptHashes.
Diagnostics renameHashes(const std::filesystem::path& file, const std::string& shot, const std::string& to);

}  // namespace glibra::suite
