#include "plan/type_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "glib/limits.h"

namespace glibra::plan {
namespace {

using glib::UniformForm;

bool isReal(const ValueType& type) {
    return type.base == BaseType::floating || type.base == BaseType::doublePrecision;
}

/// The value as messages quote it: "range < 0 0 1 >", "list [ 1 2 ]", "colour { 1 .5 0 }", "<true>", "5".
std::string quote(const GivenValue& given) {
    if (!given.typed.empty()) return fmt::format("--set {}={}", given.tag, given.typed);
    constexpr std::size_t kMostShown = 6;
    if (given.form == UniformForm::truth) return given.values.front() != 0 ? "<true>" : "<false>";
    std::string numbers;
    for (const double each : given.values.first(std::min(kMostShown, given.values.size())))
        numbers += (numbers.empty() ? "" : " ") + numberText(each);
    if (given.values.size() > kMostShown) numbers += " ...";
    switch (given.form) {
        case UniformForm::list:
            return "list [ " + numbers + " ]";
        case UniformForm::range:
            return "range < " + numbers + " >";
        case UniformForm::color:
            return "colour { " + numbers + " }";
        case UniformForm::number:
        case UniformForm::truth:
            break;
    }
    return numbers;
}

const char* brackets(UniformForm form) {
    switch (form) {
        case UniformForm::list:
            return "[ ]";
        case UniformForm::color:
            return "{ }";
        default:
            return "< >";
    }
}

struct Range {
    double minimum = 0, current = 0, maximum = 1;
};

/// Reads one value for one uniform. Every member function adds to `reading_`.
class ValueReader {
  public:
    ValueReader(const GivenValue& given, const ActiveUniform& uniform, bool oneElement, int declaredElements)
        : given_(given),
          type_(uniform.type),
          array_(uniform.isArray && !oneElement),
          elements_(static_cast<std::size_t>(std::max(uniform.arraySize, 1))),
          declared_(std::max(elements_, static_cast<std::size_t>(std::max(declaredElements, 0)))) {
        typeName_ = type_.word;
        if (array_) typeName_ += fmt::format("[{}]", declared_);
    }

    Reading read() && {
        if (given_.values.empty()) {
            warn("glib-W17", fmt::format("tag '{}' has no value; it is skipped", given_.tag),
                 given_.tagPlace);
            reading_.ignored = true;
        } else if (array_) {
            readArray();
        } else {
            readElement();
        }
        return std::move(reading_);
    }

  private:
    std::size_t components() const { return static_cast<std::size_t>(std::max(type_.components(), 1)); }
    double first() const { return given_.values.front(); }

    void warn(const char* id, std::string text, const Place& place) {
        reading_.diagnostics.push_back(diagnose(id, std::move(text), place));
    }
    void warnCount(const std::string& text) {
        const std::string values = base::counted(given_.values.size(), "value");
        const std::string what = given_.typed.empty()
                                     ? fmt::format("{}: {} in {}", given_.tag, values, brackets(given_.form))
                                     : fmt::format("--set {}={}: {}", given_.tag, given_.typed, values);
        warn("glib-W15", fmt::format("{}; {}", what, text), given_.valuePlace);
    }
    /// Reports glib-W20 once per value: the value's form does not fit the type.
    void warnForm(const std::string& outcome) {
        if (reportedForm_) return;
        reportedForm_ = true;
        warn("glib-W20", fmt::format("{} is {}, so {} is {}", given_.tag, typeName_, quote(given_), outcome),
             given_.valuePlace);
    }
    void ignore() {
        warnForm("ignored");
        reading_.ignored = true;
        reading_.values.clear();
    }

    /// Converts one number to a component of the type.
    double convert(double value) {
        if (type_.base == BaseType::boolean) return value != 0 ? 1 : 0;
        if (type_.base == BaseType::floating && !base::fitsFloat(value)) {
            if (!std::exchange(reading_.ignored, true))
                warn("glib-E31",
                     fmt::format("{}: {} is too large for a 32-bit float", given_.tag, numberText(value)),
                     given_.valuePlace);
            return 0;
        }
        if (!type_.isInteger() && !type_.isOpaque()) return value;
        const auto [cut, isCut] = base::wholeNumber(value);
        if (isCut && !std::exchange(reportedCut_, true)) {
            warn("glib-W27", fmt::format("{} is cut to {}", numberText(value), numberText(cut)),
                 given_.valuePlace);
        }
        if (type_.isOpaque()) return cut;
        const bool isSigned = type_.base == BaseType::integer;
        const double lowest = isSigned ? std::numeric_limits<std::int32_t>::min() : 0;
        const double highest =
            isSigned ? std::numeric_limits<std::int32_t>::max() : std::numeric_limits<std::uint32_t>::max();
        const double kept = std::clamp(cut, lowest, highest);
        if (kept != cut && !reportedForm_) {
            reportedForm_ = true;
            warn("glib-W20",
                 fmt::format("{} is {}, so {} is read as {:.0f}", given_.tag, type_.word, numberText(value),
                             kept),
                 given_.valuePlace);
        }
        return kept;
    }

    void setAll(double value) { reading_.values.assign(components(), convert(value)); }
    void setDiagonal(double value) {
        reading_.values.assign(components(), 0);
        const auto rows = static_cast<std::size_t>(type_.rows);
        const auto diagonal = static_cast<std::size_t>(std::min(type_.columns, type_.rows));
        for (std::size_t i = 0; i < diagonal; ++i) reading_.values.at(i * rows + i) = convert(value);
    }
    /// Sets the first `wanted` of the given values; missing ones are 0.
    void setList(std::size_t wanted, bool countMatters) {
        const std::size_t given = given_.values.size();
        const std::size_t declared = array_ ? declared_ * components() : wanted;
        if (countMatters && given < declared)  // whatever the driver calls active
            warnCount(fmt::format("{} takes {}, so the rest is 0", typeName_, declared));
        if (countMatters && given > declared)
            warnCount(fmt::format("{} takes {}, so the surplus is ignored", typeName_, declared));
        reading_.values.assign(wanted, 0);
        for (std::size_t i = 0; i < std::min(given, wanted); ++i)
            reading_.values[i] = convert(given_.values[i]);
    }

    /// Reads a range. One, two, or more than three values are read by the rules of glib-W15.
    Range readRange() {
        const std::span<const double> values = given_.values;
        Range range;
        if (values.size() >= 3) {
            range = {values[0], values[1], values[2]};
            if (values.size() > 3) warnCount("the surplus is ignored");
            return range;
        }
        if (values.size() == 1)
            range = {std::min(0.0, values[0]), values[0], std::max(1.0, values[0])};
        else
            range = {values[0], values[1], std::max(values[0], values[1])};
        if (type_.base == BaseType::boolean)
            warnCount(fmt::format("read as {}", range.current != 0 ? "true" : "false"));
        else
            warnCount(fmt::format("read as minimum {}, current {}, maximum {}", numberText(range.minimum),
                                  numberText(range.current), numberText(range.maximum)));
        return range;
    }

    void readElement() {
        if (type_.isOpaque()) return readUnit();
        if (type_.base == BaseType::other) return ignore();
        if (type_.columns > 1) return readMatrix();
        if (type_.rows > 1) return readVector();
        if (type_.base == BaseType::boolean) return readBool();
        readNumber();
    }

    void readNumber() {
        switch (given_.form) {
            case UniformForm::number:
                return setAll(first());
            case UniformForm::range:
                return readSlider();
            case UniformForm::truth:
                setAll(first() != 0 ? 1 : 0);
                if (isReal(type_)) warnForm("read as " + numberText(reading_.values.front()));
                reading_.control = Control{{}, UniformForm::truth, 0, reading_.values.front(), 1};
                return;
            case UniformForm::list:
            case UniformForm::color:
                break;
        }
        const double value = type_.isInteger() ? base::wholeNumber(first()).value : first();
        warnForm("read as " +
                 numberText(type_.base == BaseType::unsignedInteger ? std::max(value, 0.0) : value));
        setAll(first());
    }

    void readSlider() {
        const Range range = readRange();
        setAll(range.current);
        Control control{
            {}, UniformForm::range, convert(range.minimum), reading_.values.front(), convert(range.maximum)};
        if (control.minimum > control.maximum) {
            warn("glib-W22",
                 fmt::format("{}: minimum {} is above maximum {}; they are exchanged", given_.tag,
                             numberText(control.minimum), numberText(control.maximum)),
                 given_.valuePlace);
            std::swap(control.minimum, control.maximum);
        } else if (control.minimum == control.maximum) {
            control.maximum = control.minimum + 1;
            warn("glib-W22",
                 fmt::format("{}: minimum and maximum are both {}; the slider shows {} ... {}", given_.tag,
                             numberText(control.minimum), numberText(control.minimum),
                             numberText(control.maximum)),
                 given_.valuePlace);
        }
        if (control.current < control.minimum || control.current > control.maximum)
            warn("glib-W21",
                 fmt::format("{}: current value {} is outside {} ... {}; it is kept", given_.tag,
                             numberText(control.current), numberText(control.minimum),
                             numberText(control.maximum)),
                 given_.valuePlace);
        reading_.control = control;
    }

    void readBool() {
        double value = first();
        if (given_.form == UniformForm::range) {
            value = readRange().current;
            if (given_.values.size() == 1) reportedForm_ = true;  // glib-W15 already says how it is read
        }
        setAll(value);
        const bool isTrue = reading_.values.front() != 0;
        if (given_.form != UniformForm::number && given_.form != UniformForm::truth)
            warnForm(isTrue ? "read as true" : "read as false");
        if (given_.form == UniformForm::range || given_.form == UniformForm::truth)
            reading_.control = Control{{}, UniformForm::truth, 0, isTrue ? 1.0 : 0.0, 1};
    }

    void readVector() {
        switch (given_.form) {
            case UniformForm::list:
                return readComponents();
            case UniformForm::color:
                return readColor();
            case UniformForm::range:
                setAll(readRange().current);
                break;
            case UniformForm::number:
                setAll(first());
                break;
            case UniformForm::truth:
                setAll(first() != 0 ? 1 : 0);
                break;
        }
        warnForm(fmt::format("read as {} for all components", numberText(reading_.values.front())));
    }

    /// Three numbers for a vec4 on the command line are a colour, as 0,1,0, which is opaque as in the color
    /// form.
    void readComponents() {
        const bool isTypedColor = !given_.typed.empty() && given_.values.size() == 3 && components() == 4 &&
                                  type_.base == BaseType::floating;
        if (!isTypedColor) return setList(components(), true);
        warnCount(fmt::format("{} takes 4, so the last one is 1", typeName_));
        setList(components(), false);
        reading_.values[3] = 1;
    }

    void readColor() {
        const bool takesColor = type_.base == BaseType::floating && components() >= 3;
        if (!takesColor) {
            warnForm("read as its components");
            return setList(components(), false);
        }
        const std::size_t count = given_.values.size();
        if (count < 3) warnCount("missing components are 0");
        if (count > 4) warnCount("the surplus is ignored");
        setList(components(), false);
        if (components() == 4 && count < 4) reading_.values[3] = 1;
        reading_.control = Control{{}, UniformForm::color, 0, 0, 1};
    }

    void readMatrix() {
        switch (given_.form) {
            case UniformForm::list:
                return setList(components(), true);
            case UniformForm::truth:
            case UniformForm::color:
                return ignore();
            case UniformForm::number:
                setDiagonal(first());
                break;
            case UniformForm::range:
                setDiagonal(readRange().current);
                break;
        }
        warnForm("read as a diagonal");
    }

    /// Checks units of the language; a number that is not a unit is an error.
    void checkUnits() {
        for (const double unit : reading_.values) {
            if (unit >= 0 && unit <= glib::kHighestUnit) continue;
            reading_.diagnostics.push_back(diagnose(
                "glib-E12",
                fmt::format("texture unit {} is not between 0 and {}", numberText(unit), glib::kHighestUnit),
                given_.valuePlace));
            reading_.ignored = true;
            reading_.values.clear();
            return;
        }
    }

    void readUnit() {
        if (given_.form == UniformForm::truth || given_.form == UniformForm::color) return ignore();
        setAll(given_.form == UniformForm::range ? readRange().current : first());
        if (given_.form != UniformForm::number)
            warnForm(fmt::format("read as unit {}", numberText(reading_.values.front())));
        checkUnits();
    }

    void readArray() {
        if (given_.form == UniformForm::list && type_.base != BaseType::other) {
            // The driver takes what it keeps of it.
            setList((type_.isOpaque() ? elements_ : declared_) * components(), true);
            if (type_.isOpaque()) checkUnits();
            return;
        }
        const bool hasReading = type_.base != BaseType::other &&
                                (given_.form == UniformForm::number || given_.form == UniformForm::range ||
                                 (!type_.isOpaque() && type_.columns == 1));
        if (!hasReading) return ignore();
        warnForm("read as its first element");
        readElement();
        reading_.control.reset();
    }

    const GivenValue& given_;
    const ValueType& type_;
    bool array_;
    std::size_t elements_, declared_;  ///< that the driver keeps, and that the shader declares
    std::string typeName_;
    bool reportedForm_ = false;
    bool reportedCut_ = false;
    Reading reading_;
};

}  // namespace

Reading readValue(const GivenValue& given, const ActiveUniform& uniform, bool oneElement,
                  int declaredElements) {
    return ValueReader(given, uniform, oneElement, declaredElements).read();
}

std::string numberText(double value) {
    std::string text = fmt::format("{}", value);
    const std::size_t digits = text.starts_with('-') ? 1 : 0;
    if (text.size() > digits + 2 && text[digits] == '0' && text[digits + 1] == '.') text.erase(digits, 1);
    return text;
}

}  // namespace glibra::plan
