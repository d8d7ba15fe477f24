#include "gpu/state/binding_tracker.h"

#include <algorithm>
#include <utility>

namespace glibra::gpu {

BindingTracker::Unit& BindingTracker::unit(int index) {
    const auto at = static_cast<std::size_t>(index);
    if (at >= units_.size()) units_.resize(at + 1);
    return units_[at];
}

void BindingTracker::forget() {
    program_ = array_ = 0;
    units_.clear();
    images_.clear();
    buffers_.clear();
}

void BindingTracker::forgetWorkUnit() {
    if (!units_.empty()) units_.front().textures = {};
}

void BindingTracker::use(const Program& program) {
    if (std::exchange(program_, program.id()) != program.id()) program.use();
}

void BindingTracker::bind(const VertexArray& array) {
    if (std::exchange(array_, array.id()) != array.id()) array.bind();
}

void BindingTracker::bind(const Texture& texture, int unit) {
    GLuint& bound = this->unit(unit).textures.at(static_cast<std::size_t>(texture.shape()));
    if (std::exchange(bound, texture.id()) != texture.id()) texture.bind(unit);
}

void BindingTracker::bind(const Sampler& sampler, int unit) {
    if (std::exchange(this->unit(unit).sampler, sampler.id()) != sampler.id()) sampler.bind(unit);
}

void BindingTracker::bindImage(const Texture& texture, int unit, int level, std::optional<int> layer,
                               GLenum access, std::optional<TexelFormat> as) {
    const auto at = static_cast<std::size_t>(unit);
    if (at >= images_.size()) images_.resize(at + 1);
    const Image wanted{texture.id(), level, layer, access, as};
    if (images_[at] == wanted) return;
    images_[at] = wanted;
    texture.bindImage(unit, level, layer, access, as);
}

void BindingTracker::bindBase(const Buffer& buffer, GLenum target, GLuint index) {
    const auto isIt = [&](const IndexedBuffer& each) { return each.target == target && each.index == index; };
    auto bound = std::ranges::find_if(buffers_, isIt);
    if (bound == buffers_.end()) bound = buffers_.insert(bound, {target, index, 0});
    if (std::exchange(bound->name, buffer.id()) != buffer.id()) buffer.bindBase(target, index);
}

}  // namespace glibra::gpu
