#include "render/check/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/text.h"
#include "gpu/object/readback.h"
#include "gpu/object/timer.h"
#include "plan/accesses.h"
#include "render/check/answers.h"
#include "render/check/nan_search.h"
#include "render/check/object_content.h"
#include "render/consequences.h"
#include "render/scene_state.h"
#include "render/simulation/block_checks.h"
#include "scene/scene.h"

namespace glibra::render {
namespace {

// Which Expect statements of a scene still have to be answered, and at which times (language, 12.9).

/// The checks that a scene has at the time of its picture. Each is answered once, at the time that it had
/// then: what its statement says at that time counts, and if it does not run there, what it said here.
class OpenChecks {
  public:
    /// `scene`: as it is at `time`, that of the picture.
    OpenChecks(const scene::Scene& scene, double time);

    /// That of the picture.
    [[nodiscard]] double time() const { return time_; }
    /// The times of pictures to look at, at least one: those of the checks, and those that statements name
    /// which have not run.
    [[nodiscard]] const std::set<double>& times() const { return times_; }
    /// The checks to answer at `moment`, which count as answered from now on. `there` are those of the scene
    /// at that moment; those that ask for it and were not there before are answered too.
    std::vector<scene::Check> take(double moment, const std::vector<scene::Check>& there);

    [[nodiscard]] const std::vector<scene::Check>& all() const { return all_; }
    [[nodiscard]] bool isAnswered() const { return open_.empty(); }
    /// Those that take() has not returned, and those of the kind `error`.
    [[nodiscard]] std::vector<scene::Check> unanswered() const;
    /// The statements that have never run.
    [[nodiscard]] const std::vector<scene::IdleCheck>& idle() const { return idle_; }

  private:
    [[nodiscard]] double timeOf(const scene::Check& check) const { return check.seconds.value_or(time_); }

    double time_;
    std::vector<scene::Check> all_, open_;
    std::vector<scene::IdleCheck> idle_;
    std::set<double> times_;
};

using scene::Check;

OpenChecks::OpenChecks(const scene::Scene& scene, double time)
    : time_(time), all_(scene.checks), idle_(scene.idleChecks) {
    for (const Check& each : all_)
        if (each.kind != Check::Kind::error) open_.push_back(each);
    for (const Check& each : open_) {
        times_.insert(timeOf(each));
        for (const double seconds : each.times()) times_.insert(seconds);
    }
    for (const scene::IdleCheck& each : idle_)
        if (each.seconds) times_.insert(*each.seconds);
    if (times_.empty()) times_.insert(time);
}

std::vector<Check> OpenChecks::take(double moment, const std::vector<Check>& there) {
    std::vector<Check> taken;
    const auto laterOf = [&](const Check& check) {
        const auto found = std::ranges::find_if(there, [&](const Check& each) { return each.isSame(check); });
        return found != there.end() && found->kind == check.kind ? *found : check;
    };
    for (const Check& each : open_)
        if (timeOf(each) == moment) taken.push_back(laterOf(each));
    std::erase_if(open_, [&](const Check& each) { return timeOf(each) == moment; });
    for (const Check& each : there) {
        const auto isSame = [&](const Check& other) { return other.isSame(each); };
        if (each.kind == Check::Kind::error || !each.seconds || *each.seconds != moment ||
            std::ranges::any_of(all_, isSame))
            continue;
        taken.push_back(each);
        all_.push_back(each);
        std::erase_if(idle_, [&](const scene::IdleCheck& other) { return other.place == each.place; });
    }
    return taken;
}

std::vector<Check> OpenChecks::unanswered() const {
    std::vector<Check> checks = open_;
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(checks),
                 [](const Check& each) { return each.kind == Check::Kind::error; });
    return checks;
}

Content windowContent(const SceneState& state, std::vector<std::byte> pixels) {
    Content content{
        "window", state.width, state.height, 1, 4, state.conductor.options.floatPixels ? 0 : 1.0 / 255, {}};
    content.values.resize(content.size() * 4);
    const std::size_t row = static_cast<std::size_t>(state.width) * 4;
    const auto* floats = reinterpret_cast<const float*>(pixels.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(state.height); ++y)  // the top row comes first
        std::copy_n(floats + y * row, row,
                    content.values.begin() +
                        static_cast<std::ptrdiff_t>((static_cast<std::size_t>(state.height) - 1 - y) * row));
    return content;
}

Result<Content> readWindow(SceneState& state) {
    if (state.tiles.size() > 1)
        return diagnose("check-E02", "a picture that is drawn in tiles cannot be checked",
                        {state.conductor.scene.path, 1, 1});
    auto pixels = gpu::readPixels(state.conductor.context.capabilities(), state.window->readable(), 0,
                                  {0, 0, state.width, state.height}, {4, gpu::TexelType::f32});
    if (!pixels) return std::move(pixels.diagnostics);
    return windowContent(state, std::move(*pixels));
}

bool hasMessage(const Diagnostics& all, const Diagnostic& one) {
    return std::ranges::any_of(all, [&](const Diagnostic& each) {
        return each.id == one.id && each.text == one.text && each.place == one.place;
    });
}

/// Fills in what an expression reads, at this moment. `measured`: what its calls give.
void fill(scene::ConditionNames& names, Contents& contents,
          const std::function<scene::Measured(const scene::Measure& measure)>& measured) {
    names.readBuffers([&](const scene::BufferView& buffer) {
        const auto content = contents.of({.object = buffer});
        return content ? (*content)->values : std::vector<double>();
    });
    names.measure(measured);
}

Diagnostics printedBy(const scene::Print& print, Contents& contents) {
    if (print.value.expression != nullptr) {
        scene::ConditionNames names = *print.value.names;
        fill(names, contents, [&](const scene::Measure& each) { return contents.measured(each); });
        const Result<scene::Answer> value = scene::answerTo(*print.value.expression, names, print.place.file);
        if (!value) return value.diagnostics;
        return {diagnose("check-N02", fmt::format("{}: {}", print.name, value->text), print.place)};
    }
    scene::Selection of = print.of;
    const bool isBuffer = of.object && std::holds_alternative<scene::BufferView>(*of.object);
    if (isBuffer && !of.area.empty()) {  // what the buffer does not have is left out
        const auto whole = contents.of({.object = of.object});
        const double count = whole ? static_cast<double>((*whole)->size()) : 0;
        if (whole && of.area[0] >= count)
            return {diagnose(
                "check-N02",
                fmt::format("Print {}: it has {}", print.name, base::counted((*whole)->size(), "element")),
                print.place)};
        if (whole) of.area[1] = std::min(of.area[1], count - 1);
    }
    auto content = contents.of(of);
    if (content) return printedElements(print, **content);
    for (Diagnostic& each : content.diagnostics) {
        each.text = fmt::format("Print {}: {}", print.name, each.text);
        each.place = print.place;
    }
    return std::move(content.diagnostics);
}

Diagnostics printedBy(SceneState& state, Contents& contents) {
    Diagnostics notes;
    for (const scene::Print& each : state.conductor.scene.prints) append(notes, printedBy(each, contents));
    return notes;
}

/// Conditions that look at several times: what they measure at each, until all of it is known.
class Conditions {
  public:
    /// Measures what the checks ask for at this moment. `now`: those that are answered at it.
    void measure(double moment, std::span<const Check> all, std::span<const Check> now, Contents& contents) {
        const auto add = [&](std::span<const Check> checks, bool areNow) {
            for (const Check& each : checks)
                if (each.condition.names)
                    for (scene::Measure measure : each.condition.names->measures())
                        if (measure.seconds.value_or(areNow ? moment : -1) == moment) {
                            measure.seconds = moment;
                            if (find(measure) == nullptr)
                                known_.emplace_back(measure, contents.measured(measure));
                        }
        };
        add(all, false);
        add(now, true);
    }
    /// The names of a condition that is answered for `moment`, with what is known.
    [[nodiscard]] scene::ConditionNames namesOf(const Check& check, double moment, Contents& contents) const {
        scene::ConditionNames names = *check.condition.names;
        fill(names, contents, [&](scene::Measure measure) {
            if (!measure.seconds) measure.seconds = moment;
            const scene::Measured* const found = find(measure);
            if (found != nullptr) return *found;
            return scene::Measured{
                {}, {}, fmt::format("no picture was drawn for it at {}", *measure.seconds)};
        });
        return names;
    }
    struct Waiting {
        Check check;
        double moment = 0;            ///< that it is answered for
        double last = 0;              ///< the latest time that it looks at
        scene::ConditionNames names;  ///< with the elements of buffers
    };
    std::vector<Waiting> waiting;
    /// Fills in what has been measured since.
    void complete(Waiting& one) const {
        one.names.measure([&](scene::Measure measure) {
            if (!measure.seconds) measure.seconds = one.moment;
            const scene::Measured* const found = find(measure);
            return found != nullptr ? *found : scene::Measured{};
        });
    }

  private:
    [[nodiscard]] const scene::Measured* find(const scene::Measure& measure) const {
        const auto found =
            std::ranges::find_if(known_, [&](const auto& each) { return each.first == measure; });
        return found != known_.end() ? &found->second : nullptr;
    }
    std::vector<std::pair<scene::Measure, scene::Measured>> known_;
};

/// Draws the picture of `moment` and answers the checks that ask for it. What drawing reports comes first.
Diagnostics answerAt(SceneState& state, double moment, OpenChecks& open, Conditions& conditions,
                     Stats& stats) {
    Conductor& conductor = state.conductor;
    const auto isCounted = [](const scene::Check& each) {
        return each.kind == scene::Check::Kind::primitives || each.kind == scene::Check::Kind::samples;
    };
    // What Once and Step draw is not counted, so they run before.
    Diagnostics wrong;
    const bool counts = std::ranges::any_of(conductor.scene.checks, isCounted);
    if (counts) {
        Result<image::Image> before = state.draw(moment, stats);
        append(wrong, std::move(before.diagnostics));
        if (!before) return wrong;
    }
    conductor.forgetDrawn();  // all nodes count
    conductor.drawer->setCounted(counts);
    const gpu::Query primitives(GL_PRIMITIVES_GENERATED), samples(GL_SAMPLES_PASSED);
    primitives.begin();
    samples.begin();
    Result<image::Image> picture = state.draw(moment, stats);
    samples.end();
    primitives.end();
    if (conductor.drawer) conductor.drawer->setCounted(false);
    append(wrong, std::move(picture.diagnostics));
    if (!picture) return wrong;
    Contents contents(conductor, [&] { return readWindow(state); });
    scene::ConditionNames names;
    const CheckQuestions questions{
        contents, [&] { return primitives.result(); }, [&] { return samples.result(); },
        [&](const Check& check) {
            return scene::answerTo(*check.condition.expression, names, check.place.file,
                                   {.types = scene::kConditionTypes});
        }};
    if (moment == open.time()) append(wrong, printedBy(state, contents));
    const std::vector<Check> taken = open.take(moment, conductor.scene.checks);
    conditions.measure(moment, open.all(), taken, contents);
    conditions.measure(moment, conductor.scene.checks, {}, contents);
    const auto answerOne = [&](const Check& check) {
        if (std::optional<Diagnostic> found = answer(check, questions)) wrong.push_back(std::move(*found));
    };
    for (const Check& each : taken) {
        if (each.condition.names) {
            names = conditions.namesOf(each, moment, contents);
            double last = moment;
            for (const scene::Measure& measure : names.measures())
                last = std::max(last, measure.seconds.value_or(moment));
            if (last > moment) {
                conditions.waiting.push_back({each, moment, last, names});
                continue;
            }
        }
        answerOne(each);
    }
    for (Conditions::Waiting& each : conditions.waiting) {
        if (each.last > moment || each.moment == moment) continue;
        conditions.complete(each);
        names = each.names;
        answerOne(each.check);
    }
    std::erase_if(conditions.waiting,
                  [&](const auto& each) { return each.last <= moment && each.moment != moment; });
    return wrong;
}

/// The checks of a scene that cannot be drawn; empty if it cannot be read.
std::vector<scene::Check> checksOf(const std::filesystem::path& path, const RenderOptions& options) {
    Stats stats;
    Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    if (!interpreted) return {};
    if (!interpreted->source || options.time == interpreted->inputs.time)
        return std::move(interpreted->scene.checks);
    interpreted->inputs.time = options.time;
    return interpreted->source->at(interpreted->inputs).checks;
}

}  // namespace

Diagnostics printed(SceneRenderer& renderer) {
    SceneState& state = renderer.state();
    Contents contents(state.conductor, [&] { return readWindow(state); });
    return printedBy(state, contents);
}

bool hasChecks(const scene::Scene& scene) {
    return !scene.checks.empty() || std::ranges::any_of(scene.idleChecks, [](const scene::IdleCheck& each) {
        return each.seconds.has_value();
    });
}

Diagnostics answerChecks(SceneRenderer& renderer, double time, Diagnostics& reported, Stats& stats) {
    SceneState& state = renderer.state();
    Diagnostics found = state.moveTo(time, stats);
    state.conductor.judge(found);
    OpenChecks open(state.conductor.scene, time);
    Conditions conditions;
    state.conductor.note(found);
    if (!state.conductor.stopsWith(found))
        for (const double each : open.times()) append(found, answerAt(state, each, open, conditions, stats));
    Diagnostics wrong;
    const auto sort = [&](Diagnostics diagnostics) {
        scene::hideTexts(diagnostics, state.conductor.scene.hiddenFiles);
        for (Diagnostic& each : diagnostics) {
            if (each.severity == Severity::error && each.id.starts_with("check-"))
                wrong.push_back(std::move(each));
            else if (!hasMessage(reported, each))
                reported.push_back(std::move(each));
        }
    };
    Diagnostics idle = reportIdle(open.idle());
    state.conductor.judge(idle);
    append(found, std::move(idle));
    sort(std::move(found));
    Diagnostics unexplained = std::exchange(reported, {});
    sort(open.isAnswered() ? withoutExpected(open.all(), std::move(unexplained))
                           : withoutPicture(open.unanswered(), std::move(unexplained)));
    return wrong;
}

Diagnostics answerWithoutPicture(const std::filesystem::path& path, const RenderOptions& options,
                                 Diagnostics reported) {
    return withoutPicture(checksOf(path, options), std::move(reported));
}

Diagnostics runChecks(gpu::Context& context, const std::filesystem::path& path, const RenderOptions& options,
                      Diagnostics known, SharedParts* shared) {
    Stats stats;
    RenderOptions checked = options;
    checked.checks = true;
    Result<SceneRenderer> renderer = SceneRenderer::load(context, path, checked, stats, shared);
    Diagnostics reported = std::move(known);
    for (Diagnostic& each : renderer.diagnostics)
        if (!hasMessage(reported, each)) reported.push_back(std::move(each));
    if (!renderer) return answerWithoutPicture(path, options, std::move(reported));
    Diagnostics wrong = answerChecks(*renderer, options.time, reported, stats);
    append(reported, std::move(wrong));
    const bool isOpen = mayDependOnOrder(renderer->state().conductor);
    renderer.value.reset();  // its memory is needed no longer
    if (isOpen) append(reported, checkOrder(context, path, options));
    if (options.checkNan)
        if (Result<NanSearch> search = NanSearch::load(context, path, options))
            append(reported, search->at(options.time));
    return reported;
}

// ---- Orders of invocations

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
