#pragma once
// Parts that scenes drawn one after another with one context share: meshes, textures, programs and translated
// shaders. Each is stored under a key that says everything it is made from. The least recently used part is
// removed when a store is full.

#include <cstddef>
#include <glm/vec4.hpp>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/program_resources.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"

namespace glibra::geometry {
struct Mesh;
}
namespace glibra::glsl {
struct TranslatedProgram;
}
namespace glibra::scene {
struct Scene;
struct Shape;
struct Texture;
}  // namespace glibra::scene

namespace glibra::render {

/// The smallest and largest value of each coordinate of all vertices, in model space; w is 1 if the mesh has
/// none.
struct VertexBox {
    glm::dvec4 low{0.0}, high{0.0};
    bool isKnown = false;  ///< false: there are no vertices, or one is not finite
};
VertexBox boundsOf(const geometry::Mesh& mesh);

// Keys that say what a shape or a texture is made from, so that a scene that is read again keeps what has not
// changed.

/// Shapes with equal keys give the same mesh. A key holds the command and its numbers, and a file's path,
/// length and modification time. It is empty for shapes whose vertices are in the scene's text; they are
/// never reused.
std::string reuseKey(const scene::Scene& scene, const scene::Shape& shape);

/// The same for textures. It is empty for render targets, whose content belongs to the drawn frames.
std::string reuseKey(const scene::Scene& scene, const scene::Texture& texture);

struct DeviceMesh;

/// Values by key, up to a sum of sizes. Several threads may use it at once. A value is destroyed on the
/// thread whose add() makes the store too large.
template <class Value>
class PartStore {
  public:
    explicit PartStore(std::size_t largest) : largest_(largest) {}

    /// Returns a copy of the value under the key.
    std::optional<Value> find(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        const auto found = index_.find(key);
        if (found == index_.end()) return std::nullopt;
        entries_.splice(entries_.begin(), entries_, found->second);
        return found->second->value;
    }
    [[nodiscard]] bool contains(const std::string& key) const {
        const std::scoped_lock lock(mutex_);
        return index_.contains(key);
    }
    /// Removes and returns the value.
    std::optional<Value> take(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        const auto found = index_.find(key);
        if (found == index_.end()) return std::nullopt;
        std::optional<Value> value(std::move(found->second->value));
        remove(found->second);
        return value;
    }
    /// Stores a value, in place of an earlier one. A value larger than the whole store is not kept.
    void add(const std::string& key, Value value, std::size_t size) {
        const std::scoped_lock lock(mutex_);
        if (const auto found = index_.find(key); found != index_.end()) remove(found->second);
        if (size > largest_) return;
        entries_.push_front({key, std::move(value), size});
        index_.emplace(key, entries_.begin());
        size_ += size;
        while (size_ > largest_) remove(std::prev(entries_.end()));
    }
    [[nodiscard]] std::size_t size() const {
        const std::scoped_lock lock(mutex_);
        return size_;
    }

  private:
    struct Entry {
        std::string key;
        Value value;
        std::size_t size = 0;
    };
    using Place = typename std::list<Entry>::iterator;
    void remove(Place place) {
        size_ -= place->size;
        index_.erase(place->key);
        entries_.erase(place);
    }

    mutable std::mutex mutex_;
    std::size_t largest_;
    std::size_t size_ = 0;
    std::list<Entry> entries_;  ///< most recently used first
    std::unordered_map<std::string, Place> index_;
};

/// A linked program with the compiler's diagnostics of its sources. It holds the values of uniforms, so one
/// scene at a time owns it.
struct SharedProgram {
    gpu::Program program;
    base::ActiveResources resources;
    Diagnostics remarks;
};

/// It must be destroyed before the context. Parts with diagnostics are not cached, so that each scene reports
/// them. Only the context's thread uses parts that own GL names; other threads may only call contains().
struct SharedParts {
    static constexpr std::size_t kMegabyte = std::size_t{1} << 20;
    PartStore<std::shared_ptr<const geometry::Mesh>> meshes{64 * kMegabyte};
    PartStore<VertexBox> bounds{4096};  ///< counted, not measured in bytes; likewise programs
    PartStore<std::shared_ptr<const DeviceMesh>> deviceMeshes{64 * kMegabyte};
    PartStore<std::shared_ptr<const gpu::Texture>> textures{128 * kMegabyte};
    PartStore<SharedProgram> programs{128};
    PartStore<std::shared_ptr<const glsl::TranslatedProgram>> translations{8 * kMegabyte};
};

}  // namespace glibra::render
