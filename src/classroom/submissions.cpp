#include "classroom/submissions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "glib/text.h"
#include "suite/file/selection.h"
#include "system/folder.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

bool isScene(const fs::path& path) {
    return glib::sameWord(path.extension().generic_string(), ".glib");
}

/// "x.glib.txt": editors and mail programs add such endings.
bool isMisnamed(const fs::path& path) {
    return glib::sameWord(path.stem().extension().generic_string(), ".glib");
}

Diagnostic problem(const std::string& text) {
    return withoutId(Severity::error, text);
}

/// True for the reference and what else is no submission. A link to it is one, unless that is its name.
bool isOther(const fs::path& path, const SubmissionOptions& options) {
    std::error_code ignored;
    const bool isLink = fs::is_symlink(path, ignored);
    const auto same = [&](const fs::path& other) {
        return isLink ? path.lexically_normal() == other.lexically_normal()
                      : !other.empty() && fs::equivalent(path, other, ignored);
    };
    return same(options.reference) || std::ranges::any_of(options.others, same);
}

/// Collects what was handed in, entry by entry.
class Collector {
  public:
    Collector(const fs::path& folder, const SubmissionOptions& options) : folder_(folder), options_(options) {
        names_ = options.names;
        names_.readBeside(folder);
    }

    void add(const fs::directory_entry& entry) {
        const fs::path& path = entry.path();
        const std::string name = path.filename().generic_string();
        std::error_code ignored;
        switch (entry.symlink_status(ignored).type()) {
            case fs::file_type::directory:
                if (name != "shaders" && name != "textures") addFolder(path);
                break;
            case fs::file_type::regular:
                addFile(path);
                break;
            case fs::file_type::symlink: {
                Submission made{isScene(path) ? path.stem().generic_string() : name, folder_, {}, {}};
                made.problem = "the submission is a link; expected the folder or the file itself";
                made.key = name;
                found_.all.push_back(std::move(made));
                break;
            }
            default:
                found_.leftOut.push_back(name);
        }
    }

    [[nodiscard]] std::size_t count() const { return found_.all.size(); }

    Submissions take() {
        nameApart();
        std::ranges::sort(found_.all, {}, &Submission::name);
        std::ranges::sort(found_.leftOut);
        return std::move(found_);
    }

  private:
    static Submission of(const Person& person, const std::string& key) {
        Submission made{person.name, {}, {}, {}};
        made.number = person.number;
        made.email = person.email;
        made.isLate = person.isLate;
        made.time = person.time;
        made.members = person.members;
        made.key = key;
        return made;
    }

    void addFolder(const fs::path& path) {
        const std::string key = path.filename().generic_string();
        Submission made = of(names_.split(key).value_or(Person{key, {}}), key);
        made.folder = path;
        findScene(made, options_);
        found_.all.push_back(std::move(made));
    }

    void addFile(const fs::path& path) {
        const std::string key = path.filename().generic_string();
        std::optional<Person> person = names_.split(key);
        if (!person && (isScene(path) || isArchive(path)))
            person = names_.split(path.stem().generic_string());
        if (person) return addPart(path, *person);
        if (!isScene(path) && !isArchive(path) && !isMisnamed(path)) return found_.leftOut.push_back(key);
        Submission& made =
            found_.all.emplace_back(of({path.stem().generic_string(), {}}, path.stem().generic_string()));
        made.folder = folder_;
        if (isScene(path)) {
            made.scene = path;
        } else if (isArchive(path)) {
            made.parts.push_back({path, {}});
        } else {
            made.name = path.stem().stem().generic_string();
            made.key = key;
            made.problem = fmt::format("'{}' is no scene: expected a name that ends with '.glib'", key);
        }
    }

    /// A file of a student whose other files may stand beside it.
    void addPart(const fs::path& path, const Person& person) {
        // Gradescope's names are of one submission each, and its students need not have a number.
        const std::string number =
            names_.book() == GradeBook::gradescope ? path.filename().generic_string() : person.number;
        const auto [known, isNew] = flat_.try_emplace(std::pair(person.name, number), found_.all.size());
        if (isNew) {
            found_.all.push_back(of(person, path.stem().generic_string()));
            found_.all.back().folder = folder_;
        }
        Submission& made = found_.all[known->second];
        made.isLate = made.isLate || person.isLate;
        made.parts.push_back({path, person.file.empty() ? path.filename().generic_string() : person.file});
    }

    /// Two students of one name have their numbers beside it, and a folder 'ana' and a file 'ana.glib' are
    /// two submissions.
    void nameApart() {
        std::map<std::string, std::size_t> counts;
        for (const Submission& each : found_.all) ++counts[each.name];
        for (Submission& each : found_.all) {
            if (counts[each.name] < 2) continue;
            if (!each.number.empty())
                each.name += numberBesideName(each.number);
            else if (each.folder == folder_)
                each.name += each.parts.empty() ? ".glib" : ".zip";
        }
        std::set<std::string> taken;
        for (Submission& each : found_.all)
            for (int i = 2; !taken.insert(each.name).second; ++i) each.name += fmt::format(" ({})", i);
    }

    const fs::path& folder_;
    const SubmissionOptions& options_;
    NameRule names_;
    Submissions found_;
    std::map<std::pair<std::string, std::string>, std::size_t> flat_;
};

/// What is looked at in one submission. A student may hand in a whole disk.
constexpr std::size_t kMostSeen = 20'000;

/// What a folder has, relative to it, in the order of the paths.
struct Contents {
    std::vector<fs::path> scenes;
    std::vector<fs::path> archives;
    std::vector<fs::path> misnamed;  ///< "x.glib.txt"
};

std::string namesOf(const std::vector<const fs::path*>& files) {
    constexpr std::size_t kMostNames = 6;
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), kMostNames); ++i)
        names += fmt::format("{}'{}'", i == 0 ? "" : ", ", files[i]->generic_string());
    return names + (files.size() > kMostNames ? ", ..." : "");
}

std::string namesOf(std::span<const fs::path> files) {
    std::vector<const fs::path*> all;
    for (const fs::path& each : files) all.push_back(&each);
    return namesOf(all);
}

/// `problem` says why the contents may not be all: there are more entries than are looked at, or a folder
/// cannot be listed. What glibra has made, as a page and what was unpacked for it, is left out.
Contents contentsOf(const fs::path& folder, const SubmissionOptions& options, std::string& problem,
                    bool& isUnlisted) {
    Contents found;
    std::error_code failure;
    std::size_t seen = 0;
    fs::recursive_directory_iterator each(folder, failure);
    for (; !failure && each != fs::recursive_directory_iterator(); each.increment(failure)) {
        if (++seen > kMostSeen) {
            problem = fmt::format("the folder has more than {} files and folders", kMostSeen);
            break;
        }
        std::error_code ignored;
        const fs::file_type type = each->symlink_status(ignored).type();
        const fs::path& path = each->path();
        if (path.filename().generic_string().starts_with('.')) {
            if (type == fs::file_type::directory) each.disable_recursion_pending();
            continue;
        }
        if (type == fs::file_type::directory &&
            (each.depth() >= kDeepestFolder || fs::exists(path / kMark, ignored) || isOther(path, options)))
            each.disable_recursion_pending();
        if (type != fs::file_type::regular && type != fs::file_type::symlink) continue;
        std::vector<fs::path>* const list = isScene(path) ? &found.scenes
                                            : type == fs::file_type::regular && isArchive(path)
                                                ? &found.archives
                                            : isMisnamed(path) ? &found.misnamed
                                                               : nullptr;
        if (list && !isOther(path, options)) list->push_back(path.lexically_relative(folder));
    }
    isUnlisted = bool(failure);
    if (isUnlisted)
        problem = fmt::format("the folder, or one in it, cannot be listed: {}", failure.message());
    for (std::vector<fs::path>* list : {&found.scenes, &found.archives, &found.misnamed})
        std::ranges::sort(*list);
    return found;
}

std::string withoutScene(const Contents& contents) {
    std::string text = "the folder has no scene: expected a file whose name ends with '.glib'";
    if (!contents.misnamed.empty())
        text += fmt::format("; found {}, which {} another ending", namesOf(contents.misnamed),
                            contents.misnamed.size() == 1 ? "has" : "have");
    if (!contents.archives.empty())
        text += fmt::format("; found {}, which {} not unpacked", namesOf(contents.archives),
                            contents.archives.size() == 1 ? "is" : "are");
    return text;
}

bool fitsPattern(const std::string& pattern, const fs::path& scene) {
    const bool wholePath = pattern.find('/') != std::string::npos;
    return suite::fits(pattern, wholePath ? scene.generic_string() : scene.filename().generic_string());
}

/// The first pattern that fits some of several scenes leaves these: it is compared with the file name, or
/// with the whole path if it contains a "/". A pattern for the submission itself must fit one. Of several,
/// the first of these rules that leaves exactly one decides: the file with the name of the reference, the
/// file named as the submission, the file that is less deep than all others. The paths are relative to the
/// folder. Null if nothing decides, with the reason in `problem`.
const fs::path* chooseScene(std::span<const fs::path> scenes, const Submission& submission,
                            const SubmissionOptions& options, std::string& problem) {
    std::vector<const fs::path*> left;
    for (const fs::path& each : scenes) left.push_back(&each);
    const auto fitting = [&](const std::string& pattern) {
        std::vector<const fs::path*> fit;
        for (const fs::path& each : scenes)
            if (fitsPattern(pattern, each)) fit.push_back(&each);
        return fit;
    };
    for (const std::string& each : identitiesOf(submission)) {
        const auto own = options.sceneOf.find(each);
        if (own == options.sceneOf.end()) continue;
        const std::vector<const fs::path*> fit = fitting(own->second);
        if (fit.empty()) {
            problem = fmt::format("no scene fits --scene-of '{}={}'; found {}", own->first, own->second,
                                  namesOf(left));
            return nullptr;
        }
        left = fit;
        break;
    }
    if (left.size() == scenes.size() && left.size() > 1)
        for (const std::string& each : options.scenes)
            if (std::vector<const fs::path*> fit = fitting(each); !fit.empty()) {
                left = std::move(fit);
                break;
            }
    if (left.size() == 1) return left.front();
    const auto onlyOne = [&](const auto& fits) -> const fs::path* {
        const auto found = std::ranges::find_if(left, fits);
        return found != left.end() && std::none_of(std::next(found), left.end(), fits) ? *found : nullptr;
    };
    const std::string preferred = options.reference.filename().generic_string();
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return each->filename() == preferred; }))
        return one;
    if (const fs::path* one = onlyOne([&](const fs::path* each) {
            return each->stem() == submission.name || each->stem() == submission.key;
        }))
        return one;
    const auto depth = [](const fs::path* each) { return std::distance(each->begin(), each->end()); };
    const auto least = depth(*std::ranges::min_element(
        left, [&](const fs::path* a, const fs::path* b) { return depth(a) < depth(b); }));
    if (const fs::path* one = onlyOne([&](const fs::path* each) { return depth(each) == least; })) return one;
    problem = fmt::format(
        "the folder has {} scenes: {}; expected one, or one named {}'{}.glib'; --scene chooses", left.size(),
        namesOf(left), preferred.empty() ? "" : fmt::format("'{}' or ", preferred), submission.name);
    return nullptr;
}

}  // namespace

std::string numberBesideName(const std::string& number) {
    return fmt::format(" ({})", number);
}

std::vector<Member> membersOf(const Submission& submission) {
    if (!submission.members.empty()) return submission.members;
    return {{submission.name, submission.number, submission.email}};
}

std::vector<std::string> identitiesOf(const Submission& submission) {
    std::vector<std::string> all{submission.name, submission.number, submission.key};
    if (const std::string end = numberBesideName(submission.number); submission.name.ends_with(end))
        all.push_back(submission.name.substr(0, submission.name.size() - end.size()));
    for (const Member& each : submission.members) {
        all.push_back(each.name);
        all.push_back(each.number);
    }
    std::erase(all, std::string());
    return all;
}

Result<Submissions> findSubmissions(const fs::path& folder, const SubmissionOptions& options) {
    std::error_code failure;
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator each(folder, failure);
    if (failure)
        return problem(fmt::format("cannot read the folder of submissions '{}': {}", folder.generic_string(),
                                   failure.message()));
    for (; !failure && each != fs::directory_iterator(); each.increment(failure))
        if (!each->path().filename().generic_string().starts_with('.') && !isOther(each->path(), options))
            entries.push_back(*each);
    if (failure)
        return problem(fmt::format("cannot read all of the folder of submissions '{}': {}",
                                   folder.generic_string(), failure.message()));
    std::ranges::sort(entries);
    Collector collector(folder, options);
    for (const fs::directory_entry& one : entries) {
        collector.add(one);
        if (collector.count() > kMostSubmissions)
            return problem(
                fmt::format("'{}' has more than {} submissions", folder.generic_string(), kMostSubmissions));
    }
    Submissions found = collector.take();
    if (found.all.empty())
        return problem(
            fmt::format("'{}' has no submissions: expected a folder, a zip file or a .glib file per student",
                        folder.generic_string()));
    return found;
}

Result<Submissions> ownSubmission(const fs::path& path, const SubmissionOptions& options) {
    std::error_code failure;
    const fs::path named = system::realPath(path).filename();
    Submission made{named.stem().generic_string(), path.has_parent_path() ? path.parent_path() : ".", {}, {}};
    if (fs::is_directory(path, failure)) {
        made.name = named.generic_string();
        made.folder = path;
        findScene(made, options);
    } else if (fs::is_regular_file(path, failure) && isScene(path)) {
        made.scene = path;
    } else if (fs::is_regular_file(path, failure) && isArchive(path)) {
        made.parts.push_back({path, {}});
    } else {
        return problem(fmt::format("{} '{}'; expected a folder, a zip file or a .glib file",
                                   fs::exists(path, failure) ? "this is no submission:" : "there is no",
                                   path.generic_string()));
    }
    if (made.name.empty()) made.name = "submission";
    made.key = made.name;
    Submissions found;
    found.all.push_back(std::move(made));
    return found;
}

void findScene(Submission& submission, const SubmissionOptions& options) {
    const Contents found = contentsOf(submission.folder, options, submission.problem, submission.isUnlisted);
    if (!submission.problem.empty()) return;
    if (found.scenes.empty()) {
        // Platforms put the one zip file that was handed in into a folder.
        if (found.archives.size() == 1 && submission.parts.empty())
            submission.parts.push_back({submission.folder / found.archives.front(), {}});
        else
            submission.problem = withoutScene(found);
        return;
    }
    const fs::path* const scene = chooseScene(found.scenes, submission, options, submission.problem);
    if (!scene) return;
    if (std::error_code failure; fs::is_symlink(submission.folder / *scene, failure))
        submission.problem =
            fmt::format("the scene '{}' is a link; expected the file itself", scene->generic_string());
    else
        submission.scene = submission.folder / *scene;
}

bool isArchive(const fs::path& file) {
    return glib::sameWord(file.extension().generic_string(), ".zip");
}

}  // namespace glibra::classroom
