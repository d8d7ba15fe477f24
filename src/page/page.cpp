#include "page/page.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <system_error>
#include <tuple>

#include "base/device_lost.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/packed.h"
#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "embedded/live_page.h"
#include "glib/text.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/write.h"
#include "plan/overrides.h"
#include "render/check/scene_check.h"
#include "render/file/scene_inputs.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"
#include "source/code_html.h"
#include "suite/report/report_pictures.h"
#include "suite/run/run_options.h"
#include "system/folder.h"
#include "system/places.h"

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

constexpr int kPngLevel = 9;  // the level of PngOptions for what is written once and loaded often

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
    smallest.level = kPngLevel;
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
                none.diagnostics.push_back(diagnose("draw-E06", base::reasonOf(failure),
                                                    {tasks[index].scene.generic_string(), 1, 1}));
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

namespace {

using base::escapeXml;
using base::printableText;
using Json = nlohmann::json;

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// 'sha256-...', as a Content-Security-Policy names a text of the page.
std::string hashOf(std::string_view text) {
    return fmt::format("'sha256-{}'", suite::base64(base::sha256(bytesOf(text))));
}

/// JSON in ASCII without what ends or begins an element of HTML.
std::string scriptText(const Json& json) {
    std::string text;
    for (const char each : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        if (each == '<' || each == '>' || each == '&')
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(each));
        else
            text += each;
    return text;
}

/// A film as the page plays it, with the texts that it names in colours: [] of what is no film, which may
/// come from a worker that a scene has taken over.
Json filmJson(const PageScene& scene) {
    constexpr int kDeepest = 8;
    Json film = Json::parse(
        scene.film.state, [](int depth, Json::parse_event_t, Json&) { return depth < kDeepest; }, false);
    Json sources = Json::object();
    if (!film.is_object() || !film.contains("files") || !film["files"].is_array()) return Json::array();
    for (const Json& each : film["files"]) {
        const auto file = std::ranges::find_if(scene.files, [&](const PageFile& one) {
            return each.is_object() && each.contains("name") && each["name"] == one.name;
        });
        if (file == scene.files.end()) continue;
        const bool isGlib = each.value("language", Json()) == "glib";
        sources[file->name] =
            source::codeHtml(file->content, isGlib ? source::CodeLanguage::glib : source::CodeLanguage::glsl);
    }
    film["sources"] = packed(bytesOf(sources.dump(-1, ' ', true, Json::error_handler_t::replace)));
    film["pictures"] = Json::array();
    for (const std::string& each : scene.film.pictures)
        film["pictures"].push_back(suite::base64(bytesOf(each)));
    return film;
}

std::string dataOf(const PageScene& scene, const PageOptions& options) {
    Json files = Json::array(), set = Json::array();
    std::string content;
    for (const PageFile& each : scene.files) {
        files.push_back(
            {{"name", each.name}, {"bytes", each.content.size()}, {"converted", each.isConverted}});
        content += each.content;
    }
    for (const std::string& each : options.set)
        if (const Result<plan::Override> value = plan::parseOverride(each))
            set.push_back({{"program", value->program},
                           {"name", value->name},
                           {"values", value->values},
                           {"word", value->word}});
    Json data = {
        {"scene", scene.name},        {"files", std::move(files)},  {"content", packed(bytesOf(content))},
        {"set", std::move(set)},      {"time", options.time},       {"width", options.width},
        {"height", options.height},   {"samples", options.samples}, {"embed", options.isEmbedded},
        {"poster", options.hasPoster}};
    if (isFilm(scene)) data["film"] = filmJson(scene);
    return scriptText(data);
}

std::string posterHtml(std::string_view source, int width, int height) {
    return fmt::format("<img class=\"poster\" src=\"{}\" width=\"{}\" height=\"{}\" alt=\"the picture\">",
                       escapeXml(source), width, height);
}

constexpr const char* kPlainPolicy =
    "default-src 'none'; img-src data:; style-src {}; base-uri 'none'; form-action 'none'";
constexpr const char* kLivePolicy =
    "default-src 'none'; img-src data: blob:; style-src {}; script-src {} 'wasm-unsafe-eval'; base-uri "
    "'none'; "
    "form-action 'none'";
constexpr const char* kFilmPolicy =
    "default-src 'none'; img-src data: blob:; style-src {}; script-src {}; base-uri 'none'; form-action "
    "'none'";

}  // namespace

std::string whyNotLive(const PageScene& scene) {
    const auto found = std::ranges::find_if(scene.diagnostics, [](const Diagnostic& each) {
        return each.severity == Severity::error || each.id.starts_with("web-");
    });
    std::string why = "it cannot be drawn";
    if (found != scene.diagnostics.end()) {
        Diagnostic first = *found;
        first.severity = Severity::error;
        nameAsOnPage(first.place, scene.files);
        why = toString(first);
    }
    if (scene.film.pictures.size() < 2)
        return "This is a picture, because browsers cannot draw the scene: " + why;
    return "This is a film, because browsers cannot draw the scene: " + why +
           ". It shows one change at a time: of the time, or of one value while all others are as at the "
           "beginning; and the mouse does not turn it.";
}

std::string packed(std::span<const std::byte> bytes) {
    constexpr int kSmallest = 12;
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kSmallest));
    std::vector<std::byte> file(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()));
    file.resize(
        libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), file.data(), file.size()));
    return suite::base64(file);
}

Result<std::string> packedRuntime(const std::vector<fs::path>& folders) {
    std::vector<fs::path> places = folders;
    const fs::path program = system::programFile().parent_path();
    std::error_code failure;
    if (fs::exists(program / "CMakeCache.txt", failure)) places.push_back(program.parent_path() / "web");
    for (const fs::path& each : places) {
        const fs::path file = each / "glibra.wasm";
        if (!fs::is_regular_file(file, failure)) continue;
        Result<std::vector<std::byte>> bytes = image::readFile(file, {file.generic_string(), {}});
        if (!bytes) return std::move(bytes.diagnostics);
        return packed(*bytes);
    }
    return diagnose("page-E01",
                    "the runtime of live pages, glibra.wasm, is not there; in a checkout of glibra, "
                    "tools/glibra publish builds it");
}

std::string wholePage(const PageScene& scene, const PageOptions& options, const std::string& title,
                      std::string_view runtime) {
    const std::string_view style = live_page::live_css(), script = live_page::live_js();
    const std::string picture =
        scene.picture.empty() ? std::string()
                              : posterHtml("data:image/png;base64," + suite::base64(bytesOf(scene.picture)),
                                           scene.width, scene.height);
    std::string content = fmt::format("<div class=\"live\">{}</div>", picture), scripts;
    const bool hasScript = scene.isLive || isFilm(scene);
    if (!scene.isLive)
        content.insert(options.isEmbedded ? content.size() : 0,
                       "<p class=\"remark\">" + escapeXml(printableText(whyNotLive(scene))) + "</p>\n");
    if (hasScript) {
        content += fmt::format("<noscript><p class=\"remark\">With JavaScript the {} moves.</p></noscript>",
                               scene.isLive ? "scene" : "film");
        scripts = fmt::format("<script type=\"application/json\" id=\"glibra-scene\">{}</script>\n",
                              dataOf(scene, options));
        if (scene.isLive)
            scripts +=
                fmt::format("<script type=\"text/plain\" id=\"glibra-runtime\">{}</script>\n", runtime);
        scripts += fmt::format("<script>{}</script>", script);
    }
    std::string facts;
    for (const std::string& each : scene.head.rows) facts += (facts.empty() ? "" : " ") + each;
    const base::Fields fields = {
        {"policy", scene.isLive ? fmt::format(kLivePolicy, hashOf(style), hashOf(script))
                   : hasScript  ? fmt::format(kFilmPolicy, hashOf(style), hashOf(script))
                                : fmt::format(kPlainPolicy, hashOf(style))},
        {"title", printableText(title)},
        {"style", style},
        {"kind", options.isEmbedded ? "page embedded" : "page"},
        {"content", std::move(content)},
        {"text", options.isEmbedded ? std::string() : textHtml(scene.head, facts)},
        {"scripts", std::move(scripts)},
    };
    return base::filled(live_page::page_html(), fields);
}

std::vector<SiteFile> runtimeFiles(std::string_view runtime) {
    std::vector<SiteFile> files{{"live.css", std::string(live_page::live_css())},
                                {"live.js", std::string(live_page::live_js())}};
    if (!runtime.empty())
        files.push_back({"runtime.js", fmt::format("globalThis.glibraRuntime = \"{}\";\n", runtime)});
    return files;
}

std::string sceneScript(const PageScene& scene, const PageOptions& options) {
    return fmt::format("globalThis.glibraScene = {};\n", dataOf(scene, options));
}

std::string liveHtml(std::string_view folder, std::string_view script, std::string_view picture, int width,
                     int height, const std::string& whyFilm) {
    std::string html;
    if (!whyFilm.empty()) html = "<p class=\"remark\">" + escapeXml(printableText(whyFilm)) + "</p>\n";
    html += fmt::format("<link rel=\"stylesheet\" href=\"{0}/live.css\"><div class=\"live\">{1}</div>\n",
                        folder, posterHtml(picture, width, height));
    std::vector<std::string> scripts{std::string(script), fmt::format("{}/live.js", folder)};
    if (whyFilm.empty()) scripts.insert(scripts.begin() + 1, fmt::format("{}/runtime.js", folder));
    for (const std::string& each : scripts)
        html += fmt::format("<script src=\"{}\" defer></script>\n", escapeXml(each));
    return html;
}

std::string textHtml(const source::SceneHead& head, std::string_view facts) {
    std::string html, paragraph;
    const auto end = [&] {
        if (!paragraph.empty()) html += "<p>" + paragraph + "</p>\n";
        paragraph.clear();
    };
    for (const std::string& each : head.text) {
        // The items of a task have a line of their own.
        const bool isItem = each.size() > 1 && glib::isDigit(each[0]) && each[1] == '.';
        if (each.empty() || isItem) end();
        if (!each.empty()) paragraph += (paragraph.empty() ? "" : " ") + escapeXml(printableText(each));
    }
    end();
    if (!facts.empty()) html += "<p><small>" + escapeXml(printableText(facts)) + "</small></p>\n";
    return html.empty() ? html : "<div class=\"text\">" + html + "</div>";
}

}  // namespace glibra::page
