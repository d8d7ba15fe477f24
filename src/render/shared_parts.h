#pragma once
// What scenes that are drawn one after another with one context have in common is made once: meshes,
// textures, programs, and translations of shaders, each under a key that says all it is made from. The least
// recently used goes when there is too much.

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "geometry/mesh.h"
#include "glsl/translate.h"
#include "gpu/program.h"
#include "gpu/reflection.h"
#include "gpu/texture.h"
#include "render/sight.h"

namespace glibra::render {

struct DeviceMesh;

/// Values by key, up to a sum of sizes.
template <class Value>
class PartStore {
  public:
    explicit PartStore(std::size_t largest) : largest_(largest) {}

    /// The value under the key, or null.
    const Value* find(const std::string& key) {
        const auto found = index_.find(key);
        if (found == index_.end()) return nullptr;
        entries_.splice(entries_.begin(), entries_, found->second);
        return &found->second->value;
    }
    /// Takes it out.
    std::optional<Value> take(const std::string& key) {
        const auto found = index_.find(key);
        if (found == index_.end()) return std::nullopt;
        std::optional<Value> value(std::move(found->second->value));
        remove(found->second);
        return value;
    }
    /// Keeps it in place of an earlier one; not if it alone is too large.
    void add(const std::string& key, Value value, std::size_t size) {
        if (const auto found = index_.find(key); found != index_.end()) remove(found->second);
        if (size > largest_) return;
        entries_.push_front({key, std::move(value), size});
        index_.emplace(key, entries_.begin());
        size_ += size;
        while (size_ > largest_) remove(std::prev(entries_.end()));
    }
    [[nodiscard]] std::size_t size() const { return size_; }

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
/// too.
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
