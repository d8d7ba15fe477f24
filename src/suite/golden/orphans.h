#pragma once
// Goldens that belong to no shot any more: of scenes and sweeps that were renamed or removed.

#include <glibra/result.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"
#include "suite/suite.h"

namespace glibra::suite {

/// Returns the pictures in the golden folder of a suite that no shot of it, nor of `others`, has as its
/// golden or as a variant of it, sorted. `folder` replaces the folders as in GoldenStore::open. Suites beside
/// this one count as others. Nothing is returned of a folder that another suite keeps its hashes in. Only
/// pictures count that the suite's list of hashes names if the folder has other files, such as scenes,
/// because the pictures may be textures, or if a TOML file beside the suite cannot be read as a suite. Links
/// are not followed.
std::vector<std::filesystem::path> orphanGoldens(const Suite& suite, const std::filesystem::path& folder = {},
                                                 std::span<const Suite> others = {});

/// The goldens of no shot, and their pixels, which are read when they are asked for first. Threads may share
/// it.
class Orphans {
  public:
    explicit Orphans(std::vector<std::filesystem::path> files) : files_(std::move(files)) {}
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
    [[nodiscard]] bool isEmpty() const { return files_.empty(); }
    /// The file whose pixels are exactly those of the picture; empty if there is none.
    [[nodiscard]] std::filesystem::path find(const image::Image& picture) const;
    /// The file that is most like this picture of a shot, or has the most similar name; empty if none is or
    /// has: it may be the golden of the shot before it was renamed and its scene changed.
    [[nodiscard]] std::filesystem::path findNear(const image::Image& picture, std::string_view shot) const;

  private:
    /// A picture as 16 x 16 colours, less their mean.
    using Gist = std::vector<double>;
    static Gist gistOf(const image::Image& picture);
    void read() const;

    std::vector<std::filesystem::path> files_;
    mutable std::once_flag isRead_;
    mutable std::map<std::string, std::filesystem::path> ofPixels_, ofPointer_;
    mutable std::vector<std::pair<std::filesystem::path, Gist>> gists_;
};

/// Removes them, and folders that are empty afterwards. Errors have the id file-E10.
Diagnostics removeOrphans(const std::vector<std::filesystem::path>& orphans);

}  // namespace glibra::suite
