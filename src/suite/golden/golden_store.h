#pragma once
// Where a suite's golden pictures lie: SHOT.png for everybody, SHOT.llvmpipe.png for one family of drivers
// (float pictures: .exr), and beside them SUITE.hashes.

#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "suite/golden/hash_list.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A golden's file as it stands on the disk.
struct Golden {
    std::filesystem::path file;
    std::string variant;  ///< empty: for everybody
    std::vector<std::byte> bytes;
    Hash identity;  ///< of the bytes and the shot's tolerance
};

class GoldenStore {
  public:
    /// Reads the list of accepted pixels. `folder` instead of the suite's own, unless it is empty.
    static Result<GoldenStore> open(const Suite& suite, const std::filesystem::path& folder = {});

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::filesystem::path hashFile() const;
    [[nodiscard]] std::filesystem::path file(const Shot& shot, std::string_view variant) const;

    /// The nearest golden for a family of drivers; nothing, without diagnostics, if there is none, and with
    /// the reason if it cannot be read.
    [[nodiscard]] Result<Golden> find(const Shot& shot, std::string_view family) const;
    /// The pixels accepted with that driver for this golden, or null.
    [[nodiscard]] const Hash* acceptedPixels(const Shot& shot, const Golden& golden,
                                             const std::string& key) const;

    /// Makes the picture the golden of that variant, or leaves everything as it was: its file is replaced
    /// when the new one is whole. The result is the new golden.
    [[nodiscard]] Result<Golden> replace(const Shot& shot, std::string_view variant,
                                         const image::Image& picture) const;

  private:
    std::string suite_;
    std::filesystem::path folder_;
    HashList accepted_;
};

/// The pixels of a golden. Errors name its file, and what to do.
Result<image::Image> decode(const Golden& golden);

}  // namespace glibra::suite
