#pragma once
// What scenes read, found out in worker processes, since a scene may have been written by somebody else.

#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"

namespace glibra::suite {

struct SceneQuery {
    std::filesystem::path scene;
    RenderOptions options;
    std::optional<double> timeout{};  ///< seconds, instead of those of the workers; 0: no limit
};

struct SceneInputs {
    std::vector<std::filesystem::path> files;  ///< render::filesReadBy()
    /// Hash of their names and contents; empty if they could not be read or there may be more.
    std::string content;
};

/// The inputs of each scene with exactly its options, in the order of the queries. Equal queries are answered
/// once. A scene whose worker ends or is late has none, and takes no other's.
std::vector<SceneInputs> readInputs(std::span<const SceneQuery> queries, const base::WorkerOptions& options);

/// Hash of a file's content as text; the reason as a word if it cannot be read.
std::string contentOf(const std::filesystem::path& file);

}  // namespace glibra::suite
