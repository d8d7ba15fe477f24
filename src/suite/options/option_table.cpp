#include "suite/options/option_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <type_traits>

#include "glib/number.h"

namespace glibra::suite {
namespace {

/// The part of a shot, const or not, that has the members of Owner.
template <class Owner>
auto& partOf(auto& shot) {
    if constexpr (std::is_same_v<Owner, ViewState>)
        return shot.options.viewState;
    else if constexpr (std::is_same_v<Owner, RenderOptions>)
        return shot.options;
    else
        return shot;  // NOLINT(bugprone-return-const-ref-from-parameter)
}

template <auto kMember>
struct MemberOf;
template <class Owner, class T, T Owner::* kMember>
struct MemberOf<kMember> {
    static const T& get(const Shot& shot) { return partOf<Owner>(shot).*kMember; }
    static T& edit(Shot& shot) { return partOf<Owner>(shot).*kMember; }
    static constexpr ShotMember<T> kAccess{get, edit};

    static int getIndex(const Shot& shot) { return static_cast<int>(get(shot)); }
    static void setIndex(Shot& shot, int index) { edit(shot) = static_cast<T>(index); }
};

template <auto kMember>
constexpr auto kTo = MemberOf<kMember>::kAccess;

/// `words` in the order of the enumeration.
template <auto kMember>
constexpr WordValue oneOf(std::span<const std::string_view> words) {
    return {words, MemberOf<kMember>::getIndex, MemberOf<kMember>::setIndex};
}

constexpr std::array<std::string_view, 2> kViewWords{"auto", "glman"};
constexpr std::array<std::string_view, 3> kProjectionWords{"scene", "perspective", "orthographic"};

constexpr std::array<std::string_view, 5> kCornerWords{"none", "bottom-left", "bottom-right", "top-left",
                                                       "top-right"};

using Options = RenderOptions;

/// The row as one that --help leaves out.
constexpr OptionRow rare(OptionRow row) {
    row.isRare = true;
    return row;
}
/// The row as one that may be given for all shots of a suite.
constexpr OptionRow withSuite(OptionRow row) {
    row.withSuite = true;
    return row;
}

/// The row as one that a loaded scene keeps.
constexpr OptionRow kept(OptionRow row) {
    row.isKept = true;
    return row;
}
/// The row as one that the window has.
constexpr OptionRow inWindow(OptionRow row) {
    row.inWindow = true;
    return row;
}

constexpr OptionRow kRows[] = {
    {"size", "size", SizeValue{kTo<&Options::width>, kTo<&Options::height>, kLargestPictureSide},
     "size of the picture in pixels instead of the scene's WindowSize"},
    {"time", "time", TimeValue{{kTo<&Options::time>, -1e9, 1e9}}, "seconds since the start of the scene"},
    rare(kept({"steps", "steps", WholeValue{kTo<&Options::steps>, 0, 1'000'000'000},
               "steps of Step blocks that one picture may need"})),
    kept({"set", "set", UniformsValue{kTo<&Options::set>},
          "give a uniform variable or a variable of the scene a value, as uKd=.5 or uColor=1,.5,0; may be "
          "repeated"}),
    inWindow(kept({.name = "eye",
                   .key = "eye",
                   .value = oneOf<&Options::view>(kViewWords),
                   .help = "auto moves the eye out of the objects of the scene, glman leaves it where it is",
                   .former = "view"})),
    {"samples", "samples", WholeValue{kTo<&Options::samples>, 1, kMostSamples}, "samples per pixel"},
    rare({"max-error", "max-error",
          NumberValue{kTo<&Options::maxError>, kLeastMaxError, kLargestMaxError, "px"},
          "choose the slices, stacks, samples and noise sizes that the scene leaves open so that nothing is "
          "drawn more than N pixels from its place"}),
    rare({"override-counts", "override-counts", FlagValue{kTo<&Options::overrideCounts>},
          "with --max-error: choose also the counts and tessellation levels that the scene states",
          "max-error"}),
    inWindow(
        {"axes", "axes", FlagValue{kTo<&Options::axes>}, "draw the axes of world space, 1.5 units long"}),
    {"labels", "labels", oneOf<&Options::labels>(kCornerWords),
     "write the values of the uniform variables over the picture, as 'Dots : uKd = 0.5000', in this corner"},
    {"alpha", "alpha", FlagValue{kTo<&Options::alpha>}, "keep the window's alpha in the picture"},
    {"", "float", FlagValue{kTo<&Options::floatPixels>},
     "32-bit float pixels, not limited to 0..1, in an .exr file"},
    kept({"strict", "strict", FlagValue{kTo<&Options::strict>}, "treat warnings as errors"}),
    {"incomplete", "", FlagValue{kTo<&Options::incomplete>},
     "draw what does not need the files that are missing or wrong, with a striped border; the exit "
     "status is 3 all the same"},
    rare(kept({"no-shim", "shim", FlagValue{kTo<&Options::shim>, false},
               "compile the shaders as they are, without translating their dialect"})),
    rare({"scene-transform", "scene-transform", MatrixValue{kTo<&ViewState::scene>},
          "Projection becomes Projection * M"}),
    rare({"eye-transform", "eye-transform", MatrixValue{kTo<&ViewState::eye>},
          "ModelView becomes M * ModelView"}),
    rare({"texture-transform", "texture-transform", MatrixValue{kTo<&ViewState::texture>},
          "gl_TextureMatrix[0] becomes M"}),
    rare({"object-transform", "object-transform", ObjectsValue{kTo<&ViewState::objects>},
          "ModelView becomes ModelView * M for the object on that line of the scene; may be repeated"}),
    rare({"projection", "projection", oneOf<&ViewState::projection>(kProjectionWords),
          "the scene's own projections, or one of these for all"}),
    {"background", "background", ColorValue{kTo<&ViewState::background>},
     "background color instead of the scene's"},
    rare({"tile", "tile", WholeValue{kTo<&Options::tileSize>, 16, 16384},
          "side of the tiles of large pictures in pixels"}),
    kept({"library", "library", FoldersValue{kTo<&Options::libraryRoots>},
          "folder to search for the files of the scene, before those of GLIBRA_PATH; may be repeated"}),
    withSuite({"timeout", "timeout", NumberValue{kTo<&Shot::timeout>, 0, 1e6},
               "seconds that one picture may take; 0 means no limit"}),
    rare(withSuite(
        {"memory", "memory", MemoryValue{kTo<&Shot::memory>},
         "memory that a process that works on pictures may take, as 512M or 2G; 0 means no limit; by "
         "default half of the machine's, divided by the processes, but at least 2G"})),
    {"check-nan", "", FlagValue{kTo<&Options::checkNan>},
     "name the draws that put NaN or infinity into the picture, or lose vertices by it"},
    withSuite({"check-undefined", "", FlagValue{kTo<&Options::checkUndefined>},
               "find subscripts outside of arrays, fetches outside of textures, vertices beyond max_vertices "
               "and divisions by uniforms that are 0"}),
    rare(kept(
        withSuite({"no-skip", "", FlagValue{kTo<&Options::skip>, false},
                   "read, make and draw also what the picture does not need; the picture stays the same"}))),
};

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

std::string range(double least, double most) {
    return fmt::format("{} to {}", glib::numberText(least), glib::numberText(most));
}

}  // namespace

std::span<const OptionRow> optionTable() {
    return kRows;
}

const OptionRow* findOption(std::string_view name) {
    for (const OptionRow& row : kRows)
        if (!name.empty() && (row.name == name || row.former == name)) return &row;
    return nullptr;
}

const OptionRow* findOptionKey(std::string_view key) {
    for (const OptionRow& row : kRows)
        if (!key.empty() && (row.key == key || row.former == key)) return &row;
    return nullptr;
}

const OptionRow& optionNamed(std::string_view name) {
    if (const OptionRow* row = findOption(name)) return *row;
    throw std::logic_error(
        fmt::format("'{}' is named as an option, but src/suite/options/option_table.cpp has none", name));
}

bool isDefault(const OptionRow& row, const Shot& shot) {
    static const Shot kDefault;
    return std::visit(
        Overloaded{
            [&](const SizeValue& size) { return size.width.get(shot) == 0 || size.height.get(shot) == 0; },
            [&](const WordValue& word) { return word.get(shot) == word.get(kDefault); },
            [&](const auto& value) { return value.member.get(shot) == value.member.get(kDefault); }},
        row.value);
}

void giveToAll(const Shot& stated, Shot& shot) {
    for (const OptionRow& row : kRows)
        if (row.withSuite && !isDefault(row, stated))
            std::visit(
                Overloaded{[&](const SizeValue& size) {
                               size.width.edit(shot) = size.width.get(stated);
                               size.height.edit(shot) = size.height.get(stated);
                           },
                           [&](const WordValue& word) { word.set(shot, word.get(stated)); },
                           [&](const auto& value) { value.member.edit(shot) = value.member.get(stated); }},
                row.value);
}

std::string placeholder(const OptionRow& row) {
    return std::visit(
        Overloaded{[](const FlagValue&) { return std::string(); },
                   [](const WholeValue&) { return std::string("N"); },
                   [](const NumberValue& number) { return "N" + std::string(number.unit); },
                   [](const TimeValue&) { return std::string("SECONDS"); },
                   [](const SizeValue&) { return std::string("WxH"); },
                   [](const WordValue& word) { return fmt::format("{}", fmt::join(word.words, "|")); },
                   [](const UniformsValue&) { return std::string("NAME=VALUE"); },
                   [](const MatrixValue&) { return std::string("M"); },
                   [](const ObjectsValue&) { return std::string("LINE:M"); },
                   [](const ColorValue&) { return std::string("R,G,B[,A]"); },
                   [](const MemoryValue&) { return std::string("SIZE"); },
                   [](const FoldersValue&) { return std::string("FOLDER"); }},
        row.value);
}

std::string limits(const OptionRow& row) {
    return std::visit(
        Overloaded{[](const WholeValue& whole) { return range(whole.least, whole.most); },
                   [](const NumberValue& number) { return range(number.least, number.most); },
                   [](const TimeValue& time) { return range(time.least, time.most); },
                   [](const SizeValue& size) { return range(1, size.most) + " each"; },
                   [](const MatrixValue&) { return std::string("16 numbers, column by column"); },
                   [](const ObjectsValue&) { return std::string("16 numbers, column by column"); },
                   [](const auto&) { return std::string(); }},
        row.value);
}

std::string defaultText(const OptionRow& row) {
    static const Shot kDefault;
    return std::visit(
        Overloaded{[&](const FlagValue& flag) {
                       return std::string(flag.member.get(kDefault) == flag.whenGiven ? "on" : "off");
                   },
                   [&](const NumberValue& number) {
                       const double value = number.member.get(kDefault);
                       return value < number.least || value == 0 ? std::string() : glib::numberText(value);
                   },
                   [&](const TimeValue& time) { return glib::numberText(time.member.get(kDefault)); },
                   [&](const WordValue& word) {
                       return std::string(word.words[static_cast<std::size_t>(word.get(kDefault))]);
                   },
                   [](const auto&) { return std::string(); }},
        row.value);
}

}  // namespace glibra::suite
