#pragma once
// Sets every option to a value that is not its default. The value depends only on the kind of the option, so
// a new row is tested without further work.

#include <algorithm>
#include <variant>

#include "suite/options/option_table.h"

namespace glibra::suite::test {

inline void setSample(const OptionRow& row, Shot& shot) {
    static constexpr Matrix kMatrix{1, -2, .1, 1e-30, 5, 6, 7, 8, 9, 10, 1e30, 12, 13, 14, 15.5, -1. / 3};
    struct Setter {
        Shot& shot;
        void operator()(const FlagValue& flag) const { flag.member.edit(shot) = !flag.member.get(Shot{}); }
        void operator()(const WholeValue& whole) const {
            whole.member.edit(shot) = std::min(whole.least + 1, whole.most);
        }
        void operator()(const NumberValue& number) const {
            number.member.edit(shot) = std::clamp(.375, number.least, number.most);
        }
        void operator()(const TimeValue& time) const { time.member.edit(shot) = -1.1; }
        void operator()(const SizeValue& size) const {
            size.width.edit(shot) = 320;
            size.height.edit(shot) = 200;
        }
        void operator()(const WordValue& word) const { word.set(shot, 1); }
        void operator()(const UniformsValue& uniforms) const {
            uniforms.member.edit(shot) = {"uKd=.5", "Dots:uOn=true", "light.color=1,.5,0", "uA={1 .5 0}"};
        }
        void operator()(const MatrixValue& matrix) const { matrix.member.edit(shot) = kMatrix; }
        void operator()(const ObjectsValue& objects) const {
            objects.member.edit(shot) = {{7, kMatrix}, {12, kMatrix}};
        }
        void operator()(const ColorValue& color) const {
            color.member.edit(shot) = std::array{.1, 1. / 3, 1., .5};
        }
        void operator()(const MemoryValue& memory) const {
            memory.member.edit(shot) = std::uint64_t{1536} << 20U;
        }
        void operator()(const FoldersValue& folders) const {
            folders.member.edit(shot) = {"lib one", "lib two"};
        }
    };
    std::visit(Setter{shot}, row.value);
}

}  // namespace glibra::suite::test
