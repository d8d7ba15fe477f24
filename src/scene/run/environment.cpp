#include "scene/run/environment.h"

#include <array>
#include <limits>

namespace glibra::scene {
namespace {

using expression::Depends;
using expression::Symbol;
using expression::Type;

Symbol symbolOf(Type type, Depends depends, std::size_t count = 0) {
    Symbol symbol;
    symbol.type = type;
    symbol.depends = depends;
    symbol.count = static_cast<std::uint32_t>(count);
    return symbol;
}

Symbol record(std::string what, std::size_t count = 0) {
    Symbol symbol = symbolOf(Type::record(), Depends::nothing, count);
    symbol.what = std::move(what);
    return symbol;
}

/// The number of elements of a buffer is known when it is read; an expression is checked before.
constexpr std::uint32_t kElementsOfBuffers = 0x7fffffff;
constexpr const char* kWhoReadsElements =
    "only Expect (condition) and Print (expression) read the elements of buffers";

/// The numbers of noteDeclared() for the end of a block, a name that is expected, and a function.
constexpr std::uint64_t kBlockEnds = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kIsExpected = kBlockEnds - 1;
constexpr std::uint64_t kIsFunction = kBlockEnds - 2;

/// True if a name may be declared as both in one frame.
bool isAlike(const Symbol& a, const Symbol& b) {
    return a.type == b.type && a.what == b.what && (a.count == 0) == (b.count == 0) &&
           Environment::isBuffer(a) == Environment::isBuffer(b);
}

std::span<const double> componentsOf(const glm::dmat4& matrix) {
    return {&matrix[0][0], 16};
}
std::span<const double> componentsOf(const glm::dvec3& vector) {
    return {&vector[0], 3};
}

}  // namespace

Environment::Environment() {
    for (const expression::NameRow& each : expression::sceneNames())
        declare(each.path, symbolOf(each.type, each.depends));
    declareCamera("camera");
    declareCamera("eye");
    permanent_ = variables_.size();
}

bool Environment::isBuffer(const Symbol& symbol) {
    return symbol.count == kElementsOfBuffers;
}

Environment::Slot Environment::add(const Symbol& symbol) {
    const auto slot = static_cast<Slot>(variables_.size());
    Variable variable;
    variable.symbol = symbol;
    variable.symbol.slot = slot;
    const std::size_t elements = isBuffer(symbol) ? 0 : std::max<std::size_t>(1, symbol.count);
    variable.components.resize(elements * symbol.type.size());
    variable.has.resize(elements);
    clear(variable);
    variables_.push_back(std::move(variable));
    return slot;
}

void Environment::clear(Variable& variable) {
    std::fill(variable.has.begin(), variable.has.end(), false);
    variable.why = isBuffer(variable.symbol) ? kWhoReadsElements : "";
    variable.depends = Depends::nothing;
    variable.object.reset();
    variable.camera.reset();
}

void Environment::beginFrame() {
    for (Variable& each : variables_) clear(each);
    for (auto& [name, entry] : scene_)
        if (entry.slot && *entry.slot >= permanent_) entry.slot.reset();
    for (auto& [name, entry] : block_) entry.slot.reset();
    isInBlock_ = false;
    expected_.clear();
    functions_.clear();
    node_ = 0;
    callers_.clear();
    declared_ = 0;
}

// ---- The names of the scene.

void Environment::noteDeclared(std::uint64_t what, std::uint64_t how) {
    const auto number = static_cast<std::uint32_t>(afterDeclaring_.size() + 1);
    declared_ = afterDeclaring_.try_emplace({declared_, what, how}, number).first->second;
}

void Environment::expect(std::string_view name) {
    if (!expected_.emplace(name).second) return;
    const std::uint64_t number = expectedNumbers_.size();
    noteDeclared(kIsExpected, expectedNumbers_.try_emplace(std::string(name), number).first->second);
}

std::optional<Environment::Slot> Environment::declareIn(Table& table, std::string_view path,
                                                        const Symbol& symbol) {
    auto known = table.find(path);
    if (known == table.end()) known = table.emplace(std::string(path), Entry{}).first;
    Entry& entry = known->second;
    if (entry.slot && !isAlike(variables_[*entry.slot].symbol, symbol)) return std::nullopt;
    const auto isSlotOf = [&](Slot slot) {
        const Symbol& each = variables_[slot].symbol;
        return isAlike(each, symbol) && each.words == symbol.words && each.depends == symbol.depends;
    };
    const auto found = std::ranges::find_if(entry.slots, isSlotOf);
    const bool isNew = found == entry.slots.end();
    const Slot slot = isNew ? entry.slots.emplace_back(add(symbol)) : *found;
    if (entry.slot == slot && variables_[slot].symbol.count == symbol.count) return slot;
    if (variables_[slot].symbol.count != symbol.count) resize(slot, symbol.count);
    entry.slot = slot;
    noteDeclared(slot, symbol.count);
    return slot;
}

std::optional<Environment::Slot> Environment::declare(std::string_view path, const Symbol& symbol) {
    return declareIn(scene_, path, symbol);
}

std::optional<Environment::Slot> Environment::declareVariable(std::string_view path, const Symbol& symbol) {
    if (!isInBlock_) return declare(path, symbol);
    const Slot* const outer = slotIn(scene_, path);
    if (outer != nullptr && !isAlike(variables_[*outer].symbol, symbol)) return std::nullopt;
    const bool isFirst = slotIn(block_, path) == nullptr;
    const auto slot = declareIn(block_, path, symbol);
    if (!slot || !isFirst) return slot;
    Variable& own = variables_[*slot];
    clear(own);
    if (outer != nullptr && variables_[*outer].symbol.count == own.symbol.count) {
        own.components = variables_[*outer].components;
        own.has = variables_[*outer].has;
        own.depends = variables_[*outer].depends;
    }
    return slot;
}

void Environment::resize(Slot slot, std::uint32_t count) {
    Variable& variable = variables_[slot];
    variable.symbol.count = count;
    variable.components.assign(count * variable.symbol.type.size(), 0);
    variable.has.assign(count, false);
}

void Environment::declareCamera(std::string_view name, std::size_t count) {
    const std::string camera(name);
    declare(camera, record("camera", count));
    declare(camera + ".prev", record("camera", count));
    for (const expression::NameRow& each : expression::cameraFields())
        for (const char* moment : {".", ".prev."})
            declare(camera + moment + std::string(each.path), symbolOf(each.type, each.depends, count));
}

std::optional<Environment::Slot> Environment::declareTexture(std::string_view name, std::size_t components) {
    if (!declare(name, record("texture"))) return std::nullopt;
    return declare(std::string(name) + ".size", symbolOf(Type::vector(components), Depends::texture));
}

bool Environment::declareBuffer(std::string_view name, const std::optional<Type>& element) {
    const bool isNew =
        declare(name, element ? symbolOf(*element, Depends::buffer, kElementsOfBuffers) : record("buffer"))
            .has_value();
    return isNew && declare(std::string(name) + ".count", symbolOf(Type::number(), Depends::buffer));
}

bool Environment::declareMesh(std::string_view name) {
    const auto number = [&](const char* field) {
        return declare(std::string(name) + field, symbolOf(Type::number(), Depends::texture)).has_value();
    };
    return declare(name, record("mesh")) && number(".vertices") && number(".primitives");
}

void Environment::declareFunction(const std::shared_ptr<const expression::Function>& function) {
    if (!functions_.try_emplace(function->name, function).second) return;
    noteDeclared(kIsFunction, reinterpret_cast<std::uintptr_t>(function.get()));
}

void Environment::beginBlock() {
    isInBlock_ = true;
}

void Environment::endBlock(const std::string& why) {
    isInBlock_ = false;
    for (auto& [name, entry] : block_) {
        if (!entry.slot) continue;
        const Symbol symbol = variables_[*entry.slot].symbol;
        entry.slot.reset();
        if (slotIn(scene_, name) != nullptr) continue;
        if (const auto slot = declare(name, symbol)) variables_[*slot].why = why;
    }
    noteDeclared(kBlockEnds, 0);
}

bool Environment::isOfBlock(std::string_view name) const {
    return isInBlock_ && slotIn(block_, name) != nullptr;
}

// ---- The names of scopes.

std::uint32_t Environment::addNode(Node node) {
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void Environment::goTo(Point point) {
    node_ = point.node;
    callers_.resize(point.callers);
}

bool Environment::isActive(std::uint32_t node) const {
    const auto leadsTo = [&](std::uint32_t from) {
        while (from != 0 && from != node) from = nodes_[from].parent;
        return from == node;
    };
    return leadsTo(node_) || std::ranges::any_of(callers_, leadsTo);
}

void Environment::enterGroup(Point declared, const void* owner) {
    // A group that is declared inside of a block sees the names of the block as long as this runs.
    const std::uint32_t around = isActive(declared.node) ? declared.node : 0;
    callers_.push_back(node_);
    std::uint32_t& border = borders_[{around, owner}];
    if (border == 0) border = addNode({around, {}, 0});
    node_ = border;
}

Environment::Slot Environment::bind(std::string_view name, const Symbol& symbol) {
    std::vector<std::uint32_t>& children = children_[{node_, std::string(name)}];
    const auto known = std::ranges::find_if(children, [&](std::uint32_t each) {
        const Symbol& other = variables_[nodes_[each].slot].symbol;
        return other.type == symbol.type && other.what == symbol.what && other.count == symbol.count &&
               other.depends == symbol.depends && other.words == symbol.words;
    });
    if (known == children.end()) {
        const Slot slot = add(symbol);
        node_ = children.emplace_back(addNode({node_, std::string(name), slot}));
        return slot;
    }
    node_ = *known;
    Variable& variable = variables_[nodes_[node_].slot];
    clear(variable);
    return nodes_[node_].slot;
}

void Environment::bind(std::string_view name, Slot slot) {
    // Apart from the names that have slots of their own, whose values bind() forgets.
    std::vector<std::uint32_t>& children = children_[{node_, "=" + std::string(name)}];
    const auto known =
        std::ranges::find_if(children, [&](std::uint32_t each) { return nodes_[each].slot == slot; });
    node_ =
        known != children.end() ? *known : children.emplace_back(addNode({node_, std::string(name), slot}));
}

void Environment::bindCamera(std::string_view name, const CameraName& camera) {
    const auto& [own, element] = camera;
    const std::string to(name);
    variables_[bind(to, record("camera"))].camera = camera;
    bind(to + ".prev", record("camera"));
    for (const expression::NameRow& each : expression::cameraFields())
        for (const char* moment : {".", ".prev."}) {
            const std::string field = moment + std::string(each.path);
            const Slot* const known = slotIn(scene_, own + field);
            if (known == nullptr) continue;
            const Slot source = *known;
            if (variables_[source].symbol.count == 0) {
                bind(to + field, source);
                continue;
            }
            const Slot slot = bind(to + field, symbolOf(each.type, each.depends));
            variables_[slot].depends = variables_[source].depends;
            variables_[slot].why = variables_[source].why;
            if (const double* value = find(source, element)) set(slot, {value, each.type.size()});
        }
}

const Environment::Slot* Environment::slotFrom(std::uint32_t node, std::string_view path,
                                               bool& isHidden) const {
    const std::string_view head = path.substr(0, path.find('.'));
    for (; node != 0; node = nodes_[node].parent) {
        const Node& each = nodes_[node];
        if (each.name == path) return &each.slot;
        if (each.name == head) {
            isHidden = true;
            return nullptr;
        }
    }
    return nullptr;
}

const Environment::Slot* Environment::slotOfCallers(std::string_view path) const {
    if (callers_.empty() || expected_.contains(path.substr(0, path.find('.')))) return nullptr;
    bool isHidden = false;
    for (auto caller = callers_.rbegin(); caller != callers_.rend() && !isHidden; ++caller)
        if (const Slot* slot = slotFrom(*caller, path, isHidden)) return slot;
    return nullptr;
}

bool Environment::asksCallers(std::string_view path) const {
    bool isHidden = false;
    return !callers_.empty() && slotFrom(node_, path, isHidden) == nullptr && !isHidden &&
           sceneSlot(path) == nullptr;
}

std::optional<Environment::Slot> Environment::findOwn(std::string_view name) const {
    bool isHidden = false;
    const Slot* const slot = slotFrom(node_, name, isHidden);
    return slot != nullptr ? std::optional(*slot) : std::nullopt;
}

std::optional<Environment::Slot> Environment::findLocal(std::string_view name) const {
    if (const auto own = findOwn(name)) return own;
    if (sceneSlot(name) != nullptr) return std::nullopt;
    const Slot* const slot = slotOfCallers(name);
    return slot != nullptr ? std::optional(*slot) : std::nullopt;
}

// ---- All names.

const Environment::Slot* Environment::slotIn(const Table& table, std::string_view path) {
    const auto known = table.find(path);
    return known != table.end() && known->second.slot ? &*known->second.slot : nullptr;
}

const Environment::Slot* Environment::sceneSlot(std::string_view path) const {
    if (isInBlock_)
        if (const Slot* slot = slotIn(block_, path)) return slot;
    return slotIn(scene_, path);
}

const Environment::Slot* Environment::slotOf(std::string_view path) const {
    bool isHidden = false;
    if (const Slot* slot = slotFrom(node_, path, isHidden); slot != nullptr || isHidden) return slot;
    if (const Slot* slot = sceneSlot(path)) return slot;
    return slotOfCallers(path);
}

const Symbol* Environment::lookUp(std::string_view path) const {
    const Slot* const slot = slotOf(path);
    return slot != nullptr ? &variables_[*slot].symbol : nullptr;
}

const Symbol* Environment::lookUpInScene(std::string_view path) const {
    const Slot* const slot = sceneSlot(path);
    return slot != nullptr ? &variables_[*slot].symbol : nullptr;
}

std::optional<Symbol> Environment::find(std::string_view path) const {
    const Symbol* const symbol = lookUp(path);
    return symbol != nullptr ? std::optional(*symbol) : std::nullopt;
}

std::optional<Symbol> Environment::findInScene(std::string_view path) const {
    const Symbol* const symbol = lookUpInScene(path);
    return symbol != nullptr ? std::optional(*symbol) : std::nullopt;
}

std::shared_ptr<const expression::Function> Environment::findFunction(std::string_view name) const {
    const auto known = functions_.find(name);
    return known != functions_.end() ? known->second : nullptr;
}

std::vector<std::string> Environment::knownFunctions() const {
    std::vector<std::string> names;
    for (const auto& [name, function] : functions_) names.push_back(name);
    return names;
}

std::vector<std::string> Environment::known(std::string_view path) const {
    std::set<std::string> names;
    const std::string prefix = path.empty() ? std::string() : std::string(path) + ".";
    const auto consider = [&](std::string_view name) {
        if (name.empty() || !name.starts_with(prefix)) return;
        const std::string_view rest = name.substr(prefix.size());
        names.emplace(rest.substr(0, rest.find('.')));
    };
    const auto considerFrom = [&](std::uint32_t node) {
        for (; node != 0; node = nodes_[node].parent) consider(nodes_[node].name);
    };
    for (const Table* table : {&scene_, &block_})
        for (const auto& [name, entry] : *table)
            if (entry.slot) consider(name);
    considerFrom(node_);
    for (const std::uint32_t each : callers_) considerFrom(each);
    return {names.begin(), names.end()};
}

void NotedNames::note(std::string_view path, const std::optional<Symbol>& symbol, Note::Kind kind) const {
    const auto isSame = [&](const Note& each) { return each.path == path && each.kind == kind; };
    if (std::ranges::none_of(notes_, isSame))
        notes_.push_back({std::string(path), symbol ? symbol->slot : 0,
                          symbol ? std::optional(symbol->count) : std::nullopt, kind});
}

std::optional<Symbol> NotedNames::find(std::string_view path) const {
    auto symbol = names_.find(path);
    note(path, symbol, Note::Kind::name);
    return symbol;
}

std::optional<Symbol> NotedNames::findInScene(std::string_view path) const {
    auto symbol = names_.findInScene(path);
    note(path, symbol, Note::Kind::nameOfScene);
    return symbol;
}

std::shared_ptr<const expression::Function> NotedNames::findFunction(std::string_view name) const {
    auto function = names_.findFunction(name);
    note(name, std::nullopt, Note::Kind::function);
    const auto own = std::ranges::find_if(
        notes_, [&](const Note& each) { return each.path == name && each.kind == Note::Kind::function; });
    own->function = function;
    return function;
}

// ---- Values.

void Environment::set(Slot slot, std::span<const double> components, std::size_t element) {
    Variable& variable = variables_.at(slot);
    const std::size_t size = variable.symbol.type.size();
    if (element >= variable.has.size() || components.size() < size) return;
    std::copy_n(components.begin(), size,
                variable.components.begin() + static_cast<std::ptrdiff_t>(element * size));
    variable.has[element] = true;
}

void Environment::set(std::string_view path, std::span<const double> components, std::size_t element) {
    if (const Slot* slot = slotIn(scene_, path)) set(*slot, components, element);
}

void Environment::setCamera(std::string_view name, const CameraValues& values, std::size_t element) {
    const std::string prefix = std::string(name) + ".";
    const glm::dmat4 viewProjection = values.viewProjection(), inverse = values.inverseView(),
                     shadow = values.shadow();
    const glm::dvec3 position = values.position(), direction = values.direction();
    set(prefix + "view", componentsOf(values.view), element);
    set(prefix + "projection", componentsOf(values.projection), element);
    set(prefix + "viewProjection", componentsOf(viewProjection), element);
    set(prefix + "inverseView", componentsOf(inverse), element);
    set(prefix + "shadow", componentsOf(shadow), element);
    set(prefix + "position", componentsOf(position), element);
    set(prefix + "direction", componentsOf(direction), element);
    const std::array numbers{std::pair{"near", values.near}, std::pair{"far", values.far},
                             std::pair{"fov", values.fieldOfView}, std::pair{"aspect", values.aspect}};
    for (const auto& [field, number] : numbers) set(prefix + field, {&number, 1}, element);
}

void Environment::forget(std::string_view path, std::string why) {
    const Slot* const slot = slotIn(scene_, path);
    if (slot == nullptr) return;
    Variable& variable = variables_[*slot];
    std::fill(variable.has.begin(), variable.has.end(), false);
    variable.why = std::move(why);
}

std::string Environment::whyMissing(std::uint32_t slot, std::size_t) const {
    return variables_.at(slot).why;
}

const double* Environment::find(std::uint32_t slot, std::size_t element) const {
    const Variable& variable = variables_.at(slot);
    if (element >= variable.has.size() || !variable.has[element]) return nullptr;
    return &variable.components[element * variable.symbol.type.size()];
}

std::vector<double> Environment::valuesOf(Slot slot) const {
    const Variable& variable = variables_.at(slot);
    const std::size_t size = variable.symbol.type.size();
    std::vector<double> values;
    for (std::size_t i = 0; i < variable.has.size(); ++i) {
        if (!variable.has[i]) continue;
        const auto first = variable.components.begin() + static_cast<std::ptrdiff_t>(i * size);
        values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(size));
    }
    return values;
}

}  // namespace glibra::scene
