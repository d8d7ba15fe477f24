#include "page/page_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/device_lost.h"
#include "base/files.h"
#include "base/packed.h"
#include "base/text.h"
#include "image/convert.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/write.h"
#include "render/check/scene_check.h"
#include "render/file/scene_inputs.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"
#include "suite/run/run_options.h"
#include "system/spelling.h"

namespace glibra::page {

void eachMember(auto& packed, base::Is<PageFile> auto& of) {
    packed(of.name, of.content, of.isConverted);
}
void eachMember(auto& packed, base::Is<PageScene> auto& of) {
    packed(of.name, of.files, of.read, of.head.rows, of.head.summary, of.head.text, of.width, of.height);
    packed(of.picture, of.diagnostics, of.isLive, of.film.pictures, of.film.state, of.noDriver);
}

namespace {

namespace fs = std::filesystem;

constexpr int kSmallest = 9;  // the level of PngOptions for what is written once and loaded often

/// The path from the folder; nothing if it leads outside.
std::optional<fs::path> below(const fs::path& folder, const fs::path& file) {
    const fs::path inside = file.lexically_relative(folder);
    if (inside.empty() || *inside.begin() == "..") return std::nullopt;
    return inside;
}

/// Gives files their names on the page.
class Names {
  public:
    explicit Names(const PageTask& task) : roots_(task.options.libraryRoots) {
        const fs::path folder = system::wholePath(task.scene).parent_path();
        top_ = folder.has_filename() ? folder.parent_path() : folder;
        for (fs::path each = folder; each.has_relative_path(); each = each.parent_path()) {
            std::error_code failure;
            if (!fs::is_directory(each / "shaders", failure) && !fs::is_directory(each / "textures", failure))
                continue;
            top_ = each;
            break;
        }
        for (fs::path& each : roots_) each = system::wholePath(each);
    }

    [[nodiscard]] std::string of(const fs::path& path) const {
        const fs::path file = system::wholePath(path);
        if (const auto inside = below(top_, file)) return inside->generic_string();
        for (const fs::path& root : roots_)
            if (const auto inside = below(root, file)) return inside->generic_string();
        return file.filename().generic_string();
    }

  private:
    std::vector<fs::path> roots_;
    fs::path top_;  ///< that names are relative to
};

/// A page reads DDS files itself, but for blocks that the module decodes.
bool needsModule(image::Format format) {
    const image::FormatRow& row = image::rowOf(format);
    return row.read == nullptr && !row.openImageIo.empty() && format != image::Format::dds;
}

/// A picture as PNG, or as PFM if it has floats.
std::string converted(image::Image picture) {
    if (picture.components == 4 && !image::isTransparent(picture))
        picture = image::withComponents(picture, 3);
    image::PngOptions smallest;
    smallest.level = kSmallest;
    const std::vector<std::byte> file = picture.type == image::Component::f32
                                            ? image::encodePfm(picture)
                                            : image::encodePng(picture, smallest);
    return std::string(base::asText(file));
}

void addUnknown(Diagnostics& all, Diagnostics more) {
    for (Diagnostic& each : more)
        if (std::ranges::none_of(all, [&](const Diagnostic& known) {
                return known.place == each.place && known.text == each.text;
            }))
            all.push_back(std::move(each));
}

/// The picture as a PNG file, or an empty text.
std::string drawn(gpu::Context& context, const PageTask& task, render::SharedParts* shared, PageScene& page) {
    render::Stats stats;
    Result<render::SceneRenderer> renderer =
        render::SceneRenderer::load(context, task.scene, task.options, stats, shared);
    addUnknown(page.diagnostics, std::move(renderer.diagnostics));
    if (!renderer) return {};
    Result<image::Image> picture = renderer->draw(task.options.time, stats);
    addUnknown(page.diagnostics, std::move(picture.diagnostics));
    if (!picture) return {};
    page.width = picture->width;
    page.height = picture->height;
    return converted(std::move(*picture));
}

void addFilm(gpu::Context& context, const PageTask& task, render::SharedParts* shared, const base::Step& step,
             PageScene& page) {
    for (Diagnostic& each : page.diagnostics) each.severity = std::min(each.severity, Severity::warning);
    FilmTask sized{task.scene, task.options, task.film};
    if (task.options.width <= 0) {
        render::Stats stats;
        const Result<render::InterpretedScene> read = render::interpretFile(task.scene, task.options, stats);
        if (read)
            std::tie(sized.options.width, sized.options.height) =
                fitting(read->scene.width, read->scene.height, task.film.width, task.film.height);
    }
    const Names names(task);
    Diagnostics ofFilm;
    const auto take = [&](const Film& film) {
        page.film = film;
        // Models, pictures and the like are not needed any more.
        std::erase_if(page.files, [&](const PageFile& each) {
            return std::ranges::find(film.texts, each.name) == film.texts.end();
        });
        page.picture = film.pictures.front();
        page.width = film.width;
        page.height = film.height;
        addUnknown(page.diagnostics, std::exchange(ofFilm, {}));
    };
    const Film film = filmOf(context, sized, shared,
                             {[&](const fs::path& path) { return names.of(path); }, converted,
                              [&](const Film* soFar) {
                                  if (soFar) take(*soFar);
                                  step(soFar ? toText(page) : std::string());
                              }},
                             ofFilm);
    if (!film.pictures.empty()) take(film);
    addUnknown(page.diagnostics, std::move(ofFilm));
}

/// What readers of a large page load.
void noteSize(const PageTask& task, PageScene& page) {
    constexpr std::size_t kNamed = 3;
    std::size_t all = 0;
    std::vector<std::pair<std::size_t, std::string>> sizes;
    for (const PageFile& each : page.files) {
        all += each.content.size();
        sizes.emplace_back(each.content.size(), each.name);
    }
    if (all <= kLargeScene) return;
    std::ranges::sort(sizes, std::greater());
    sizes.resize(std::min(sizes.size(), kNamed));
    std::string text = fmt::format("readers of the page load {} of files", base::readableBytes(all));
    for (const auto& [size, name] : sizes)
        text += fmt::format("{}'{}' has {}", &name == &sizes.front().second ? "; " : ", ", name,
                            base::readableBytes(size));
    Diagnostic note = withoutId(Severity::note, text);
    note.place = {task.scene.generic_string(), 1, 1};
    page.diagnostics.push_back(std::move(note));
}

}  // namespace

std::pair<int, int> fitting(int windowWidth, int windowHeight, int width, int height) {
    if (windowWidth <= 0 || windowHeight <= 0) return {width, height};
    const double scale =
        std::min(static_cast<double>(width) / windowWidth, static_cast<double>(height) / windowHeight);
    const auto side = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(scale * pixels))); };
    return {side(windowWidth), side(windowHeight)};
}

std::vector<PageFile> filesOf(const PageTask& task, std::vector<fs::path>& read, Diagnostics& problems) {
    const Place place{task.scene.generic_string(), 1, 1};
    const scene::InterpretOptions options{task.options.libraryRoots, task.options.within};
    base::Roots readable = scene::shownRoots(scene::searchFolders(task.scene, options));
    readable.add(task.options.within);
    const Names names(task);
    std::map<std::string, PageFile> files;
    std::size_t size = 0;
    for (const fs::path& each : render::filesReadBy(task.scene, task.options).files) {
        const auto bytes = base::bytesIn(readable.open(each), kLargestScene - size);
        if (!bytes) {
            std::error_code failure;
            const auto length = fs::file_size(each, failure);
            if (failure) continue;  // the scene reports what is missing
            if (length > kLargestScene - size) {
                problems.push_back(diagnose("page-E02",
                                            fmt::format("the files of the scene have more than {} together",
                                                        base::readableBytes(kLargestScene)),
                                            place));
                return {};
            }
            problems.push_back(diagnose(
                "page-W01",
                fmt::format("'{}' is not on the page: it is a link, or lies outside", each.generic_string()),
                place));
            continue;
        }
        PageFile file{names.of(each), std::string(base::asText(*bytes))};
        if (needsModule(image::formatOf(*bytes))) {
            Result<image::Image> picture = image::decodeImage(*bytes, each, place);
            append(problems, std::move(picture.diagnostics));
            if (picture) file = {file.name, converted(std::move(*picture)), true};
        }
        size += bytes->size();
        read.push_back(each);
        std::string name = file.name;
        files.emplace(std::move(name), std::move(file));
    }
    std::vector<PageFile> sorted;
    for (auto& [name, file] : files) sorted.push_back(std::move(file));
    return sorted;
}

PageScene pageScene(gpu::Context& context, const PageTask& task, render::SharedParts* shared,
                    const base::Step& step) {
    PageScene page;
    page.name = Names(task).of(task.scene);
    page.files = filesOf(task, page.read, page.diagnostics);
    const auto text = std::ranges::find(page.files, page.name, &PageFile::name);
    if (text != page.files.end()) page.head = source::headOf(text->content);
    RenderOptions checked = task.options;
    checked.set.clear();  // reported by the picture
    addUnknown(page.diagnostics, render::checkScene(context, task.scene, checked, shared, true).diagnostics);
    const auto isOfWeb = [](const Diagnostic& each) { return each.id.starts_with("web-"); };
    const auto isOwn = [&](const Diagnostic& each) {
        return each.severity == Severity::error && !isOfWeb(each);
    };
    const bool isWhole = !hasError(page.diagnostics);
    if (isWhole && task.draws) page.picture = drawn(context, task, shared, page);
    page.isLive =
        isWhole ? !task.draws || !page.picture.empty()
                : task.isExercise && !page.files.empty() && std::ranges::none_of(page.diagnostics, isOfWeb);
    if (page.isLive) noteSize(task, page);
    if (!isWhole && std::ranges::none_of(page.diagnostics, isOwn)) addFilm(context, task, shared, step, page);
    return page;
}

void makePages(std::span<const PageTask> tasks, Driver driver, const base::WorkerOptions& workers,
               const std::function<void(std::size_t, const base::Outcome&, std::optional<PageScene>)>& done) {
    struct Worker {
        std::optional<gpu::Context> context;  // opened with the first scene
        render::SharedParts shared;           // after the context, because it must be destroyed first
    };
    const auto worker = std::make_shared<Worker>();
    std::map<std::size_t, std::string> soFar;  // pages with unfinished films
    base::runInWorkers(
        tasks.size(), workers,
        [&, worker](std::size_t index, const base::Step& step) -> std::string {
            if (!worker->context) {
                suite::shareProcessors(workers.workers, tasks.size());
                Result<gpu::Context> opened = gpu::openContext({.driver = driver});
                if (!opened) {
                    PageScene none;
                    none.diagnostics = std::move(opened.diagnostics);
                    none.noDriver = true;
                    return toText(none);
                }
                worker->context.emplace(std::move(*opened));
            }
            try {
                return toText(pageScene(*worker->context, tasks[index], &worker->shared, step));
            } catch (const base::DeviceLost&) {
                throw;  // the worker must not be used any more
            } catch (const std::exception& failure) {
                PageScene none;
                none.diagnostics.push_back(
                    diagnose("draw-E06", failure.what(), {tasks[index].scene.generic_string(), 1, 1}));
                return toText(none);
            }
        },
        [&](std::size_t index, const base::Outcome& outcome) {
            using End = base::Outcome::End;
            std::optional<PageScene> page;
            if (outcome.end == End::finished) {
                page = parsePageScene(outcome.answer);
            } else if (outcome.end != End::stopped) {
                page = parsePageScene(soFar[index]);
                if (page)
                    page->diagnostics.push_back(
                        diagnose("page-W02",
                                 fmt::format("the film is not complete: {}", outcome.end == End::timedOut
                                                                                 ? "a picture took too long"
                                                                                 : "drawing ended"),
                                 {tasks[index].scene.generic_string(), 1, 1}));
            }
            soFar.erase(index);
            done(index, outcome, std::move(page));
        },
        [&](std::size_t index, const std::string& text) {
            if (!text.empty()) soFar[index] = text;
        });
}

std::string toText(const PageScene& scene) {
    return base::packed(scene);
}

std::optional<PageScene> parsePageScene(std::string_view text) {
    std::optional<PageScene> scene = base::unpacked<PageScene>(text);
    if (!scene) return std::nullopt;
    scene->film.width = scene->width = std::clamp(scene->width, 0, kLargestPictureSide);
    scene->film.height = scene->height = std::clamp(scene->height, 0, kLargestPictureSide);
    return scene;
}

}  // namespace glibra::page
