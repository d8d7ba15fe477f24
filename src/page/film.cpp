#include "page/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>

#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "render/live/knobs.h"
#include "render/live/live_scene.h"
#include "render/load/device_textures.h"
#include "render/scene_renderer.h"

namespace glibra::page {
namespace {

namespace fs = std::filesystem;
using Ordered = nlohmann::ordered_json;
using render::Knob;

constexpr std::size_t kMostStops = 7, kFewestStops = 3;  // of a slider
constexpr std::size_t kMostValues = 36;                  // of all sliders, while each has the fewest at least
constexpr std::size_t kMostComponents = 4;               // of a control
constexpr std::size_t kMostControls = 24;
constexpr double kSeconds = 3, kLongestRound = 4;

/// The period of the timers that the programs read, if it is the same for all.
std::optional<double> periodOf(const plan::FramePlan& plan) {
    std::set<double> periods;
    plan.visitStatements([&](const auto& planned, const auto& statement) {
        for (const plan::UniformBinding& each : plan.programs[planned.program].values)
            if (const auto* supplied = std::get_if<plan::Supplied>(&each.value))
                if (supplied->value == glsl::Builtin::timer) periods.insert(statement.timerPeriod);
    });
    return periods.size() == 1 ? std::optional(*periods.begin()) : std::nullopt;
}

/// True if the film has the control: its values can be counted or have a range.
bool isFilmed(const Knob& knob) {
    const std::size_t components = knob.current.size();
    if (!knob.words.empty() || knob.widget == render::Widget::checkBox) return components == 1;
    return knob.widget == render::Widget::slider && components <= kMostComponents;
}

/// A value of a range with three digits of its size, as the number that they are the shortest text of.
double rounded(double value, double size) {
    const double unit = std::pow(10, std::floor(std::log10(size)) - 2);
    if (!std::isnormal(unit)) return value;
    const std::string text = fmt::format("{:.15g}", std::round(value / unit) * unit);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

/// True if the scene states only whole numbers for the range and it has enough of them: a variable may be a
/// count, of which there are no halves.
bool countsWhole(const Knob& knob) {
    constexpr double kEnough = 4;
    const auto isWhole = [](double each) { return each == std::trunc(each); };
    return knob.maximum - knob.minimum >= kEnough && isWhole(knob.minimum) && isWhole(knob.maximum) &&
           std::ranges::all_of(knob.current, isWhole);
}

/// The values that a component takes, in rising order, with that at which it begins.
std::vector<double> stopsOf(const Knob& knob, std::size_t component, std::size_t most) {
    std::set<double> stops{knob.current[component]};
    if (!knob.words.empty())
        for (std::size_t i = 0; i < knob.words.size(); ++i) stops.insert(static_cast<double>(i));
    else if (knob.widget == render::Widget::checkBox)
        stops.insert({0, 1});
    else if (const double low = knob.isInteger() ? std::ceil(knob.minimum) : knob.minimum,
             high = knob.isInteger() ? std::floor(knob.maximum) : knob.maximum;
             std::isfinite(high - low) && high > low) {
        // As the slider: by factors over three decades or more.
        const bool isLogarithmic = low > 0 && std::log10(high / low) >= 3 - 1e-9;
        const bool isWhole = knob.isInteger() || countsWhole(knob);
        const std::size_t count =
            isWhole ? std::min(most, static_cast<std::size_t>(std::min(high - low, 1e3)) + 1) : most;
        for (std::size_t i = 0; i < count; ++i) {
            const double part = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
            const double value =
                isLogarithmic ? low * std::pow(high / low, part) : low * (1 - part) + high * part;
            const double size = isLogarithmic ? value : high - low;
            stops.insert(i == 0           ? low
                         : i + 1 == count ? high
                         : isWhole        ? std::round(value)
                                          : std::clamp(rounded(value, size), low, high));
        }
    }
    return {stops.begin(), stops.end()};
}

/// A value that has no slider as a choice: the word and the value of each alternative, the first one as it
/// begins.
struct Choice {
    Knob of;
    std::vector<std::pair<std::string, std::vector<double>>> values;
};

constexpr const char* kOwn = "of the scene";

/// The plain colours, for a colour; the values that keys of the scene give, for a variable.
std::optional<Choice> choiceOf(const Knob& knob, const std::vector<scene::KeyBinding>& keys) {
    Choice choice{knob, {{kOwn, knob.current}}};
    const auto add = [&](const std::string& word, const std::vector<double>& value) {
        if (value.size() == knob.current.size() &&
            std::ranges::find(choice.values, value, &std::pair<std::string, std::vector<double>>::second) ==
                choice.values.end())
            choice.values.emplace_back(word, value);
    };
    if (knob.widget == render::Widget::color) {
        constexpr std::array kNames{"black", "red", "green", "yellow", "blue", "magenta", "cyan", "white"};
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            std::vector<double> value = knob.current;
            for (std::size_t bit = 0; bit < std::min<std::size_t>(value.size(), 3); ++bit)
                value[bit] = (i >> bit & 1U) != 0 ? 1 : 0;
            add(kNames.at(i), value);
        }
    } else if (!knob.program && knob.widget == render::Widget::numbers) {
        for (const scene::KeyBinding& key : keys)
            if (key.variable == knob.tag && !key.isHeld)
                for (const std::vector<double>& each : key.values)
                    add(fmt::format("{:.6g}", fmt::join(each, " ")), each);
    }
    return choice.values.size() > 1 && knob.current.size() <= kMostComponents ? std::optional(choice)
                                                                              : std::nullopt;
}

/// The control of a choice.
Knob controlOf(const Choice& choice) {
    Knob knob = choice.of;
    knob.words.clear();
    for (const auto& [word, value] : choice.values) knob.words.push_back(word);
    knob.widget = render::Widget::numbers;
    knob.type = {.word = "int"};
    knob.initial = knob.current = {0};
    return knob;
}

/// A control of the film: for each component the values in rising order, and their pictures.
struct Filmed {
    std::vector<std::vector<double>> stops;
    std::vector<std::vector<std::vector<std::string>>> sets;  ///< arguments for --set that give them
    std::vector<std::vector<std::size_t>> pictures;
};

class FilmMaker {
  public:
    FilmMaker(gpu::Context& context, const FilmTask& task, render::SharedParts* shared,
              const FilmParts& parts, Diagnostics& diagnostics)
        : context_(context), task_(task), shared_(shared), parts_(parts), diagnostics_(diagnostics) {}

    Film run() {
        drawTime();
        for (const std::vector<std::size_t>& each : groups_) {
            if (filmed_.size() == kMostControls) {
                leaveOut(fmt::format("'{}' and what follows", knobs_[each.front()].tag),
                         fmt::format("it has {} controls already", kMostControls));
                break;
            }
            drawControl(each.front());
            tell();
        }
        drawCameras();
        return std::move(film_);
    }

  private:
    // ---- The film so far

    /// The number of a picture in the film; page-W02 if there is no more room for it.
    Result<std::size_t> add(image::Image picture) {
        std::string file = parts_.packed(picture);
        parts_.step(nullptr);
        if (const auto known = known_.find(file); known != known_.end()) return known->second;
        const std::size_t index = film_.pictures.size();
        std::string part = index > 0 ? parts_.packed(differing(picture)) : file;
        const bool isPart = part.size() < file.size();
        if (!isPart) part = file;
        if (size_ + part.size() > kLargestFilm)
            return withoutId(Severity::error, fmt::format("it has more than {} MiB", kLargestFilm >> 20U));
        size_ += part.size();
        if (isPart) state_["parts"].push_back(index);
        film_.pictures.push_back(std::move(part));
        known_.emplace(std::move(file), index);
        if (index == 0) first_ = std::move(picture);
        return index;
    }

    /// The picture with transparent black where it is as the first one.
    [[nodiscard]] image::Image differing(const image::Image& picture) const {
        image::Image part = image::withComponents(picture, 4);
        const auto first = std::span(first_.data), now = std::span(picture.data);
        for (std::size_t i = 0; 3 * i + 3 <= std::min(first.size(), now.size()); ++i)
            if (std::ranges::equal(first.subspan(3 * i, 3), now.subspan(3 * i, 3)))
                std::ranges::fill(std::span(part.data).subspan(4 * i, 4), std::byte{});
        return part;
    }

    void leaveOut(const std::string& what, const std::string& why) {
        diagnostics_.push_back(diagnose("page-W02", fmt::format("the film is without {}: {}", what, why),
                                        {task_.scene.generic_string(), 1, 1}));
    }

    void tell() {
        state_["knobs"] = state_["shared"] = Ordered::array();
        for (const std::vector<std::size_t>& group : groups_) {
            const auto filmed = filmed_.find(group.front());
            if (filmed == filmed_.end()) continue;
            Ordered indices = Ordered::array();
            for (const std::size_t each : group) {
                indices.push_back(state_["knobs"].size());
                Ordered& json = state_["knobs"].emplace_back(render::jsonOf(knobs_[each]));
                json["initial"] = knobs_[each].current;
                json["stops"] = filmed->second.stops;
                json["pictures"] = filmed->second.pictures;
            }
            if (group.size() > 1) state_["shared"].push_back(std::move(indices));
        }
        film_.state = state_.dump(-1, ' ', false, Ordered::error_handler_t::replace);
        parts_.step(&film_);
    }

    // ---- Time

    /// Draws the scene as it begins, and then over time with the same renderer, since pictures may depend on
    /// earlier ones.
    void drawTime() {
        render::Stats stats;
        Result<render::SceneRenderer> renderer =
            render::SceneRenderer::load(context_, task_.scene, task_.options, stats, shared_);
        append(diagnostics_, std::move(renderer.diagnostics));
        if (!renderer) return;
        const double begin = task_.options.time;
        Result<image::Image> first = renderer->draw(begin, stats);
        append(diagnostics_, std::move(first.diagnostics));
        if (!first) return;
        film_.width = first->width;
        film_.height = first->height;
        if (const auto added = add(std::move(*first)); !added)
            return leaveOut("a picture", added.diagnostics.front().text);
        describe(*renderer);
        tell();

        const double length = lengthFor(*renderer);
        std::vector<std::size_t> frames{0};
        std::optional<render::Moment> moment = renderer->momentOf(begin);
        for (int i = 1; i < task_.film.frames; ++i) {
            const double time = begin + i * length / task_.film.frames;
            std::optional<render::Moment> next = renderer->momentOf(time);
            if (next && next == moment) {
                frames.push_back(frames.back());
                continue;
            }
            moment = std::move(next);
            Result<image::Image> picture = renderer->draw(time, stats);
            Result<std::size_t> added =
                picture ? add(std::move(*picture)) : Result<std::size_t>(std::move(picture.diagnostics));
            if (!added) {
                leaveOut(fmt::format("the time from {:.6g} s on", time), why(added.diagnostics));
                break;
            }
            frames.push_back(*added);
        }
        if (film_.pictures.size() == 1) return;
        state_["length"] = length * static_cast<double>(frames.size()) / task_.film.frames;
        state_["frames"] = std::move(frames);
        tell();
    }

    static std::string why(const Diagnostics& diagnostics) {
        const auto error = std::ranges::find(diagnostics, Severity::error, &Diagnostic::severity);
        return error != diagnostics.end() ? error->text
               : diagnostics.empty()      ? "it cannot be drawn"
                                          : diagnostics.front().text;
    }

    [[nodiscard]] double lengthFor(const render::SceneRenderer& renderer) const {
        if (task_.film.seconds > 0) return task_.film.seconds;
        const std::optional<double> period = periodOf(renderer.plan());
        const std::optional<render::Moment> moment = renderer.momentOf(task_.options.time);
        const bool isByTimer = moment && moment->size() == 1;
        return isByTimer && period && *period > 0 && *period <= kLongestRound ? *period : kSeconds;
    }

    void describe(render::SceneRenderer& renderer) {
        const render::Conductor& conductor = renderer.state().conductor;
        state_ = {
            {"width", film_.width}, {"height", film_.height},    {"begin", task_.options.time}, {"length", 0},
            {"frames", {0}},        {"parts", Ordered::array()}, {"files", Ordered::array()}};
        std::set<std::string> known;
        const auto addFile = [&](const fs::path& path, const char* language) {
            std::string name = parts_.nameOf(path);
            if (path.empty() || !known.insert(name).second) return;
            film_.texts.push_back(name);
            state_["files"].push_back({{"name", std::move(name)}, {"language", language}});
        };
        addFile(task_.scene, "glib");
        for (const fs::path& each : conductor.programs.filesRead()) addFile(each, "glsl");

        const std::vector<Knob> all = render::knobsOf(renderer.scene(), conductor.plans());
        std::string plain;  // numbers without a range
        for (const Knob& each : all) {
            std::optional<Choice> choice =
                isFilmed(each) ? std::nullopt : choiceOf(each, renderer.scene().keys);
            if (isFilmed(each) || choice) {
                knobs_.push_back(choice ? controlOf(*choice) : each);
                choices_.push_back(std::move(choice));
            } else if (each.widget == render::Widget::numbers && each.current.size() <= kMostComponents) {
                plain += fmt::format("{}'{}'", plain.empty() ? "" : ", ", each.tag);
            }
        }
        if (!plain.empty()) {
            diagnostics_.push_back(
                withoutId(Severity::note, fmt::format("the film has no pictures over {}: give a range, as in "
                                                      "NAME <0 .5 1> (least, current and largest value)",
                                                      plain)));
            diagnostics_.back().place = {task_.scene.generic_string(), 1, 1};
        }
        groups_ = render::sharedKnobs(knobs_);
        for (std::size_t i = 0; i < knobs_.size(); ++i)
            if (std::ranges::none_of(
                    groups_, [&](const auto& each) { return std::ranges::find(each, i) != each.end(); }))
                groups_.push_back({i});
        std::ranges::sort(groups_);
        std::size_t sliders = 0;
        for (const std::vector<std::size_t>& each : groups_) sliders += knobs_[each.front()].current.size();
        const std::size_t most =
            std::clamp(kMostValues / std::max<std::size_t>(sliders, 1), kFewestStops, kMostStops);
        for (const std::vector<std::size_t>& group : groups_) {
            Filmed& filmed = planned_[group.front()];
            const Knob& knob = knobs_[group.front()];
            for (std::size_t component = 0; component < knob.current.size(); ++component) {
                filmed.stops.push_back(stopsOf(knob, component, most));
                std::vector<std::vector<std::string>>& sets = filmed.sets.emplace_back();
                for (const double value : filmed.stops.back()) {
                    std::vector<std::string>& set = sets.emplace_back();
                    for (const std::size_t each : group) {
                        const std::optional<Choice>& choice = choices_[each];
                        Knob moved = choice ? choice->of : knobs_[each];
                        if (choice)
                            moved.current = choice->values[static_cast<std::size_t>(value)].second;
                        else
                            moved.current[component] = value;
                        set.push_back(render::setArgument(renderer.scene(), moved, all));
                    }
                }
            }
        }
    }

    // ---- Controls

    void drawControl(std::size_t index) {
        Filmed filmed = std::move(planned_[index]);
        const Knob& knob = knobs_[index];
        std::string problem;
        for (std::size_t component = 0; component < filmed.stops.size(); ++component) {
            std::vector<double> stops;
            std::vector<std::size_t>& pictures = filmed.pictures.emplace_back();
            for (std::size_t i = 0; i < filmed.stops[component].size(); ++i) {
                const double value = filmed.stops[component][i];
                Result<std::size_t> picture = value == knob.current[component]
                                                  ? Result<std::size_t>(std::size_t{0})
                                                  : drawnWith(filmed.sets[component][i]);
                if (picture) {
                    stops.push_back(value);
                    pictures.push_back(*picture);
                } else if (problem.empty()) {
                    problem = why(picture.diagnostics);
                    leaveOut(filmed.sets[component][i].front(), problem);
                }
            }
            filmed.stops[component] = std::move(stops);
        }
        filmed_.emplace(index, std::move(filmed));
    }

    /// The scene as it begins through each of its cameras, by one control. There are no such pictures of
    /// `glibra render`; a window draws them.
    void drawCameras() {
        render::LiveScene::Loading loading =
            render::LiveScene::load(context_, task_.scene, task_.options, nullptr);
        if (!loading.scene) return leaveOut("what the cameras see", why(loading.diagnostics));
        if (loading.scene->cameras().empty() || film_.pictures.empty()) return;
        Result<gpu::Target> target = gpu::Target::window(
            context_.capabilities(), film_.width, film_.height, gpu::TexelFormat::rgba8,
            task_.options.samples, render::depthFormat(loading.scene->scene().reversesWindow));
        if (!target) return leaveOut("what the cameras see", why(target.diagnostics));
        Knob knob;
        knob.tag = "Camera";
        knob.initial = knob.current = {0};
        knob.words = {kOwn};
        Filmed filmed{{{0}}, {}, {{0}}};
        for (const scene::NamedCamera& each : std::vector(loading.scene->cameras())) {
            loading.scene->setCamera(each.name);
            const Diagnostics problems = loading.scene->draw(*target, {}, task_.options.time, false);
            target->resolve();
            auto pixels = gpu::readPixels(context_.capabilities(), target->readable(), 0,
                                          {0, 0, film_.width, film_.height}, {3, gpu::TexelType::u8});
            const auto added =
                pixels && !hasError(problems)
                    ? add({film_.width, film_.height, 3, image::Component::u8, std::move(*pixels)})
                    : Result<std::size_t>(problems);
            if (!added) {
                leaveOut(fmt::format("the camera '{}'", each.name), why(added.diagnostics));
                continue;
            }
            filmed.stops[0].push_back(static_cast<double>(knob.words.size()));
            filmed.pictures[0].push_back(*added);
            knob.words.push_back(each.name);
        }
        if (knob.words.size() == 1) return;
        filmed_.emplace(knobs_.size(), std::move(filmed));
        groups_.push_back({knobs_.size()});
        knobs_.push_back(std::move(knob));
        tell();
    }

    Result<std::size_t> drawnWith(const std::vector<std::string>& set) {
        RenderOptions options = task_.options;
        options.set.insert(options.set.end(), set.begin(), set.end());
        render::Stats stats;
        Result<render::SceneRenderer> renderer =
            render::SceneRenderer::load(context_, task_.scene, options, stats, shared_);
        if (!renderer) return std::move(renderer.diagnostics);
        Result<image::Image> picture = renderer->draw(options.time, stats);
        if (!picture) return std::move(picture.diagnostics);
        return add(std::move(*picture));
    }

    gpu::Context& context_;
    const FilmTask& task_;
    render::SharedParts* shared_;
    const FilmParts& parts_;
    Diagnostics& diagnostics_;
    Film film_;
    image::Image first_;  ///< the picture, RGB in bytes
    Ordered state_;
    std::vector<Knob> knobs_;
    std::vector<std::optional<Choice>> choices_;      ///< of the first knobs, which are those of the scene
    std::vector<std::vector<std::size_t>> groups_;    ///< of knobs that one control moves
    std::map<std::size_t, Filmed> planned_, filmed_;  ///< by the first knob of their groups
    std::map<std::string, std::size_t> known_;        ///< pictures of the film
    std::size_t size_ = 0;                            ///< of them in bytes
};

}  // namespace

Film filmOf(gpu::Context& context, const FilmTask& task, render::SharedParts* shared, const FilmParts& parts,
            Diagnostics& diagnostics) {
    return FilmMaker(context, task, shared, parts, diagnostics).run();
}

}  // namespace glibra::page
