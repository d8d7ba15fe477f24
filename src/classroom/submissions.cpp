#include "classroom/submissions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "classroom/archive.h"
#include "glib/text.h"

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

/// What follows the name of a student if another one has it, too.
std::string numberBesideName(const std::string& number) {
    return fmt::format(" ({})", number);
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
        const auto [known, isNew] =
            flat_.try_emplace(std::pair(person.name, person.number), found_.all.size());
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

}  // namespace

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
    const auto isOther = [&](const fs::path& path) {
        const auto same = [&](const fs::path& other) {
            std::error_code ignored;
            return !other.empty() && fs::equivalent(path, other, ignored);
        };
        return same(options.reference) || std::ranges::any_of(options.others, same);
    };
    for (; !failure && each != fs::directory_iterator(); each.increment(failure))
        if (!each->path().filename().generic_string().starts_with('.') && !isOther(each->path()))
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
    const fs::path whole = fs::weakly_canonical(path, failure);
    const fs::path named = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
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

}  // namespace glibra::classroom
