// Textures of DeviceScene that another moment of the scene states otherwise.

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "render/load/device_scene.h"

namespace glibra::render {

void DeviceScene::dropTexture(scene::TextureIndex index) {
    std::set<const gpu::Texture*> gone;
    if (const auto made = textures_.find(index); made != textures_.end()) gone.insert(made->second.get());
    if (const auto made = copies_.find(index); made != copies_.end())
        for (const Copies::Copy& each : made->second.copies)
            gone.insert({each.texture.get(), each.resolved.get()});
    gone.erase(nullptr);
    std::erase_if(views_, [&](const auto& each) { return gone.contains(std::get<0>(each.first)); });
    std::set<int> depths;
    std::erase_if(targets_, [&](const MadeTarget& each) {
        const bool isGone = std::any_of(each.textures.begin(), each.textures.end(),
                                        [&](const gpu::Texture* part) { return gone.contains(part); });
        if (isGone) depths.insert(each.depthBuffer);
        return isGone;
    });
    std::erase_if(depthBuffers_, [&](const auto& each) { return depths.contains(std::get<0>(each.first)); });
    sharing_.erase(index);
    copies_.erase(index);
    textures_.erase(index);
    changed_.erase(index);
}

Diagnostics DeviceScene::followSizes(bool& hasLost) {
    std::vector<scene::TextureIndex> others;
    for (const auto& [index, made] : copies_) {
        const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[index].source);
        if (empty == nullptr || !made.copies[0].texture) continue;
        const gpu::TextureSize size = made.copies[0].texture->size();
        if (size.width != empty->width || size.height != empty->height || size.depth != empty->depth)
            others.push_back(index);
    }
    Diagnostics diagnostics;
    for (const scene::TextureIndex each : others) {
        dropTexture(each);
        if (!lasting_.contains(each)) continue;
        hasLost = true;
        append(diagnostics, makeTexture(each));
    }
    return diagnostics;
}

bool DeviceScene::isMade(scene::TextureIndex index, const std::string& key) {
    const auto made = textures_.find(index);
    if (made == textures_.end()) return sameTexture_.contains(index);
    const auto* empty = std::get_if<scene::EmptySource>(&scene_.textures[index].source);
    const gpu::TextureSize size = made->second->size();
    const bool isSame = empty != nullptr ? size.width == empty->width && size.height == empty->height &&
                                               size.depth == empty->depth
                                         : textureKeys_[index] == key;
    if (isSame) return true;
    if (const auto charged = charged_.extract(index)) texelBytesLeft_ += charged.mapped();
    dropTexture(index);
    return false;
}

}  // namespace glibra::render
