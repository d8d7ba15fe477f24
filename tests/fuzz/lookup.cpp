// Any lines as names of files and patterns of names, looked up in a folder that is made once.

#include <algorithm>
#include <string>
#include <vector>

#include "check.h"
#include "scene/file_lookup.h"
#include "scratch_folder.h"
#include "suite/file/selection.h"
#include "text_mutator.h"

namespace {

namespace fs = std::filesystem;
using namespace glibra;
using fuzz::check;

constexpr const char* kFiles[] = {"scenes/glib/topic/scene.glib",
                                  "scenes/glib/topic/Stage.vert",
                                  "scenes/glib/topic/stage.VERT",
                                  "scenes/glib/topic/sub/Deep/file.frag",
                                  "scenes/glib/topic/sub/DEEP/File.frag",
                                  "scenes/glib/topic/two words.png",
                                  "scenes/glib/topic/C:drive.png",
                                  "scenes/glib/topic/\xc3\xa9t\xc3\xa9.png",
                                  "scenes/glib/topic/.hidden.glib",
                                  "scenes/shaders/topic/stage.frag",
                                  "scenes/shaders/common.glsl",
                                  "scenes/textures/apples.png",
                                  "scenes/scenes/models/cow.obj",
                                  "library/shaders/other.frag",
                                  "library/textures/pears.png"};

struct Tree {
    fuzz::ScratchFolder scratch;
    scene::InterpretOptions options{{scratch.path() / "library"}};
    fs::path scene = scratch.path() / kFiles[0];
    Tree() {
        for (const char* file : kFiles) scratch.write(file, "x");
        std::error_code ignored;
        const fs::path topic = scene.parent_path();
        fs::create_symlink("Stage.vert", topic / "link.vert", ignored);
        fs::create_symlink("nowhere", topic / "dangling.vert", ignored);
        fs::create_directory_symlink(".", topic / "loop", ignored);
    }
};

/// An absolute name as one below the folder, so that the result does not depend on the machine.
std::string inside(std::string_view line, const Tree& tree) {
    return (line.starts_with('/') ? tree.scratch.path().string() : "") + std::string(line);
}

void lookUp(std::string_view name, const Tree& tree, const scene::SearchFolders& folders,
            scene::FolderListings& listings) {
    const scene::FileReference found = scene::findFile(name, {"scene.glib", 1, 1}, folders, listings);
    fuzz::checkMessages(found.remarks);
    check(found.path.empty() == hasError(found.remarks), "a file is found or there is an error");
    check(found.path.empty() || scene::isOrdinaryFile(found.path), "what is found is an ordinary file");
    const scene::FileReference included =
        scene::findInclude(name, (tree.scene.parent_path() / "sub/Deep/file.frag").string(),
                           tree.scene.string(), tree.options, listings);
    fuzz::checkMessages(included.remarks);
    check(included.path.empty() || scene::isOrdinaryFile(included.path),
          "what is included is an ordinary file");
}

void match(std::string_view pattern, const Tree& tree) {
    // An absolute pattern may search the whole disk, and so may one that leaves the folder.
    if (pattern.starts_with('/') || pattern.find("..") != pattern.npos || pattern.find('\0') != pattern.npos)
        return;
    const auto files = suite::filesThatFit(tree.scratch.path(), pattern);
    fuzz::checkMessages(files.diagnostics);
    if (!files) return;
    check(std::ranges::is_sorted(*files), "files are sorted");
    for (const fs::path& file : *files) check(fs::is_regular_file(file), "what fits is a file");
    for (const char* name : kFiles) (void)suite::fits(pattern, name);
    check(suite::isPattern(pattern) || suite::fits(pattern, pattern), "a name without wildcards fits itself");
}

}  // namespace

const fuzz::Grammar& fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        made.words = {
            "..", ".",    "**", "*",  "?",    "[a-z]",     "[!a-z]",        "[",          "]",     "C:",
            "//", "\\\\", "~",  "%s", "loop", "link.vert", "dangling.vert", "stage.vert", "*.glib"};
        made.separators = "/\\ .";
        for (const std::string_view file : kFiles) {
            made.statements.emplace_back(file);
            made.statements.emplace_back(file.substr(file.find('/') + 1));
            made.statements.emplace_back(file.substr(file.rfind('/') + 1));
        }
        for (const char* pattern : {"**/*.glib", "*/*/topic/*", "../topic/scene.glib", "sub/deep/FILE.frag"})
            made.statements.emplace_back(pattern);
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Tree kTree;
    constexpr int kMostNames = 12;
    const scene::SearchFolders folders = scene::searchFolders(kTree.scene, kTree.options);
    scene::FolderListings listings;
    std::string_view text = fuzz::textOf(data, size);
    for (int names = 0; !text.empty() && names < kMostNames; ++names) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lookUp(inside(text.substr(0, end), kTree), kTree, folders, listings);
        match(text.substr(0, end), kTree);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return 0;
}
