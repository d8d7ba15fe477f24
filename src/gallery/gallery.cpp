#include "gallery/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/packed.h"
#include "base/text.h"
#include "classroom/tokens.h"
#include "glib/limits.h"
#include "glib/text.h"
#include "render/scene_renderer.h"
#include "scene/file_lookup.h"
#include "suite/file/sweep.h"
#include "system/folder.h"

namespace glibra::gallery {
namespace {

namespace fs = std::filesystem;

/// A name for files and links that every file system and browser takes as it is.
std::string plainName(const std::string& path) {
    constexpr std::size_t kLongest = 120;
    const std::string stem = fs::path(path).replace_extension().generic_string();
    std::string name;
    for (const char each : stem)
        name += glib::isLetter(each) || glib::isDigit(each) || each == '_' || (each == '.' && !name.empty())
                    ? each
                    : '-';
    return name.substr(0, kLongest);
}

}  // namespace

std::string folderOf(const GalleryScene& scene) {
    const std::string folder = fs::path(scene.path).parent_path().generic_string();
    return folder.empty() ? "." : folder;
}

void connect(Gallery& gallery) {
    std::set<std::string> taken;  // without case, for file systems that ignore it
    std::map<std::string, std::size_t> byPath;
    for (std::size_t i = 0; i < gallery.scenes.size(); ++i) {
        GalleryScene& scene = gallery.scenes[i];
        const std::string plain = plainName(scene.path);
        scene.name = plain;
        for (int number = 2; !taken.insert(glib::lower(scene.name)).second; ++number)
            scene.name = fmt::format("{}-{}", plain, number);
        byPath.emplace(scene.path, i);
    }
    for (std::size_t i = 0; i < gallery.scenes.size(); ++i) {
        GalleryScene& scene = gallery.scenes[i];
        const auto found = byPath.find(scene.description.solution);
        if (found == byPath.end() || found->second == i) continue;
        scene.solution = found->second;
        gallery.scenes[found->second].tasks.push_back(i);
    }
}

std::string summary(const Gallery& gallery) {
    const auto drawn = static_cast<std::size_t>(std::ranges::count_if(gallery.scenes, isDrawn));
    std::string text = fmt::format("{}: {} drawn", base::counted(gallery.scenes.size(), "scene"), drawn);
    if (drawn < gallery.scenes.size()) text += fmt::format(", {} not", gallery.scenes.size() - drawn);
    return text;
}

void eachMember(auto& packed, base::Is<Control> auto& of) {
    packed.upTo(Control::Kind::color, of.kind);
    packed(of.owner, of.name, of.numbers, of.words);
}
void eachMember(auto& packed, base::Is<SourceText> auto& of) {
    packed(of.name, of.role, of.text);
}
void eachMember(auto& packed, base::Is<Description> auto& of) {
    packed(of.head.rows, of.head.summary, of.head.text, of.width, of.height, of.mayMove, of.solution,
           of.keys);
    packed(of.controls, of.sources);
}

namespace {

constexpr std::size_t kMostSources = 100;     // of a scene
constexpr std::size_t kMostText = 2'000'000;  // bytes of them
constexpr std::size_t kMostControls = 500;
constexpr std::uint64_t kLargestText = std::min<std::uint64_t>(glib::kLargestFile, kMostText);

/// The path from the folder; without a value it leads outside.
std::optional<std::string> below(const fs::path& folder, const fs::path& file) {
    if (!system::isBelow(file, folder)) return std::nullopt;
    return system::realPath(file).lexically_relative(system::realPath(folder)).generic_string();
}

/// The texts of one scene, each once, as far as they may be shown.
class Texts {
  public:
    Texts(const DescribeTask& task, Description& to) : task_(task), to_(to) {
        const scene::InterpretOptions options{task.options.libraryRoots, task.options.within};
        readable_ = scene::shownRoots(scene::searchFolders(task.scene, options));
        readable_.add(task.folder);
    }

    /// Reads a file and adds it. Returns its text, or an empty one.
    std::string add(const fs::path& file, const std::string& role) {
        if (!seen_.insert(system::realPath(file).generic_string()).second) return {};
        const std::optional<std::string> text = base::textIn(readable_.open(file), kLargestText);
        if (!text || text->find('\0') != std::string::npos || to_.sources.size() >= kMostSources ||
            size_ + text->size() > kMostText)
            return {};
        size_ += text->size();
        to_.sources.push_back({nameOf(file), role, *text});
        return *text;
    }

    /// Adds a shader and what it includes.
    void addShader(const scene::Scene& scene, const scene::FileReference& file, const std::string& role) {
        std::vector<std::pair<fs::path, std::string>>
            open;  // paths and texts whose #includes are not read yet
        if (file.text)
            open.emplace_back(file.path, *file.text);
        else if (!file.path.empty())
            open.emplace_back(file.path, add(file.path, role));
        const scene::InterpretOptions options{task_.options.libraryRoots, task_.options.within};
        while (!open.empty()) {
            const auto [path, text] = std::move(open.back());
            open.pop_back();
            for (const std::string& each : classroom::includedNames(text)) {
                const fs::path found =
                    scene::findInclude(each, path.generic_string(), scene.path, options, listings_).path;
                if (found.empty()) continue;
                if (std::string included = add(found, "included"); !included.empty())
                    open.emplace_back(found, std::move(included));
            }
        }
    }

  private:
    [[nodiscard]] std::string nameOf(const fs::path& file) const {
        if (std::optional<std::string> inside = below(task_.folder, file)) return *inside;
        for (const fs::path& root : task_.options.libraryRoots)
            if (std::optional<std::string> inside = below(root, file)) return *inside;
        return file.filename().generic_string();
    }

    const DescribeTask& task_;
    Description& to_;
    base::Roots readable_;
    scene::FolderListings listings_;
    std::set<std::string> seen_;
    std::size_t size_ = 0;
};

/// Least, at first, greatest: with one value v they are min(0, v), v and max(1, v) (language, 5.3).
std::vector<double> rangeOf(const std::vector<double>& values) {
    if (values.size() >= 3) return {values[0], values[1], values[2]};
    if (values.size() == 2) return {values[0], values[0], values[1]};
    return {std::min(0., values[0]), values[0], std::max(1., values[0])};
}

void addControls(const scene::Scene& scene, Description& to) {
    using Kind = Control::Kind;
    for (const scene::Variable& each : scene.variables) {
        Control control{{}, each.name, Kind::range, each.written, each.words};
        if (!each.words.empty()) {
            control.kind = Kind::choice;
            control.numbers = each.current;
        } else if (each.form == glib::UniformForm::truth) {
            control.kind = Kind::truth;
        } else if (each.form == glib::UniformForm::color) {
            control.kind = Kind::color;
        } else if (each.form == glib::UniformForm::range && each.current.size() > 1) {
            // A row per component, as in the window.
            for (std::size_t i = 0; i < each.current.size(); ++i)
                to.controls.push_back({{},
                                       each.name + "." + "xyzw" [i],
                                       Kind::range,
                                       { each.least(), each.statedValues()[i], each.largest() },
                                       {}});
            continue;
        } else if (each.form != glib::UniformForm::range) {
            continue;
        }
        to.controls.push_back(std::move(control));
    }
    for (const scene::Program& program : scene.programs)
        for (const glib::UniformSpec& each : program.uniforms) {
            if (each.values.empty() || to.controls.size() >= kMostControls) continue;
            Control control{program.name, each.tag, Kind::range, each.values, {}};
            if (each.form == glib::UniformForm::range)
                control.numbers = rangeOf(each.values);
            else if (each.form == glib::UniformForm::truth)
                control.kind = Kind::truth;
            else if (each.form == glib::UniformForm::color)
                control.kind = Kind::color;
            else
                continue;
            const auto same = std::ranges::find_if(to.controls, [&](const Control& one) {
                return one.owner == control.owner && one.name == control.name;
            });
            if (same != to.controls.end())
                *same = std::move(control);  // of several with the same tag, the last one is used
            else
                to.controls.push_back(std::move(control));
        }
}

/// False if no text of the scene can read the time: neither its own nor those of its shaders name it.
bool namesTime(const std::vector<SourceText>& sources) {
    return std::ranges::any_of(sources, [](const SourceText& each) {
        const std::string text = glib::lower(each.text);
        return text.find("time") != std::string::npos;
    });
}

/// The solution that the exercise's file names, as a path from the folder.
std::string solutionOf(const DescribeTask& task) {
    base::Roots own;
    own.add(task.folder);
    const fs::path file = suite::exerciseFileOf(task.scene);
    const std::optional<std::string> text = base::textIn(own.open(file), kLargestText);
    if (!text || !suite::isExercise(*text)) return {};
    const Result<suite::Exercise> exercise = suite::readExerciseText(*text, file);
    return exercise ? below(task.folder, exercise->solution).value_or(std::string()) : std::string();
}

}  // namespace

Description describe(const DescribeTask& task) {
    Description found;
    Texts texts(task, found);
    found.head = source::headOf(texts.add(task.scene, "scene"));
    found.solution = solutionOf(task);
    render::Stats stats;
    const Result<render::InterpretedScene> read = render::interpretFile(task.scene, task.options, stats);
    if (!read) return found;
    const scene::Scene& scene = read->scene;
    found.width = scene.width;
    found.height = scene.height;
    addControls(scene, found);
    for (const scene::KeyBinding& each : scene.keys)
        if (std::ranges::find(found.keys, each.key) == found.keys.end()) found.keys.push_back(each.key);
    for (const scene::Program& program : scene.programs)
        for (const scene::StageFile& stage : program.stages)
            texts.addShader(scene, scene.files[stage.file],
                            std::string(glsl::stageName(stage.stage)) + " shader");
    found.mayMove = read->changesWithTime() || !scene.steps.empty() || namesTime(found.sources);
    return found;
}

std::string toText(const Description& description) {
    return base::packed(description, base::PackedText::utf8);
}

std::optional<Description> parseDescription(std::string_view text) {
    std::optional<Description> found = base::unpacked<Description>(text);
    if (!found) return std::nullopt;
    found->width = std::clamp(found->width, 0, kLargestPictureSide);
    found->height = std::clamp(found->height, 0, kLargestPictureSide);
    for (const Control& each : found->controls)
        if (each.numbers.empty() || (each.kind == Control::Kind::range && each.numbers.size() != 3))
            return std::nullopt;
    return found;
}

}  // namespace glibra::gallery
