#pragma once
// What scenes read, found out in worker processes, since a scene may have been written by somebody else.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"

namespace glibra::suite {

struct SceneQuery {
    std::filesystem::path scene;
    RenderOptions options;
};

struct SceneInputs {
    std::vector<std::filesystem::path> files;  ///< render::filesReadBy()
    std::string content;  ///< hash of their names and contents; empty if they could not be read
};

/// The inputs of each scene, in the order of the queries. Equal queries are answered once. A scene whose
/// worker ends or is late has none.
std::vector<SceneInputs> readInputs(std::span<const SceneQuery> queries, const base::WorkerOptions& options);

/// Hash of a file's content as text; the reason as a word if it cannot be read.
std::string contentOf(const std::filesystem::path& file);

}  // namespace glibra::suite
