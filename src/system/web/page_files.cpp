// What std::filesystem says of the files of a page: libc++ declares these functions, and Debian's libc++.a
// for WebAssembly has none of them. There are ordinary files and the folders that their names imply; the
// current folder is the root.

#include "system/web/page_files.h"

#include <cerrno>
#include <cstddef>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "system/file.h"
#include "system/folder.h"

namespace glibra::system {

namespace fs = std::filesystem;

PageFiles& pageFiles() {
    static PageFiles files;
    return files;
}

std::string nameInPage(const fs::path& path) {
    std::string name = ("/" / path).lexically_normal().native().substr(1);
    if (name.ends_with('/')) name.pop_back();
    return name;
}

namespace {

/// The names of files below the folder begin with it.
std::string beginOf(const std::string& folder) {
    return folder.empty() ? folder : folder + '/';
}

bool isFolder(const std::string& name) {
    const std::string begin = beginOf(name);
    const auto first = pageFiles().lower_bound(begin);
    return name.empty() || (first != pageFiles().end() && first->first.starts_with(begin));
}

}  // namespace

int factsOf(const fs::path& path, Links /*links*/, FileFacts& facts) {
    facts = {};
    const std::string name = nameInPage(path);
    const auto file = pageFiles().find(name);
    if (file == pageFiles().end() && !isFolder(name)) return ENOENT;
    facts.kind = file != pageFiles().end() ? FileKind::regular : FileKind::folder;
    if (file != pageFiles().end()) facts.size = file->second.size();
    return 0;
}

fs::path asInFolders(const fs::path& path) {
    return path;
}

}  // namespace glibra::system

_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM

namespace {

void tell(error_code* to, errc failed = {}) {
    if (to != nullptr) *to = failed == errc() ? error_code() : make_error_code(failed);
}

}  // namespace

file_status __status(const path& at, error_code* failed) {
    tell(failed);
    switch (kindOf(at, glibra::system::Links::followed)) {
        case glibra::system::FileKind::regular:
            return file_status(file_type::regular, perms::owner_read);
        case glibra::system::FileKind::folder:
            return file_status(file_type::directory, perms::owner_read);
        default:
            tell(failed, errc::no_such_file_or_directory);
            return file_status(file_type::not_found);
    }
}
file_status __symlink_status(const path& at, error_code* failed) {
    return __status(at, failed);
}
path __current_path(error_code* failed) {
    tell(failed);
    return "/";
}
path __absolute(const path& at, error_code* failed) {
    return __current_path(failed) / at;
}
path __weakly_canonical(const path& at, error_code* failed) {
    return __absolute(at, failed).lexically_normal();
}
path __canonical(const path& at, error_code* failed) {
    if (__status(at, failed).type() == file_type::not_found) return {};
    return "/" / path(glibra::system::nameInPage(at));
}
uintmax_t __file_size(const path& at, error_code* failed) {
    glibra::system::FileFacts facts;
    factsOf(at, glibra::system::Links::followed, facts);
    const bool isFile = facts.kind == glibra::system::FileKind::regular;
    tell(failed, isFile ? errc() : errc::no_such_file_or_directory);
    return isFile ? facts.size : static_cast<uintmax_t>(-1);
}
bool __fs_is_empty(const path& at, error_code* failed) {
    return __file_size(at, failed) == 0;
}
/// No file has a time: a FileReader gives contents, which tell what has changed.
file_time_type __last_write_time(const path& /*at*/, error_code* failed) {
    tell(failed, errc::not_supported);
    return file_time_type::min();
}
bool __remove(const path& /*at*/, error_code* failed) {
    tell(failed, errc::read_only_file_system);
    return false;
}

error_code directory_entry::__do_refresh() noexcept {
    __data_.__reset();
    return {};
}

class __dir_stream {
  public:
    vector<directory_entry> entries;
    size_t at = 0;
};

directory_iterator::directory_iterator(const path& folder, error_code* failed,
                                       directory_options /*options*/) {
    const string name = glibra::system::nameInPage(folder);
    tell(failed, glibra::system::isFolder(name) ? errc() : errc::no_such_file_or_directory);
    const string begin = glibra::system::beginOf(name);
    auto stream = make_shared<__dir_stream>();
    const auto& files = glibra::system::pageFiles();
    string last;
    for (auto each = files.lower_bound(begin); each != files.end() && each->first.starts_with(begin);
         ++each) {
        string entry = each->first.substr(begin.size());
        entry.resize(min(entry.find('/'), entry.size()));
        if (entry == last) continue;
        last = entry;
        stream->entries.emplace_back(folder / entry);
    }
    if (!stream->entries.empty()) __imp_ = std::move(stream);
}
const directory_entry& directory_iterator::__dereference() const {
    return __imp_->entries[__imp_->at];
}
directory_iterator& directory_iterator::__increment(error_code* failed) {
    tell(failed);
    if (++__imp_->at == __imp_->entries.size()) __imp_.reset();
    return *this;
}

_LIBCPP_END_NAMESPACE_FILESYSTEM
