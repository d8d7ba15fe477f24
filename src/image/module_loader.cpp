#include "image/module_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <new>
#include <system_error>
#include <variant>

#include "base/workers.h"
#include "image/module/abi.h"
#include "system/memory.h"
#include "system/places.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

struct Module {
    GlibraReadPicture read = nullptr;
    GlibraWritePicture write = nullptr;
};

/// A text says why there is no module. OpenImageIO does not survive being unloaded, and is not.
std::variant<Module, std::string> loadModule(std::span<const fs::path> folders) {
    const system::LiftedMemoryLimit lifted;
    std::string why;
    const system::Library library =
        openModule(folders, "glibra_openimageio", "glibraModuleVersion", kGlibraModuleVersion,
                   {"glibraReadPicture", "glibraWritePicture"}, why);
    if (!library) return why;
    return Module{library.find<GlibraReadPicture>("glibraReadPicture"),
                  library.find<GlibraWritePicture>("glibraWritePicture")};
}

Diagnostic noModule(Format format, const FileLabel& label, const std::string& why) {
    return diagnose(
        "file-E03",
        fmt::format("'{}' is {}, but the image module that reads it {}", label.name, describe(format), why),
        label.place);
}

using Message = std::array<char, 500>;

/// Without the name that the module gives a file in memory: ("picture.jpeg").
std::string textOf(const Message& message) {
    const std::string text(message.begin(), std::find(message.begin(), message.end(), '\0'));
    return text.substr(0, text.find(" (\"picture."));
}

/// What the module has read: plain data, which may lie in memory that two processes share.
struct Reading {
    int result = kGlibraFailed;
    bool hasSize = false;
    std::uint64_t width = 0, height = 0;
    Component type = Component::u8;
    Message message{};

    [[nodiscard]] std::size_t bytes() const {
        return static_cast<std::size_t>(width * height * 4 * bytesOf(type));
    }
};

struct ReadingJob {
    GlibraReadPicture read;
    Format format;
    std::span<const std::byte> file;
    const fs::path& path;
    const FileLabel& label;
    const Limits& limits;
};

/// The reason why a picture of this size is not read.
std::optional<Diagnostic> refusal(const Reading& reading, const ReadingJob& job) {
    if (!reading.hasSize) return std::nullopt;
    return checkPacked(reading.width, reading.height, 4 * bytesOf(reading.type), job.file.size(), job.limits,
                       job.label);
}

/// The context of the module's callback.
struct Reception {
    Reading& reading;
    const ReadingJob& job;
    const std::function<void*(std::size_t)>& memory;
};

/// No exception may pass through the module, so a lack of memory rejects the picture like any other problem.
void* receive(void* context, std::uint64_t width, std::uint64_t height, int type) {
    const auto& [reading, job, memory] = *static_cast<Reception*>(context);
    reading.hasSize = true;
    reading.width = width;
    reading.height = height;
    reading.type = type == kGlibraU8 ? Component::u8 : type == kGlibraU16 ? Component::u16 : Component::f32;
    try {
        return refusal(reading, job) ? nullptr : memory(reading.bytes());
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

/// Calls the module. `memory` gives the place for so many bytes of pixels, or null.
void readPixels(const ReadingJob& job, Reading& reading, const std::function<void*(std::size_t)>& memory) {
    Reception reception{reading, job, memory};
    const std::string formatName(openImageIoName(job.format));
    const std::string path = job.path.generic_string();
    GlibraReadRequest request{};
    request.format = formatName.c_str();
    request.path = path.empty() ? nullptr : path.c_str();
    request.bytes = job.file.data();
    request.size = job.file.size();
    request.allocate = receive;
    request.context = &reception;
    request.message = reading.message.data();
    request.messageSize = reading.message.size();
    reading.result = job.read(&request);
}

Result<Image> pictureOf(const Reading& reading, const ReadingJob& job, std::vector<std::byte> pixels) {
    if (reading.result == kGlibraUnknown)
        return noModule(job.format, job.label, "is built without a library for it");
    if (auto refused = refusal(reading, job)) return *std::move(refused);
    if (reading.result == kGlibraDone && pixels.size() == reading.bytes())
        return Image{static_cast<int>(reading.width), static_cast<int>(reading.height), 4, reading.type,
                     std::move(pixels)};
    if (reading.result == kGlibraRefused || reading.result == kGlibraDone)
        return damaged(job.label, "there is not enough memory to read it");
    return damaged(job.label, fmt::format("damaged or short file ({})", textOf(reading.message)));
}

/// A limit of the decoder, and what the user calls it.
struct DecoderTime {
    base::CallLimits limits;
    std::string text;
};

/// In a worker, a picture is given up before the worker is ended, which could not name the file.
DecoderTime inTime(base::CallLimits limits) {
    constexpr double kShare = .9;
    const auto step = base::stepTime();
    if (!step || (limits.seconds > 0 && limits.seconds <= kShare * step->left))
        return {limits, fmt::format("{:g} seconds", limits.seconds)};
    limits.seconds = std::max(.01, kShare * step->left);
    return {limits, fmt::format("{:g} seconds (--timeout)", step->limit)};
}

Diagnostic tooSlow(const FileLabel& label, const DecoderTime& time) {
    return diagnose("file-E11", fmt::format("'{}': not decoded within {}", label.name, time.text),
                    label.place);
}

/// Reads in a thread of this process: a worker that is confined may start no other one, but has limits
/// itself.
Result<Image> readInThread(const ReadingJob& job, const DecoderTime& time) {
    struct Everything {
        std::vector<std::byte> file;
        fs::path path;
        FileLabel label;
        Limits limits;
        Reading reading;
        std::vector<std::byte> pixels;
    };
    const auto all = std::make_shared<Everything>();
    all->file.assign(job.file.begin(), job.file.end());
    all->path = job.path;
    all->label = job.label;
    all->limits = job.limits;
    const bool ended = base::runInThread(time.limits, [all, read = job.read, format = job.format] {
        readPixels({read, format, all->file, all->path, all->label, all->limits}, all->reading,
                   [&](std::size_t bytes) -> void* {
                       all->pixels.resize(bytes);
                       return all->pixels.data();
                   });
    });
    if (!ended) return tooSlow(job.label, time);
    return pictureOf(all->reading, job, std::move(all->pixels));
}

/// Reads in a process of its own. The pixels come back through memory that both processes share.
Result<Image> readContained(const ReadingJob& job, const DecoderTime& time) {
    constexpr std::size_t kPixelsAt = 4096;
    static_assert(sizeof(Reading) <= kPixelsAt);
    const system::SharedMemory shared(kPixelsAt + static_cast<std::size_t>(job.limits.texelBytes));
    if (shared.bytes().empty()) return damaged(job.label, "there is not enough memory to read it");
    auto& reading = *new (shared.bytes().data()) Reading;
    const std::span<std::byte> place = shared.bytes().subspan(kPixelsAt);
    const base::CallEnd end = base::runContained(time.limits, [&] {
        readPixels(job, reading,
                   [&](std::size_t bytes) { return bytes <= place.size() ? place.data() : nullptr; });
    });
    using Kind = base::CallEnd::Kind;
    if (end.kind == Kind::notStarted && base::isWorker()) return readInThread(job, time);
    if (end.kind == Kind::timedOut) return tooSlow(job.label, time);
    if (end.kind != Kind::finished) {
        const std::string how =
            end.signal > 0 ? fmt::format("ended with signal {}", end.signal) : "could not finish";
        return diagnose("file-E11", fmt::format("'{}': its decoder {}", job.label.name, how),
                        job.label.place);
    }
    // From here on this process reads a copy, since the shared one is not trusted.
    const Reading copy = reading;
    std::vector<std::byte> pixels;
    if (copy.result == kGlibraDone && copy.hasSize && !refusal(copy, job)) {
        const auto whole = place.first(std::min(copy.bytes(), place.size()));
        pixels.assign(whole.begin(), whole.end());
    }
    return pictureOf(copy, job, std::move(pixels));
}

/// The result of writing: plain data, as above.
struct Writing {
    int result = kGlibraFailed;
    Message message{};

    [[nodiscard]] std::string text() const {
        if (result == kGlibraRefused) return "there is not enough memory";
        return message.front() == '\0' ? "its encoder crashed" : textOf(message);
    }
};

/// Writes in a process of its own, unless this is a worker that may start none. After a call in this process,
/// a thread of OpenImageIO's pool would end at some later time; a process that is forked while this thread
/// holds the pool's lock would wait for the lock for ever (OpenImageIO before 2.5, its change 3879).
Writing writePixels(GlibraWritePicture write, GlibraWriteRequest request) {
    const auto call = [&](Writing& writing) {
        request.message = writing.message.data();
        request.messageSize = writing.message.size();
        writing.result = write(&request);
    };
    Writing here;
    const system::SharedMemory shared(sizeof(Writing));
    if (shared.bytes().empty()) return here;
    auto& there = *new (shared.bytes().data()) Writing;
    const base::CallEnd end = base::runContained({.seconds = 0, .memory = 0}, [&] { call(there); });
    if (end.kind != base::CallEnd::Kind::notStarted || !base::isWorker()) return there;
    call(here);
    return here;
}

#ifdef GLIBRA_MODULE_BUILD_DIR
bool isBelow(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}
#endif

/// The folder of libraries that a package for Python belongs to: LIB of LIB/python3.11/site-packages/glibra
/// and of LIB/python3/dist-packages/glibra; empty for other folders.
fs::path librariesOfPackage(const fs::path& folder) {
    const fs::path packages = folder.parent_path(), python = packages.parent_path();
    const bool isPackage =
        (packages.filename() == "site-packages" || packages.filename() == "dist-packages") &&
        python.filename().generic_string().starts_with("python");
    return isPackage ? python.parent_path() : fs::path();
}

}  // namespace

system::Library openModule(std::span<const fs::path> folders, std::string_view name, const char* versionOf,
                           int version, std::initializer_list<const char*> functions, std::string& why) {
    why.clear();
    for (const fs::path& folder : folders) {
        const fs::path file = folder / system::moduleName(name);
        std::error_code failed;
        if (!fs::exists(file, failed)) continue;
        std::string problem;
        const auto library =
            system::Library::open(file.generic_string(), system::Library::When::allNow, problem);
        const auto itsVersion = library ? library.find<GlibraModuleVersion>(versionOf) : nullptr;
        const auto has = [&](const char* each) { return library.address(each) != nullptr; };
        if (itsVersion != nullptr && itsVersion() == version && std::ranges::all_of(functions, has))
            return library;
        if (why.empty())
            why = library ? fmt::format("is of another version of glibra: {}", file.generic_string())
                          : fmt::format("cannot be loaded: {}", problem);
    }
    if (why.empty()) why = "is not installed";
    return {};
}

std::vector<fs::path> moduleFoldersOf(const fs::path& program, const fs::path& library) {
    std::vector<fs::path> folders;
    const auto addBelow = [&]([[maybe_unused]] const fs::path& prefix, const fs::path& libraries) {
        folders.push_back(libraries / "glibra");
#ifdef GLIBRA_MODULE_LIBRARY_DIR
        if (const fs::path own = prefix / GLIBRA_MODULE_LIBRARY_DIR; own != folders.back())
            folders.push_back(own);
#endif
    };
    if (program.has_parent_path()) {
        const fs::path prefix = program.parent_path().parent_path();
        folders.push_back(program.parent_path());
        addBelow(prefix, prefix / "lib");
    }
    // Nothing is loaded from the current folder: the name of a library may be relative.
    if (library.is_absolute()) {
        const fs::path folder = library.parent_path();
        folders.push_back(folder / "glibra");
        if (const fs::path libraries = librariesOfPackage(folder); !libraries.empty())
            addBelow(libraries.parent_path(), libraries);
    }
#ifdef GLIBRA_MODULE_BUILD_DIR  // the build defines both if it builds the module
    folders.emplace_back(GLIBRA_MODULE_INSTALL_DIR);
    // Only for the programs and the library of the build tree: whoever may write to the folder in which an
    // installed program was built is not to choose what it loads.
    if (isBelow(program, GLIBRA_MODULE_BUILD_DIR) || isBelow(library, GLIBRA_MODULE_BUILD_DIR))
        folders.emplace_back(GLIBRA_MODULE_BUILD_DIR);
#endif
    return folders;
}

std::vector<fs::path> defaultModuleFolders() {
    // A program of somebody else uses the library, or Python the package; either may have moved.
    return moduleFoldersOf(system::programFile(), system::fileOfThisCode());
}

Result<Image> readByModule(Format format, std::span<const std::byte> file, const fs::path& path,
                           const FileLabel& label, const ReadOptions& options) {
    const auto loaded = loadModule(options.moduleFolders);
    const auto* module = std::get_if<Module>(&loaded);
    if (module == nullptr) return noModule(format, label, std::get<std::string>(loaded));
    const ReadingJob job{module->read, format, file, path, label, options.limits};
    return readContained(job, inTime(options.decoder));
}

Diagnostics writeByModule(const Image& image, Format format, const fs::path& path, const FileLabel& label,
                          const std::string& comment, std::span<const fs::path> moduleFolders) {
    const auto loaded = loadModule(moduleFolders);
    const auto* module = std::get_if<Module>(&loaded);
    if (module == nullptr) return {noModule(format, label, std::get<std::string>(loaded))};

    const bool grey = image.components < 3;
    const Image colors = grey ? withComponents(image, image.components == 2 ? 4 : 3) : Image();
    const Image& source = grey ? colors : image;
    const std::string formatName(openImageIoName(format));
    const std::string name = path.generic_string();
    GlibraWriteRequest request{};
    request.format = formatName.c_str();
    request.path = name.c_str();
    request.width = source.width;
    request.height = source.height;
    request.components = source.components;
    request.keepsAlpha = keepsAlpha(format) ? 1 : 0;
    request.type = source.type == Component::u8    ? kGlibraU8
                   : source.type == Component::u16 ? kGlibraU16
                                                   : kGlibraF32;
    request.pixels = source.data.data();
    request.comment = comment.c_str();
    const Writing written = writePixels(module->write, request);
    if (written.result == kGlibraDone) return {};
    return {
        diagnose("file-E10", fmt::format("cannot write '{}': {}", label.name, written.text()), label.place)};
}

}  // namespace glibra::image
