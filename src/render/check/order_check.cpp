#include "render/check/order_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/text.h"
#include "plan/accesses.h"
#include "render/check/object_content.h"
#include "render/consequences.h"
#include "render/scene_state.h"
#include "render/simulation/block_checks.h"

namespace glibra::render {
namespace {

/// A texture or buffer that a node writes.
struct Written {
    scene::ObjectView object;
    std::string word;  ///< of the statement
    Place place;
};

/// What a scene has made at a time.
struct Made {
    image::Image picture;
    std::vector<Written> written;                  ///< in the order in which they are first written
    std::vector<std::optional<Content>> contents;  ///< of `written`; nothing: it cannot be read
    std::vector<bool> areWanted;                   ///< the scene expects or prints something of it
    Place storing;                                 ///< the first statement that stores in what it reads
};

scene::ObjectView wholeOf(const scene::ObjectView& view) {
    if (const auto* buffer = std::get_if<scene::BufferView>(&view)) return scene::BufferView{buffer->buffer};
    return scene::TextureView{.texture = std::get<scene::TextureView>(view).texture};
}

/// The first statement whose shaders store in what they also read; nothing if there is none.
std::optional<Place> storingPlace(const Conductor& conductor) {
    for (const plan::FramePlan* plan : conductor.plans())
        for (std::size_t node = 0; node < plan->accesses.size(); ++node)
            if (std::ranges::any_of(plan->accesses[node].uses,
                                    [](const plan::ObjectUse& each) { return each.stores && each.reads; }))
                return plan->placeOf(plan->order[node]);
    return std::nullopt;
}

std::vector<Written> writtenBy(const Conductor& conductor) {
    std::vector<const plan::FramePlan*> plans = conductor.plans();
    std::ranges::rotate(plans, plans.begin() + 1);  // the frame comes last
    std::vector<Written> all;
    for (const plan::FramePlan* plan : plans)
        for (std::size_t node = 0; node < plan->accesses.size(); ++node)
            for (const plan::ObjectUse& use : plan->accesses[node].uses) {
                const auto isSame = [&](const Written& each) {
                    return plan::objectOf(each.object) == plan::objectOf(use.object);
                };
                if (!use.writes || std::ranges::any_of(all, isSame)) continue;
                const bool isDispatch = plan->order[node].kind == scene::NodeIndex::Kind::dispatch;
                all.push_back({wholeOf(use.object), isDispatch ? "Dispatch" : "the pass",
                               plan->placeOf(plan->order[node])});
            }
    return all;
}

/// True if the scene expects or prints something of the object.
bool isWanted(const scene::Scene& scene, const plan::Object& object) {
    const auto looksAtIt = [&](const auto& statement) {
        return std::ranges::any_of(statement.objects(), [&](const scene::ObjectView& each) {
            return plan::objectOf(each) == object;
        });
    };
    return std::ranges::any_of(scene.prints, looksAtIt) || std::ranges::any_of(scene.checks, looksAtIt);
}

/// Nothing if the scene cannot be drawn, or does not depend on the order.
std::optional<Made> make(gpu::Context& context, const std::filesystem::path& path,
                         const RenderOptions& options, bool isReversed) {
    Stats stats;
    Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    if (!interpreted) return std::nullopt;
    auto state = SceneState::of(context, std::move(*interpreted), options, stats, nullptr);
    if (!state) return std::nullopt;
    Conductor& conductor = (*state)->conductor;
    if (!isReversed) {  // most scenes store nothing, and need not be compiled to know it
        bool stores = false;
        for (const scene::ProgramIndex each : conductor.scene.programs.indices())
            stores = stores || conductor.programs.mayWriteImages(each);
        if (!stores) return std::nullopt;
    }
    if (isReversed) conductor.programs.reverseOrder();
    Diagnostics diagnostics = conductor.prepare((*state)->request());
    if (hasError(diagnostics) || !mayDependOnOrder(conductor) || !(*state)->makeReady(diagnostics))
        return std::nullopt;
    Result<image::Image> picture = (*state)->draw(options.time, stats);
    if (!picture) return std::nullopt;
    Made made{std::move(*picture), writtenBy(conductor), {}, {}, storingPlace(conductor).value_or(Place{})};
    for (const Written& each : made.written) {
        Result<Content> content = contentOf(conductor, each.object);
        made.contents.push_back(std::move(content.value));
        made.areWanted.push_back(isWanted(conductor.scene, plan::objectOf(each.object)));
    }
    return made;
}

/// The differing values of two contents, and the element of the first.
struct Difference {
    std::size_t values = 0, first = 0;
};
Difference differenceOf(const Content& a, const Content& b) {
    Difference found;
    const std::size_t count = std::min(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (std::bit_cast<std::uint64_t>(a.values[i]) == std::bit_cast<std::uint64_t>(b.values[i])) continue;
        if (found.values++ == 0) found.first = i / static_cast<std::size_t>(std::max(1, a.components));
    }
    return found;
}

std::size_t differingPixels(const image::Image& a, const image::Image& b) {
    const std::size_t pixel = a.rowBytes() / static_cast<std::size_t>(std::max(1, a.width));
    std::size_t count = 0;
    for (std::size_t at = 0; at + pixel <= std::min(a.data.size(), b.data.size()); at += pixel)
        count += std::memcmp(a.data.data() + at, b.data.data() + at, pixel) != 0 ? 1 : 0;
    return count;
}

}  // namespace

bool mayDependOnOrder(const Conductor& conductor) {
    return storingPlace(conductor).has_value();
}

Diagnostics checkOrder(gpu::Context& context, const std::filesystem::path& scene,
                       const RenderOptions& options) {
    RenderOptions kept = options;
    kept.checks = true;
    kept.checkNan = true;  // every texture keeps its content
    kept.strict = false;
    const std::optional<Made> one = make(context, scene, kept, false);
    if (!one) return {};
    const std::optional<Made> other = make(context, scene, kept, true);
    if (!other || other->written.size() != one->written.size()) return {};
    std::optional<std::size_t> first;
    std::vector<std::string> results;  // what differs and is seen
    const std::size_t pixels = differingPixels(one->picture, other->picture);
    if (pixels > 0) results.push_back(base::counted(pixels, "pixel") + " of the picture");
    Difference shown;
    for (std::size_t i = 0; i < one->written.size(); ++i) {
        if (!one->contents[i] || !other->contents[i]) continue;
        const Difference found = differenceOf(*one->contents[i], *other->contents[i]);
        if (found.values == 0) continue;
        if (!first) {
            first = i;
            shown = found;
        } else if (one->areWanted[i]) {
            results.push_back("'" + one->contents[i]->name + "'");
        }
    }
    if (!first && pixels == 0) return {};
    const bool isSeen = !results.empty() || (first && one->areWanted[*first]);
    const char* const id = isSeen ? "memory-W07" : "memory-N01";
    Diagnostics found;
    if (!first) {
        found.push_back(
            diagnose(id,
                     fmt::format("{} with the order in which the invocations of shaders run, which "
                                 "is open",
                                 results.front() + (pixels == 1 ? " differs" : " differ")),
                     one->storing));
    } else {
        const Written& written = one->written[*first];
        const Content& content = *one->contents[*first];
        found.push_back(diagnose(
            id,
            fmt::format("{}: '{}' depends on the order in which invocations run, which is open: in another "
                        "order {} of its {} values {}, the first in element {}{}",
                        written.word, content.name, base::groupedText(static_cast<long long>(shown.values)),
                        base::groupedText(static_cast<long long>(content.values.size())),
                        shown.values == 1 ? "differs" : "differ", shown.first,
                        results.empty() ? isSeen ? "" : ", but the picture does not"
                                        : ", and so do " + fmt::format("{}", fmt::join(results, ", "))),
            written.place));
    }
    applyStrict(found, options.strict);
    return found;
}

}  // namespace glibra::render
