#pragma once
// What scenes that are drawn one after another with one context have in common is made once: meshes,
// textures, programs, and translations of shaders, each under a key that says all it is made from. The least
// recently used goes when there is too much.

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "geometry/mesh.h"
#include "glsl/types/translated_program.h"
#include "gpu/program.h"
#include "gpu/reflection.h"
#include "gpu/texture.h"
#include "render/sight.h"

namespace glibra::render {

struct DeviceMesh;

/// Values by key, up to a sum of sizes. Several threads may use it at once; a value goes on the thread whose
/// add() or take() leaves no place for it.
template <class Value>
class PartStore {
  public:
    explicit PartStore(std::size_t largest) : largest_(largest) {}

    /// A copy of the value under the key.
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
    /// Takes it out.
    std::optional<Value> take(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        const auto found = index_.find(key);
        if (found == index_.end()) return std::nullopt;
        std::optional<Value> value(std::move(found->second->value));
        remove(found->second);
        return value;
    }
    /// Keeps it in place of an earlier one; not if it alone is too large.
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

/// A linked program with what the compiler said of its sources. Values of uniforms are a part of it, so it
/// belongs to one scene at a time.
struct SharedProgram {
    gpu::Program program;
    gpu::ProgramInterface reflected;
    Diagnostics remarks;
};

/// Must go before the context does. Nothing is kept that was made with a remark: the next scene is to hear it
/// too. What has a name of GL's is used on the context's thread alone; others may ask whether it is there.
struct SharedParts {
    static constexpr std::size_t kMegabyte = std::size_t{1} << 20;
    PartStore<std::shared_ptr<const geometry::Mesh>> meshes{64 * kMegabyte};
    PartStore<Bounds> bounds{4096};  ///< counted one by one, like programs
    PartStore<std::shared_ptr<const DeviceMesh>> deviceMeshes{64 * kMegabyte};
    PartStore<std::shared_ptr<const gpu::Texture>> textures{128 * kMegabyte};
    PartStore<SharedProgram> programs{128};
    PartStore<std::shared_ptr<const glsl::TranslatedProgram>> translations{8 * kMegabyte};
};

}  // namespace glibra::render
