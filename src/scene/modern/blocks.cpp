// Statements whose effects last: Once and Step (language, 12.8).

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/conditions.h"
#include "scene/modern/modern.h"
#include "scene/run/camera_use.h"
#include "scene/run/evaluate.h"
#include "scene/run/scope.h"
#include "scene/run/selections.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"

namespace glibra::scene {
namespace {

using expression::Depends;

constexpr double kMostStepsPerSecond = 1e9;

/// Runs the statements of a block into its own list of nodes. What the frame has drawn and cleared is put
/// back at the end.
void runBlock(Interpreter& in, const Command& command, OpenBlock& block, NodeList& nodes) {
    const std::size_t index = indexOf(in, command);
    Output outer = std::exchange(in.out, {&nodes});
    in.around.block = &block;
    in.names().beginBlock();
    {
        const Scope scope(in);
        // What has moved and changed the frame so far, perhaps with time, does not act on what lasts.
        in.state.model = glm::dmat4(1);
        in.state.modelView = in.scene.view;
        in.state.local = {};
        resetRaster(in);
        runBody(in, index + 1, command.partner);
    }
    nodes.namedValues = namedValuesOfBlock(in);
    in.names().endBlock(fmt::format("only {} sets it (line {})", block.word, block.place.line));
    in.around.block = nullptr;
    in.out = std::move(outer);
    // The frame depends on the block only through the objects that the block writes.
    constexpr Depends kOfStep = Depends::time | Depends::tick;
    const auto bits = static_cast<std::uint32_t>(block.depends) & ~static_cast<std::uint32_t>(kOfStep);
    in.shared->depends = in.shared->depends | static_cast<Depends>(bits);
    setTime(in);
}

void forgetInputs(Interpreter& in, const std::string& why) {
    for (const char* name : {"mouse", "mouse.down", "frame"}) in.names().forget(name, why);
}

/// The values after `reset`: expressions, or the names of variables and cameras.
std::vector<double> resetValues(Interpreter& in, const KeyedValues& key) {
    std::vector<double> values;
    const auto add = [&](std::span<const double> more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    for (const Value& each : key.values) {
        if (namesCamera(in, each) || choosesCamera(in, each)) {
            const auto camera = cameraNamed(in, each);
            if (!camera) continue;
            const CameraValues now = valuesOf(*camera, 1);
            for (const glm::dmat4* matrix : {&now.view, &now.projection}) add({&(*matrix)[0][0], 16});
        } else if (each.kind == Value::Kind::word) {
            if (const auto value = evaluate(in, each)) add(value->all());
        } else if (const auto numbers = numbersOf(in, {&each, 1})) {
            add(*numbers);
        }
    }
    return values;
}

void doOnce(Interpreter& in, const Command& command) {
    OnceBlock once;
    once.place = in.place(command);
    OpenBlock block;
    block.word = "Once";
    block.place = once.place;
    const std::string why = "what Once writes lasts, so it cannot depend on this";
    forgetInputs(in, why);
    for (const char* name : {"time", "tick", "dt"}) in.names().forget(name, why);
    runBlock(in, command, block, once.nodes);
    once.reads = std::move(block.reads);
    in.scene.once.push_back(std::move(once));
}

void doStep(Interpreter& in, const Command& command) {
    // The statements run even if the rate is wrong, so that their errors are reported at the same time.
    const auto rate = numberOf(in, command.values.front());
    const bool isRight = rate && *rate > 0 && *rate <= kMostStepsPerSecond;
    if (rate && !isRight)
        in.reportAt(
            command.values.front(), "glib-E05",
            fmt::format("Step: the rate {} is not above 0 and at most {}", *rate, kMostStepsPerSecond));
    StepBlock step;
    step.rate = isRight ? *rate : 1;
    step.place = in.place(command);
    OpenBlock block;
    block.word = "Step";
    block.place = step.place;
    block.isStep = true;
    const std::size_t number = in.scene.steps.size();
    const auto of = [&](const std::vector<std::int64_t>& ticks) {
        return static_cast<double>(number < ticks.size() ? ticks[number] : 0);
    };
    const double tick = of(in.inputs.ticks);
    forgetInputs(in, "a step is the same whatever frames are drawn; use a variable");
    in.names().setNumber("tick", std::max(0.0, tick - of(in.inputs.firstTicks)));
    in.names().setNumber("time", tick / step.rate);
    in.names().setNumber("dt", 1 / step.rate);
    if (const KeyedValues* reset = command.key("reset")) {
        in.around.block = &block;  // which depends on what these values depend on
        step.resets = resetValues(in, *reset);
        in.around.block = nullptr;
    }
    runBlock(in, command, block, step.nodes);
    step.dependsOnTick = any(block.depends & (Depends::time | Depends::tick));
    step.fillsDependOnTick = any(block.fillDepends & (Depends::time | Depends::tick));
    if (isRight) in.scene.steps.push_back(std::move(step));
}

}  // namespace

void noteCamera(Interpreter& in, const SceneCamera& camera) {
    OpenBlock* block = in.around.block;
    if (block == nullptr) return;
    const CameraValues values = valuesOf(camera, currentAspect(in));
    for (const glm::dmat4* matrix : {&values.view, &values.projection})
        block->reads.insert(block->reads.end(), &(*matrix)[0][0], &(*matrix)[0][0] + 16);
    noteCameraDepends(in, camera.name);
}

void noteFill(Interpreter& in) {
    OpenBlock* block = in.around.block;
    if (block == nullptr) return;
    if (const auto* symbol = in.names().lookUpInScene(currentCamera(in).name.first + ".view"))
        block->fillDepends = block->fillDepends | in.names().dependsOf(symbol->slot);
}

// ---- Repeat.

namespace {

/// The words over which a Repeat runs.
const std::vector<Value>* wordsOf(const Command& command) {
    const Value& what = command.values.front();
    return what.kind == Value::Kind::list && what.count.empty() ? &what.items : nullptr;
}

/// True for a list of values: numbers, expressions, and variables that are no choices. Any other list is one
/// of words.
bool isListOfValues(const Interpreter& in, std::span<const Value> items) {
    const auto isPlainVariable = [&](const Value& each) {
        const expression::Symbol* const symbol = in.names().lookUp(each.text);
        return symbol != nullptr && symbol->type.kind != expression::Kind::record && symbol->words.empty() &&
               symbol->count == 0;
    };
    return std::ranges::any_of(items, [](const Value& each) { return each.kind != Value::Kind::word; }) ||
           std::ranges::all_of(items, isPlainVariable);
}

/// The values over which a Repeat runs, all of one type. Nothing with the reason reported.
std::optional<std::vector<expression::Value>> repeatedValues(Interpreter& in, std::span<const Value> items) {
    std::vector<expression::Value> values;
    for (const Value& each : items) {
        const auto value = constantOf(in, {&each, 1});
        if (!value) return std::nullopt;
        values.push_back(*value);
        if (value->type == values.front().type) continue;
        return in.reportAt(each, "glib-E33",
                           fmt::format("Repeat: the first value is {}, but this one is {}",
                                       expression::name(values.front().type), expression::name(value->type)));
    }
    return values;
}

/// The names that a Repeat gives each round.
struct RoundNames {
    Environment::Slot counter = 0;
    std::optional<Environment::Slot> index;  ///< NAME.index, if the counter is a word or a value
};

RoundNames bindCounter(Environment& names, const std::string& name, const expression::Symbol& counter,
                       bool hasIndex) {
    RoundNames bound;
    bound.counter = names.bind(name, counter);
    if (hasIndex) bound.index = names.bind(name + ".index", counterSymbol());
    return bound;
}

/// The condition after `until` of a Repeat, which is looked at after each round.
class RoundEnd {
  public:
    RoundEnd(Interpreter& in, const Command& command, double rounds)
        : in_(in), rounds_(static_cast<std::size_t>(std::max(0., rounds))) {
        if (const KeyedValues* key = command.key("until")) value_ = &key->values.front();
        if (value_ != nullptr && in.out.nodes != nullptr) first_ = in.out.nodes->order.size();
        outer_ = in.around.conditions;
    }
    RoundEnd(const RoundEnd&) = delete;
    RoundEnd& operator=(const RoundEnd&) = delete;
    ~RoundEnd() { in_.around.conditions = outer_; }

    /// True if no further round follows. `round` counts from 1.
    bool ends(std::size_t round) {
        if (value_ == nullptr) return false;
        const DependsOnly collected(in_);
        Check check;
        check.condition = {value_, namesOfQuestion(in_, *value_, {.types = kConditionTypes}, false)};
        if (!check.condition.names) return true;
        in_.around.conditions = in_.around.conditions | collected.depends();
        check.kind = Check::Kind::condition;
        check.place = in_.place(*value_);
        check.text = glib::written(*value_);
        if (!check.objects().empty()) return !add(std::move(check), round);
        const auto answer =
            answerTo(*value_, *check.condition.names, check.place.file, {.types = kConditionTypes});
        for (const Diagnostic& each : answer.diagnostics) in_.report(each);
        if (!answer || answer->value.truth()) return true;
        if (round == rounds_) in_.report(notReached(check, rounds_, answer->found));
        return false;
    }

    /// Call it after the last round.
    void finish() {
        if (in_.out.nodes == nullptr) return;
        for (std::size_t i = firstUntil_; i < in_.out.nodes->untils.size() && isOnDevice_; ++i)
            if (Until& each = in_.out.nodes->untils[i]; each.condition.condition.expression == value_)
                each.end = in_.out.nodes->order.size();
    }

  private:
    /// A condition that the device decides. False with the reason reported if it cannot.
    bool add(Check check, std::size_t round) {
        const auto refuse = [&](const std::string& why) {
            in_.reportAt(*value_, "glib-E32", fmt::format("Repeat: 'until {}' {}", check.text, why));
            return false;
        };
        if (!check.condition.names->measures().empty())
            return refuse("measures, as Expect and Print do; it may read elements of buffers");
        Until until;
        until.first = first_;
        until.node = in_.out.nodes->order.size();
        until.round = round;
        until.rounds = rounds_;
        for (const ObjectView& each : check.objects())
            if (const auto* view = std::get_if<BufferView>(&each)) until.reads.push_back(view->buffer);
        if (in_.around.block == nullptr)
            return refuse(fmt::format("reads the buffer '{}', so it stands in Once or Step",
                                      in_.scene.buffers[until.reads.front()].name));
        until.condition = std::move(check);
        NodeList& nodes = *in_.out.nodes;
        if (!std::exchange(isOnDevice_, true)) firstUntil_ = nodes.untils.size();
        in_.out.implicitPass.reset();  // the next round begins a pass of its own
        nodes.untils.push_back(std::move(until));
        return true;
    }

    Interpreter& in_;
    std::size_t rounds_;
    const Value* value_ = nullptr;
    std::size_t first_ = 0, firstUntil_ = 0;
    bool isOnDevice_ = false;
    expression::Depends outer_{};
};

void doRepeat(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    const std::vector<Value>* words = wordsOf(command);
    const KeyedValues* as = command.key("as");
    const std::string name = as != nullptr ? as->values.front().text : "i";
    double rounds = 0;
    std::optional<std::vector<expression::Value>> values;
    expression::Depends depends = expression::Depends::counter;
    if (words != nullptr && isListOfValues(in, *words)) {
        const DependsOnly collected(in);
        values = repeatedValues(in, *words);
        if (!values) return;
        depends = depends | collected.depends();
    }
    if (words != nullptr) {
        rounds = static_cast<double>(words->size());
    } else {
        const auto count = wholeOf(in, command.values.front());
        if (!count) return;
        rounds = *count;
    }
    if (rounds > static_cast<double>(kMostStatements)) {
        in.reportAt(command, "glib-E15",
                    fmt::format("Repeat: {} rounds; the limit is {}", glib::numberText(rounds),
                                base::groupedText(kMostStatements)));
        return;
    }
    if (in.runsAll && words == nullptr) rounds = std::max(rounds, 1.);
    if (rounds < 1) in.modern.untaken.push_back({in.script, index + 1, command.partner});
    expression::Symbol symbol = counterSymbol();
    if (values && !values->empty())
        symbol.type = values->front().type;
    else if (words != nullptr)
        for (const Value& each : *words) symbol.words.push_back(each.text);
    // All rounds have the same names, so they are made once.
    Environment& names = in.names();
    const InnerNames outer(in);
    const RoundNames own = bindCounter(names, name, symbol, words != nullptr);
    std::vector<std::size_t>& path = in.modern.checks.path;
    path.push_back(0);
    RoundEnd end(in, command, rounds);
    for (double round = 0; round < rounds && !in.counts.isFull; ++round) {
        if (!countRound(in, command)) break;
        const Scope scope(in);
        path.back() = static_cast<std::size_t>(round);
        names.setDepends(own.counter, depends);
        if (values)
            names.set(own.counter, (*values)[path.back()].all());
        else
            names.setNumber(own.counter, round);
        if (own.index) names.setNumber(*own.index, round);
        runBody(in, index + 1, command.partner);
        if (end.ends(path.back() + 1)) break;
    }
    end.finish();
    if (command.key("until") != nullptr) addConditions(in, index + 1, command.partner);
    path.pop_back();
}

}  // namespace

std::span<const CommandAction> blockActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::repeat, doRepeat, InList::isPart},
        {CommandId::once, doOnce, InList::isWrong, true},
        {CommandId::endOnce, doNothing, InList::isWrong, true},
        {CommandId::step, doStep, InList::isWrong, true},
        {CommandId::endStep, doNothing, InList::isWrong, true},
    };
    return kActions;
}

}  // namespace glibra::scene
