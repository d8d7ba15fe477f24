#include "gpu/state/state_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gpu/format/gl_names.h"

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

namespace {

using base::kRasterTargets;

GLenum faceOf(base::Cull cull) {
    if (cull == base::Cull::both) return GL_FRONT_AND_BACK;
    return cull == base::Cull::front ? GL_FRONT : GL_BACK;
}

GLenum modeOf(base::PolygonMode mode) {
    if (mode == base::PolygonMode::point) return GL_POINT;
    return mode == base::PolygonMode::line ? GL_LINE : GL_FILL;
}

template <class T>
bool allEqual(const std::array<T, kRasterTargets>& values) {
    return std::ranges::all_of(values, [&](const T& each) { return each == values.front(); });
}

int edge(double fraction, int size) {
    return static_cast<int>(std::lround(std::clamp(fraction, -1.0, 2.0) * size));
}

PixelRectangle intersection(const PixelRectangle& a, const PixelRectangle& b) {
    const int left = std::max(a.x, b.x), bottom = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width), top = std::min(a.y + a.height, b.y + b.height);
    return {left, bottom, std::max(0, right - left), std::max(0, top - bottom)};
}

std::array<int, 4> asArray(const PixelRectangle& pixels) {
    return {pixels.x, pixels.y, pixels.width, pixels.height};
}

/// A line without antialiasing is a whole number of pixels wide. Half-way values are rounded to even by one
/// driver version and up by another; the smallest larger float makes all of them round up.
double roundedUpAtHalf(double lineWidth) {
    return lineWidth - std::floor(lineWidth) == 0.5
               ? std::nextafter(static_cast<float>(lineWidth), std::numeric_limits<float>::max())
               : lineWidth;
}

}  // namespace

PixelRectangle pixelsOf(const base::FractionRectangle& rectangle, int width, int height) {
    const int left = edge(rectangle.x, width), bottom = edge(rectangle.y, height);
    return {left, bottom, std::max(0, edge(rectangle.x + rectangle.width, width) - left),
            std::max(0, edge(rectangle.y + rectangle.height, height) - bottom)};
}

void RasterTracker::forget() {
    known_ = {};
}

void RasterTracker::targetBound(int width, int height) {
    width_ = width;
    height_ = height;
    known_.viewport = {0, 0, width, height};
}

void RasterTracker::enable(std::optional<bool>& known, GLenum capability, bool on) {
    change(known, on, [&] { on ? glEnable(capability) : glDisable(capability); });
}

void RasterTracker::apply(const base::RasterState& state) {
    applyFaces(state);
    applyDepth(state);
    applyStencil(state);
    applyBlending(state);
    applyWriteMasks(state.write);
    applySamples(state);
    applyRectangles(state);
    applySizes(state);
}

void RasterTracker::openForClears() {
    enable(known_.discard, GL_RASTERIZER_DISCARD, false);  // it also stops clears
    change(known_.depthWrite, true, [] { glDepthMask(GL_TRUE); });
    applyWriteMasks({});
    base::StencilFace front = known_.stencilFront.value_or(base::StencilFace{});
    base::StencilFace back = known_.stencilBack.value_or(base::StencilFace{});
    front.writeMask = back.writeMask = ~0U;
    applyStencilFace(GL_FRONT, known_.stencilFront, front);
    applyStencilFace(GL_BACK, known_.stencilBack, back);
    applyScissor(limit_);
}

void RasterTracker::applyFaces(const base::RasterState& state) {
    enable(known_.cullOn, GL_CULL_FACE, state.cull != base::Cull::off);
    if (state.cull != base::Cull::off) {
        const GLenum face = faceOf(state.cull);
        change(known_.cullFace, face, [&] { glCullFace(face); });
    }
    const GLenum front = state.front == base::Winding::cw ? GL_CW : GL_CCW;
    change(known_.frontFace, front, [&] { glFrontFace(front); });
    const GLenum mode = modeOf(state.polygon);
    change(known_.polygonMode, mode, [&] { glPolygonMode(GL_FRONT_AND_BACK, mode); });
    const GLenum provoking = state.provoking == base::ProvokingVertex::first ? GL_FIRST_VERTEX_CONVENTION
                                                                             : GL_LAST_VERTEX_CONVENTION;
    change(known_.provoking, provoking, [&] { glProvokingVertex(provoking); });

    enable(known_.discard, GL_RASTERIZER_DISCARD, state.discard);

    const double sign = state.depthOrder == base::DepthOrder::usual ? 1 : -1;
    const std::array offset{static_cast<float>(sign * state.offsetFactor),
                            static_cast<float>(sign * state.offsetUnits)};
    const bool offsets = offset[0] != 0 || offset[1] != 0;
    change(known_.offsetOn, offsets, [&] {
        for (const GLenum each : std::initializer_list<GLenum>{GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE,
                                                               GL_POLYGON_OFFSET_POINT})
            offsets ? glEnable(each) : glDisable(each);
    });
    if (offsets) change(known_.offset, offset, [&] { glPolygonOffset(offset[0], offset[1]); });
}

void RasterTracker::applyDepth(const base::RasterState& state) {
    const bool isUsual = state.depthOrder == base::DepthOrder::usual;
    enable(known_.depthTest, GL_DEPTH_TEST, state.depthTest);
    if (state.depthTest) {
        const GLenum function =
            glFunction(isUsual ? state.depthFunction : base::mirrored(state.depthFunction));
        change(known_.depthFunction, function, [&] { glDepthFunc(function); });
    }
    change(known_.depthWrite, state.depthWrite, [&] { glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE); });
    enable(known_.depthClamp, GL_DEPTH_CLAMP, state.depthClamp);
    const std::array range{isUsual ? state.depthNear : 1 - state.depthFar,
                           isUsual ? state.depthFar : 1 - state.depthNear};
    change(known_.depthRange, range, [&] { glDepthRange(range[0], range[1]); });
    const bool fromZero = state.depthOrder == base::DepthOrder::reversed && capabilities_->clipControl;
    if (std::exchange(clipsFromZero_, fromZero) != fromZero)
        glClipControl(GL_LOWER_LEFT, fromZero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

void RasterTracker::applyStencil(const base::RasterState& state) {
    enable(known_.stencilTest, GL_STENCIL_TEST, state.stencilTest);
    if (!state.stencilTest) return;
    applyStencilFace(GL_FRONT, known_.stencilFront, state.stencilFront);
    applyStencilFace(GL_BACK, known_.stencilBack, state.stencilBack);
}

void RasterTracker::applyStencilFace(GLenum face, std::optional<base::StencilFace>& known,
                                     const base::StencilFace& wanted) {
    if (!known || known->function != wanted.function || known->reference != wanted.reference ||
        known->mask != wanted.mask)
        glStencilFuncSeparate(face, glFunction(wanted.function), wanted.reference, wanted.mask);
    if (!known || known->fail != wanted.fail || known->depthFail != wanted.depthFail ||
        known->pass != wanted.pass)
        glStencilOpSeparate(face, glAction(wanted.fail), glAction(wanted.depthFail), glAction(wanted.pass));
    if (!known || known->writeMask != wanted.writeMask) glStencilMaskSeparate(face, wanted.writeMask);
    known = wanted;
}

void RasterTracker::applyBlending(const base::RasterState& state) {
    std::array<bool, kRasterTargets> on{};
    for (std::size_t i = 0; i < kRasterTargets; ++i) on[i] = state.blend[i].isOn;
    if (!known_.blendOn || (*known_.blendOn != on && allEqual(on))) {
        on[0] ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
        known_.blendOn.emplace().fill(on[0]);
    }
    for (std::size_t i = 0; i < kRasterTargets; ++i) {
        if ((*known_.blendOn)[i] == on[i]) continue;
        on[i] ? glEnablei(GL_BLEND, static_cast<GLuint>(i)) : glDisablei(GL_BLEND, static_cast<GLuint>(i));
        (*known_.blendOn)[i] = on[i];
    }

    // Functions of targets that do not blend stay as they are.
    using Functions = std::array<base::BlendFunction, 2>;
    const auto functions = [&](std::size_t i) {
        return Functions{state.blend[i].color, state.blend[i].alpha};
    };
    const auto isSet = [&](std::size_t i) { return !on[i] || known_.blend[i] == functions(i); };
    const bool isShared = allEqual(state.blend);
    for (std::size_t i = 0; i < kRasterTargets; ++i) {
        if (isSet(i)) continue;
        const auto& [color, alpha] = functions(i);
        const bool sameEquation = known_.blend[i] && (*known_.blend[i])[0].equation == color.equation &&
                                  (*known_.blend[i])[1].equation == alpha.equation;
        const auto target = static_cast<GLuint>(i);
        if (isShared) {
            glBlendFuncSeparate(glFactor(color.source), glFactor(color.destination), glFactor(alpha.source),
                                glFactor(alpha.destination));
            glBlendEquationSeparate(glEquation(color.equation), glEquation(alpha.equation));
            known_.blend.fill(functions(i));
            break;
        }
        glBlendFuncSeparatei(target, glFactor(color.source), glFactor(color.destination),
                             glFactor(alpha.source), glFactor(alpha.destination));
        if (!sameEquation)
            glBlendEquationSeparatei(target, glEquation(color.equation), glEquation(alpha.equation));
        known_.blend[i] = functions(i);
    }
    std::array<float, 4> constant{};
    for (std::size_t i = 0; i < constant.size(); ++i)
        constant[i] = static_cast<float>(state.blendConstant[i]);
    if (std::ranges::find(on, true) != on.end())
        change(known_.blendConstant, constant,
               [&] { glBlendColor(constant[0], constant[1], constant[2], constant[3]); });
}

void RasterTracker::applyWriteMasks(const std::array<base::ColorMask, kRasterTargets>& masks) {
    const auto gl = [](bool on) { return static_cast<GLboolean>(on ? GL_TRUE : GL_FALSE); };
    if (!known_.write || (*known_.write != masks && allEqual(masks))) {
        const base::ColorMask& all = masks.front();
        glColorMask(gl(all.red), gl(all.green), gl(all.blue), gl(all.alpha));
        known_.write.emplace().fill(all);
    }
    for (std::size_t i = 0; i < kRasterTargets; ++i) {
        const base::ColorMask& mask = masks[i];
        if ((*known_.write)[i] == mask) continue;
        glColorMaski(static_cast<GLuint>(i), gl(mask.red), gl(mask.green), gl(mask.blue), gl(mask.alpha));
        (*known_.write)[i] = mask;
    }
}

void RasterTracker::applySamples(const base::RasterState& state) {
    enable(known_.multisample, GL_MULTISAMPLE, state.multisample);
    enable(known_.alphaToCoverage, GL_SAMPLE_ALPHA_TO_COVERAGE, state.alphaToCoverage);
    enable(known_.sampleShadingOn, GL_SAMPLE_SHADING, state.sampleShading > 0);
    const auto fraction = static_cast<float>(state.sampleShading);
    if (fraction > 0) change(known_.sampleShading, fraction, [&] { glMinSampleShading(fraction); });
}

void RasterTracker::applyRectangles(const base::RasterState& state) {
    const std::array<int, 4> viewport = asArray(pixelsOf(state.viewport, width_, height_));
    change(known_.viewport, viewport,
           [&] { glViewport(viewport[0], viewport[1], viewport[2], viewport[3]); });
    std::optional<PixelRectangle> scissor = limit_;
    if (state.scissor) {
        scissor = pixelsOf(*state.scissor, width_, height_);
        if (limit_) scissor = intersection(*scissor, *limit_);
    }
    drawn_ = scissor;
    applyScissor(scissor);
}

PixelRectangle RasterTracker::drawnPixels() const {
    const PixelRectangle all{0, 0, width_, height_};
    return drawn_ ? intersection(*drawn_, all) : all;
}

void RasterTracker::narrowTo(const PixelRectangle& pixels) {
    applyScissor(intersection(drawnPixels(), pixels));
}

void RasterTracker::applyScissor(const std::optional<PixelRectangle>& pixels) {
    enable(known_.scissorOn, GL_SCISSOR_TEST, pixels.has_value());
    if (!pixels) return;
    change(known_.scissor, asArray(*pixels),
           [&] { glScissor(pixels->x, pixels->y, pixels->width, pixels->height); });
}

void RasterTracker::applySizes(const base::RasterState& state) {
    const double widest = capabilities_->widestLine();
    const auto width = static_cast<float>(
        std::clamp(roundedUpAtHalf(state.lineWidth), std::min(capabilities_->minLineWidth, widest), widest));
    change(known_.lineWidth, width, [&] { glLineWidth(width); });
    enable(known_.programPointSize, GL_PROGRAM_POINT_SIZE, state.pointSizeFromShader);
    if (state.pointSizeFromShader) return;
    const auto size = static_cast<float>(
        std::clamp(state.pointSize, capabilities_->minPointSize, capabilities_->maxPointSize));
    change(known_.pointSize, size, [&] { glPointSize(size); });
}

}  // namespace glibra::gpu
