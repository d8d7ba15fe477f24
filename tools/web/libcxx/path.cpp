// The members of std::filesystem::path that Debian's libc++.a for WebAssembly lacks, because WASI by itself
// has no files. Paths follow the rules of POSIX: [fs.path.generic] without root names.

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace {

using View = std::string_view;

/// The element that begins there: the slashes of the root, a name, or the slashes after the last name. Empty
/// at the end.
View elementAt(View path, std::size_t at) {
    if (at >= path.size()) return path.substr(path.size());
    const std::size_t end = path[at] == '/' ? path.find_first_not_of('/', at) : path.find('/', at);
    return path.substr(at, end == View::npos ? end : end - at);
}

View elementAfter(View path, View element) {
    const auto end = static_cast<std::size_t>(element.data() - path.data()) + element.size();
    const std::size_t name = path.find_first_not_of('/', end);
    return elementAt(path, name == View::npos ? end : name);
}

/// The element as a path has it: an empty one for the slashes after the last name.
View textOf(View path, View element) {
    if (element.empty() || element.front() != '/') return element;
    return element.data() == path.data() ? path.substr(0, 1) : View();
}

std::vector<View> elementsOf(View path) {
    std::vector<View> all;
    for (View each = elementAt(path, 0); !each.empty(); each = elementAfter(path, each))
        all.push_back(textOf(path, each));
    return all;
}

}  // namespace

_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM

path::iterator& path::iterator::__increment() {
    __entry_ = elementAfter(__path_ptr_->native(), __entry_);
    __state_ = __entry_.empty() ? _AtEnd : _InFilenames;
    __stashed_elem_ = path(textOf(__path_ptr_->native(), __entry_));
    return *this;
}

path::iterator path::begin() const {
    iterator first;
    first.__path_ptr_ = this;
    first.__entry_ = elementAt(__pn_, 0);
    first.__state_ = first.__entry_.empty() ? iterator::_AtEnd : iterator::_InFilenames;
    first.__stashed_elem_ = path(textOf(__pn_, first.__entry_));
    return first;
}

path::iterator path::end() const {
    iterator last;
    last.__path_ptr_ = this;
    last.__entry_ = View(__pn_).substr(__pn_.size());
    last.__state_ = iterator::_AtEnd;
    return last;
}

View path::__root_name() const {
    return {};
}
View path::__root_directory() const {
    return View(__pn_).substr(0, __pn_.starts_with('/') ? 1 : 0);
}
View path::__root_path_raw() const {
    return __root_directory();
}
View path::__relative_path() const {
    return View(__pn_).substr(std::min(__pn_.find_first_not_of('/'), __pn_.size()));
}
View path::__parent_path() const {
    if (!has_relative_path()) return __pn_;
    std::size_t end = __pn_.rfind('/');
    if (end == View::npos) return {};
    while (end > 0 && __pn_[end - 1] == '/') --end;
    return View(__pn_).substr(0, std::max(end, __root_directory().size()));
}
View path::__filename() const {
    return View(__pn_).substr(__pn_.rfind('/') + 1);
}
View path::__extension() const {
    const View name = __filename();
    const std::size_t dot = name.rfind('.');
    return name == ".." || dot == 0 || dot == View::npos ? View() : name.substr(dot);
}
View path::__stem() const {
    const View name = __filename();
    return name.substr(0, name.size() - __extension().size());
}
path& path::replace_extension(const path& wanted) {
    __pn_.resize(__pn_.size() - __extension().size());
    if (!wanted.empty() && !wanted.native().starts_with('.')) __pn_ += '.';
    __pn_ += wanted.native();
    return *this;
}

int path::__compare(View other) const {
    if (is_absolute() != other.starts_with('/')) return is_absolute() ? 1 : -1;
    const std::vector<View> own = elementsOf(__pn_), others = elementsOf(other);
    for (std::size_t i = 0; i < std::min(own.size(), others.size()); ++i)
        if (const int order = own[i].compare(others[i]); order != 0) return order;
    return own.size() < others.size() ? -1 : own.size() > others.size() ? 1 : 0;
}

path path::lexically_normal() const {
    if (empty()) return *this;
    std::vector<View> kept;
    bool endsInFolder = false;
    for (const View each : elementsOf(__pn_)) {
        if (each == "/") continue;
        endsInFolder = each.empty() || each == "." || each == "..";
        if (each.empty() || each == ".") continue;
        if (each != ".." || (kept.empty() ? !is_absolute() : kept.back() == ".."))
            kept.push_back(each);
        else if (!kept.empty())
            kept.pop_back();
    }
    std::string text(__root_directory());
    for (const View each : kept) text.append(each).append("/");
    const bool keepsSlash = kept.empty() || (endsInFolder && kept.back() != "..");
    if (!keepsSlash) text.pop_back();
    return text.empty() ? path(".") : path(std::move(text));
}

path path::lexically_relative(const path& base) const {
    if (is_absolute() != base.is_absolute()) return {};
    const std::vector<View> own = elementsOf(__pn_), from = elementsOf(base.__pn_);
    const auto [rest, up] = std::mismatch(own.begin(), own.end(), from.begin(), from.end());
    if (rest == own.end() && up == from.end()) return ".";
    std::ptrdiff_t levels = 0;
    for (auto each = up; each != from.end(); ++each)
        levels += *each == ".." ? -1 : each->empty() || *each == "." ? 0 : 1;
    if (levels < 0) return {};
    if (levels == 0 && (rest == own.end() || rest->empty())) return ".";
    path result;
    for (; levels > 0; --levels) result /= "..";
    for (auto each = rest; each != own.end(); ++each) result /= *each;
    return result;
}

_LIBCPP_END_NAMESPACE_FILESYSTEM
