#include "view/window/panels/texel_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/theme.h"

namespace glibra::view {

ImTextureID idOf(const gpu::Texture& texture) {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

std::optional<gpu::Texture> textureOfBytes(const gpu::Capabilities& capabilities, int width, int height,
                                           std::span<const std::byte> bytes, GLint minified, GLint magnified,
                                           int components) {
    Result<gpu::Texture> made =
        gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {width, height, 1}, {bytes, components});
    if (!made) return std::nullopt;
    glBindTexture(GL_TEXTURE_2D, made->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minified);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnified);
    return std::move(made.value);
}

namespace {

constexpr float kNearest = 64, kFarthest = .02F;  // zoom

std::string named(std::string_view name, const char* widget) {
    return fmt::format("{}/{}", name, widget);
}

void displaySettings(Ui& ui, TexelView& view, std::string_view name) {
    ImGui::PushItemWidth(72 * ui.shared.scale);
    int channels = static_cast<int>(view.display.channels);
    if (ImGui::Combo("##channels", &channels, "RGB\0red\0green\0blue\0alpha\0"))
        view.display.channels = static_cast<Channels>(channels);
    mark(ui, named(name, "channels"));
    ImGui::SameLine();
    const auto bound = [&](const char* label, const char* widget, double& value) {
        wordBefore(label);
        numberEntry(fmt::format("##{}", widget).c_str(), value, "%.5g");
        mark(ui, named(name, widget));
        ImGui::SameLine();
    };
    bound("black", "low", view.display.low);
    bound("white", "high", view.display.high);
    if (button(ui, "Fit range", named(name, "fitRange"),
               "Black is the least value of the shown channels, white the largest"))
        view.wantsRange = true;
    besideIfRoom(ImGui::CalcTextSize("0..1").x + 2 * ImGui::GetStyle().FramePadding.x);
    if (button(ui, "0..1", named(name, "unitRange"))) view.display.low = 0, view.display.high = 1;
    ImGui::PopItemWidth();
    besideIfRoom(ImGui::GetFrameHeight() + ImGui::CalcTextSize("GLSL").x +
                 2 * ImGui::GetStyle().ItemSpacing.x);
    checkBox(ui, "GLSL", named(name, "glsl"), view.asksForExpression,
             "Show what an expression of GLSL makes of each texel, such as color.rgb * 10");
}

/// The expression that the texels are shown by. It is computed when its text or the content has changed.
void display(Ui& ui, TexelView& view, const render::Content& content, std::string_view name) {
    if (view.asksForExpression) {
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##expression", "color.rgb * 10    color, near(1, 0), texel, st, size",
                                 view.expression.data(), view.expression.size());
        mark(ui, named(name, "expression"));
    }
    const std::string wanted = view.asksForExpression ? view.expression.data() : "";
    if (wanted != view.displayedFor) {
        view.displayedFor = wanted;
        view.displayed = wanted.find_first_not_of(' ') == std::string::npos
                             ? Displayed{}
                             : displayedBy(ui.context, content, wanted);
        view.shown.reset();
    }
    if (view.displayed.problem.empty()) return;
    wrappedText(palette().error, view.displayed.problem.c_str());
    markPlace(ui, named(name, "expressionProblem"));
}

std::string texelText(const render::Content& content, std::size_t column, std::size_t row) {
    std::string text = fmt::format("{}, {}:", column, row);
    for (const double each : content.at(row * static_cast<std::size_t>(content.width) + column)) {
        // Integers up to 2^32 with all their digits.
        const bool isWhole = each == std::trunc(each) && std::abs(each) < 1e10;
        text += isWhole ? fmt::format(" {:.0f}", each) : fmt::format(" {:.6g}", each);
    }
    return text;
}

/// The wheel zooms about the texel under the mouse. Call it before the image, whose size limits how far the
/// next frame can be scrolled.
void zoomImage(TexelView& view, const ImVec2& at) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0 || !ImGui::IsWindowHovered()) return;
    float& zoom = view.zoom;
    view.fits = false;
    const float before = zoom;
    zoom = std::clamp(zoom * std::pow(1.2F, io.MouseWheel), kFarthest, kNearest);
    const float more = zoom / before - 1;
    ImGui::SetScrollX(ImGui::GetScrollX() + (io.MousePos.x - at.x) * more);
    ImGui::SetScrollY(ImGui::GetScrollY() + (io.MousePos.y - at.y) * more);
}

/// Dragging moves the image; a click without it chooses a texel.
bool panImage(TexelView& view) {
    const ImVec2& moved = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemActivated()) view.isDragged = false;
    if (ImGui::IsItemActive()) {
        view.isDragged = view.isDragged || ImGui::IsMouseDragging(ImGuiMouseButton_Left, 4);
        ImGui::SetScrollX(ImGui::GetScrollX() - moved.x);
        ImGui::SetScrollY(ImGui::GetScrollY() - moved.y);
    }
    return ImGui::IsItemDeactivated() && !view.isDragged && ImGui::IsItemHovered();
}

void sizeSettings(Ui& ui, TexelView& view, const render::Content& content, std::string_view name) {
    if (button(ui, "Fit", named(name, "fit"))) view.fits = true;
    ImGui::SameLine();
    if (button(ui, "1:1", named(name, "actualSize"))) view.fits = false, view.zoom = 1;
    ImGui::SameLine();
    wordBefore("zoom");
    ImGui::SetNextItemWidth(110 * ui.shared.scale);
    double zoom = static_cast<double>(view.zoom);
    if (labelledSlider(ui, "##zoom", named(name, "zoom").c_str(), {kFarthest, kNearest, false, true}, zoom)) {
        view.fits = false;
        view.zoom = static_cast<float>(zoom);
    }
    ImGui::SameLine();
    const std::string size = fmt::format("{} x {}", content.width, content.height);
    besideIfRoom(ImGui::CalcTextSize(size.c_str()).x);
    ImGui::TextUnformatted(
        shortened(view.hovered.empty() ? size : size + "   " + view.hovered, ImGui::GetContentRegionAvail().x)
            .c_str());
    const NonFiniteTexels bad = countNonFinite(content);
    if (bad.nan + bad.infinite > 0)
        ImGui::TextColored({1, .4F, .9F, 1}, "%d texels are NaN (magenta), %d infinite (cyan)", bad.nan,
                           bad.infinite);
}

void ringMarked(const Ui& ui, const TexelView& view, const render::Content& content, const ImVec2& at) {
    const ImVec2 middle(
        at.x + (static_cast<float>(view.marked->first) + .5F) * view.zoom,
        at.y + (static_cast<float>(content.height - 1 - view.marked->second) + .5F) * view.zoom);
    ring(ui, *ImGui::GetWindowDrawList(), middle, std::max(6 * ui.shared.scale, view.zoom));
}

void upload(Ui& ui, TexelView& view, const TexelSource& source, const render::Content& content) {
    if (std::exchange(view.wantsRange, false))
        std::tie(view.display.low, view.display.high) = rangeOf(content, view.display.channels);
    if (view.shown && view.shownDisplay == view.display) return;
    view.shown =
        textureOfTexels(ui, content.width, content.height,
                        source.colors != nullptr ? *source.colors : screenBytes(content, view.display));
    view.shownDisplay = view.display;
}

}  // namespace

void TexelView::begin(bool withOwnRange) {
    fits = true;
    wantsRange = withOwnRange;
    display = {};
    shown.reset();
    marked.reset();
}

void drawTexture(const gpu::Texture& texture, const std::array<float, 4>& at) {
    ImGui::GetWindowDrawList()->AddImage(idOf(texture), {at[0], at[1]}, {at[0] + at[2], at[1] + at[3]},
                                         {0, 1}, {1, 0});
}

std::optional<gpu::Texture> textureOfTexels(const Ui& ui, int width, int height,
                                            std::span<const std::uint8_t> rgba) {
    return textureOfBytes(ui.context.capabilities(), width, height, std::as_bytes(rgba), GL_LINEAR,
                          GL_NEAREST);
}

void texelView(Ui& ui, TexelView& view, const TexelSource& source, std::string_view name) {
    view.clicked.reset();
    if (source.colors == nullptr) {
        displaySettings(ui, view, name);
        display(ui, view, source.content, name);
    }
    const bool isComputed = source.colors == nullptr && view.displayed.content;
    const render::Content& content = isComputed ? *view.displayed.content : source.content;
    upload(ui, view, source, content);
    if (!view.shown) return;
    sizeSettings(ui, view, content, name);
    const auto width = static_cast<float>(content.width), height = static_cast<float>(content.height);
    if (view.fits) {
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float border = 2 * ImGui::GetStyle().WindowPadding.x;
        view.zoom =
            std::clamp(std::min((room.x - border) / width, (room.y - border) / height), kFarthest, kNearest);
    }
    ImGui::BeginChild("image", {0, 0}, true,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    zoomImage(view, at);
    const ImVec2 size(std::max(1.F, width * view.zoom), std::max(1.F, height * view.zoom));
    ImGui::InvisibleButton("texels", size);
    mark(ui, named(name, "image"));
    drawTexture(*view.shown, {at.x, at.y, size.x, size.y});
    if (source.overlay != nullptr) drawTexture(*source.overlay, {at.x, at.y, size.x, size.y});
    if (view.marked) ringMarked(ui, view, content, at);
    view.hovered.clear();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const int x = std::clamp(static_cast<int>((mouse.x - at.x) / view.zoom), 0, content.width - 1);
    const int y = content.height - 1 -
                  std::clamp(static_cast<int>((mouse.y - at.y) / view.zoom), 0, content.height - 1);
    if (ImGui::IsItemHovered()) {
        view.hovered = source.words
                           ? fmt::format("{}, {}: {}", x, y, source.words(x, y))
                           : texelText(content, static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        ImGui::SetTooltip("%s", view.hovered.c_str());
    }
    if (panImage(view)) view.clicked = std::pair(x, y);
    ImGui::EndChild();
}

}  // namespace glibra::view
