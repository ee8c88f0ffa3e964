#include "host/import/aifs/aifs_evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

#include "host/import/aifs/aifs_functions.hpp"
#include "host/import/aifs/aifs_scope.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr long most_steps = 5'000'000;  // parts of expressions that are computed
constexpr int deepest = 1'000;          // of them inside one another, through names and calls
constexpr std::size_t most_dimensions = 32;
constexpr std::size_t most_calls = 100'000;

class Evaluator {
  public:
    Evaluator(const std::vector<AifsBlock>& blocks, std::size_t block)
        : blocks_(blocks), arithmetic_(1) {
        scopes_.push_back(aifs_scope(blocks, block));
        arithmetic_ = AifsArithmetic(dimension_of(scopes_.front()));
    }

    AifsSystem system(const std::optional<std::string>& wanted) {
        AifsScope& scope = scopes_.front();
        AifsSystem system;
        system.dimension = arithmetic_.dimension();
        (void)set_number(scope, root(scope, wanted));
        for (std::size_t i = 0; i < sets_.size(); ++i) {  // more are found on the way
            const auto [owner, name] = sets_[i];
            const AifsDefinition& definition = *owner->definitions[owner->places.at(name)];
            const AifsUnion value =
                arithmetic_.as_union(evaluate(definition.value, *owner), definition.position);
            system.sets.push_back({name, value});
        }
        read_subspace(scope, system);
        read_camera(scope, system);
        return system;
    }

  private:
    /// $dim, a number that depends on nothing.
    static std::size_t dimension_of(const AifsScope& scope) {
        const auto found = scope.places.find("$dim");
        if (found == scope.places.end())
            throw AifsMistake{scope.block->position, "the block has no $dim"};
        const AifsDefinition& definition = *scope.definitions[found->second];
        const double n = definition.value.number;
        if (definition.value.op != AifsOp::number || n != std::round(n) || n < 1 ||
            n > static_cast<double>(most_dimensions))
            throw AifsMistake{
                definition.position,
                fmt::format("$dim: expected a whole number from 1 to {}", most_dimensions)};
        return static_cast<std::size_t>(n);
    }

    static std::string root(const AifsScope& scope, const std::optional<std::string>& wanted) {
        if (wanted) return *wanted;
        if (const auto found = scope.places.find("$root"); found != scope.places.end()) {
            const AifsDefinition& definition = *scope.definitions[found->second];
            if (definition.value.op == AifsOp::name && scope.sets.contains(definition.value.name))
                return definition.value.name;
            throw AifsMistake{definition.position, "$root: expected the name of a set"};
        }
        for (const AifsDefinition* definition : scope.definitions)
            if (scope.sets.contains(definition->name)) return definition->name;
        throw AifsMistake{scope.block->position, "the block defines no set: expected S=(f1|f2)*S"};
    }

    /// A number for the set of that name, the same for the same set.
    int set_number(AifsScope& scope, const std::string& name) {
        const std::pair<AifsScope*, std::string> key{&scope, name};
        const auto [found, added] = numbers_.emplace(key, static_cast<int>(sets_.size()));
        if (added) sets_.push_back(key);
        return found->second;
    }

    AifsValue evaluate(const AifsExpression& e, AifsScope& scope) {
        if (++steps_ > most_steps) throw AifsMistake{e.position, "too much to compute"};
        if (depth_ >= deepest)
            throw AifsMistake{e.position, fmt::format("definitions inside one another more than {} "
                                                      "deep",
                                                      deepest)};
        ++depth_;
        AifsValue value = computed(e, scope);
        --depth_;
        return value;
    }

    AifsValue computed(const AifsExpression& e, AifsScope& scope) {
        switch (e.op) {
            case AifsOp::number:
                return {e.number};
            case AifsOp::name:
                return named(e, scope);
            case AifsOp::vector:
                return {std::make_shared<const std::vector<AifsValue>>(all(e.parts, scope))};
            case AifsOp::call:
                return called(e, scope);
            case AifsOp::index:
                return element(e, scope);
            case AifsOp::unite:
                return arithmetic_.unite(all(e.parts, scope), e.position);
            case AifsOp::sum:
            case AifsOp::product:
                return folded(e, scope);
            case AifsOp::power:
                return arithmetic_.power(evaluate(e.parts[0], scope), evaluate(e.parts[1], scope),
                                         e.position);
            case AifsOp::negative:
                break;
        }
        return arithmetic_.product({-1.0}, evaluate(e.parts[0], scope), e.position);
    }

    std::vector<AifsValue> all(const std::vector<AifsExpression>& parts, AifsScope& scope) {
        std::vector<AifsValue> values;
        for (const AifsExpression& part : parts) values.push_back(evaluate(part, scope));
        return values;
    }

    AifsValue folded(const AifsExpression& e, AifsScope& scope) {
        // From the right where all are products: a union then only ever stands before one set.
        const bool products =
            e.op == AifsOp::product && e.signs.find_first_not_of('*') == std::string::npos;
        if (products) {
            AifsValue value = evaluate(e.parts.back(), scope);
            for (std::size_t i = e.parts.size() - 1; i-- > 0;)
                value = arithmetic_.product(evaluate(e.parts[i], scope), value, e.position);
            return value;
        }
        AifsValue value = evaluate(e.parts[0], scope);
        for (std::size_t i = 1; i < e.parts.size(); ++i) {
            const AifsValue part = evaluate(e.parts[i], scope);
            value = applied(e.signs[i], value, part, e.parts[i].position);
        }
        return value;
    }

    AifsValue applied(char sign, const AifsValue& a, const AifsValue& b, const Position& place) {
        if (sign == '*') return arithmetic_.product(a, b, place);
        if (sign == '/') return arithmetic_.quotient(a, b, place);
        if (sign == '+') return arithmetic_.sum(a, b, 1, place);
        if (sign == '-') return arithmetic_.sum(a, b, -1, place);
        const double x = number_of(a, place);
        const double y = number_of(b, place);
        return {y == 0 ? x : x - y * std::floor(x / y)};  // the sign of y
    }

    AifsValue named(const AifsExpression& e, AifsScope& scope) {
        if (const auto known = scope.values.find(e.name); known != scope.values.end())
            return known->second;
        if (scope.sets.contains(e.name)) return arithmetic_.set(set_number(scope, e.name));
        const auto found = scope.places.find(e.name);
        if (found == scope.places.end()) {
            if (auto value = aifs_constant(e.name, arithmetic_.dimension(), e.position))
                return *value;
            throw AifsMistake{e.position, fmt::format("'{}' is not defined", printable(e.name))};
        }
        const AifsDefinition& definition = *scope.definitions[found->second];
        AifsValue value = evaluate(definition.value, scope);
        scope.values.emplace(e.name, value);
        return value;
    }

    AifsValue element(const AifsExpression& e, AifsScope& scope) {
        const AifsValue base = evaluate(e.parts[0], scope);
        const AifsVector* vector = std::get_if<AifsVector>(&base.value);
        if (vector == nullptr) throw AifsMistake{e.position, "expected a vector before '['"};
        const double index = number_of(evaluate(e.parts[1], scope), e.position);
        const auto size = static_cast<double>((*vector)->size());
        const double place = index < 0 ? index + size : index;
        if (index != std::round(index) || !(place >= 0 && place < size))
            throw AifsMistake{e.position,
                              fmt::format("there is no element {} in a vector of {}", index, size)};
        return (**vector)[static_cast<std::size_t>(place)];
    }

    AifsValue called(const AifsExpression& e, AifsScope& scope) {
        if (e.name == "if") return chosen(e, scope);
        const int block = block_number(blocks_, e.name);
        std::vector<AifsValue> arguments;
        const bool is_template = e.name.starts_with('$') && block < 0;
        // What is left to a search is told as such, whatever its arguments are.
        if (!is_template || e.name == "$companion") arguments = all(e.parts, scope);
        if (block >= 0)
            return block_value(e, static_cast<std::size_t>(block), std::move(arguments));
        if (auto value = aifs_function(e.name, arguments, arithmetic_.dimension(), e.position))
            return *value;
        throw AifsMistake{e.position, fmt::format("there is no function or block '{}' that can be "
                                                  "taken",
                                                  printable(e.name))};
    }

    /// if(c), if(c, a, b), if(c1, a, c2, b, otherwise): what is not chosen is not computed.
    AifsValue chosen(const AifsExpression& e, AifsScope& scope) {
        const std::size_t count = e.parts.size();
        if (count == 0 || (count > 1 && count % 2 == 0))
            throw AifsMistake{e.position, "if: expected 1 argument, 3, or more by 2"};
        for (std::size_t i = 0; i + 1 < count; i += 2)
            if (number_of(evaluate(e.parts[i], scope), e.position) > 0)
                return evaluate(e.parts[i + 1], scope);
        if (count > 1) return evaluate(e.parts.back(), scope);
        return {number_of(evaluate(e.parts[0], scope), e.position) > 0 ? 1.0 : 0.0};
    }

    /// A block as a function: its first names are the arguments, its last one is the value.
    AifsValue block_value(const AifsExpression& e, std::size_t block,
                          std::vector<AifsValue> arguments) {
        if (scopes_.size() > most_calls) throw AifsMistake{e.position, "too many calls of blocks"};
        AifsScope& scope = scopes_.emplace_back(aifs_scope(blocks_, block));
        std::vector<const AifsDefinition*> names;
        for (const AifsDefinition* definition : scope.definitions)
            if (definition->name.front() != '$') names.push_back(definition);
        if (names.size() < arguments.size() || names.empty())
            throw AifsMistake{e.position, fmt::format("the block '{}' does not take {} arguments",
                                                      printable(e.name), arguments.size())};
        for (std::size_t i = 0; i < arguments.size(); ++i)
            scope.values.emplace(names[i]->name, std::move(arguments[i]));
        AifsExpression result;
        result.op = AifsOp::name;
        result.name = names.back()->name;
        result.position = e.position;
        return evaluate(result, scope);
    }

    void read_subspace(AifsScope& scope, AifsSystem& system) {
        const auto found = scope.places.find("$subspace");
        if (found == scope.places.end()) return;
        const AifsDefinition& definition = *scope.definitions[found->second];
        const AifsValue value = evaluate(definition.value, scope);
        const AifsVector* vector = std::get_if<AifsVector>(&value.value);
        if (vector == nullptr || (*vector)->size() < 2)
            throw AifsMistake{definition.position, "$subspace: expected [matrix, number, ...]"};
        const AifsUnion matrix = arithmetic_.as_union((**vector)[0], definition.position);
        system.subspace_of = matrix->edges.front().map;
        for (std::size_t i = 1; i < (*vector)->size(); ++i) {
            const double cell = number_of((**vector)[i], definition.position);
            if (cell != std::round(cell) || cell < 0 ||
                cell >= static_cast<double>(system.dimension))
                throw AifsMistake{definition.position,
                                  fmt::format("$subspace: there is no part {}", cell)};
            system.cells.push_back(static_cast<int>(cell));
        }
    }

    void read_camera(AifsScope& scope, AifsSystem& system) {
        const auto found = scope.places.find("$camera");
        if (found == scope.places.end()) return;
        const AifsDefinition& definition = *scope.definitions[found->second];
        const AifsValue value = evaluate(definition.value, scope);
        const auto flatten = [&](const auto& self, const AifsValue& part, int depth) -> void {
            const AifsVector* vector = std::get_if<AifsVector>(&part.value);
            if (vector == nullptr || depth == 2) {
                system.camera.push_back(number_of(part, definition.position));
                return;
            }
            for (const AifsValue& inner : **vector) self(self, inner, depth + 1);
        };
        flatten(flatten, value, 0);
    }

    const std::vector<AifsBlock>& blocks_;
    AifsArithmetic arithmetic_;
    std::deque<AifsScope> scopes_;  // of the block, and one more a call; they stay where they are
    std::vector<std::pair<AifsScope*, std::string>> sets_;
    std::map<std::pair<AifsScope*, std::string>, int> numbers_;
    long steps_ = 0;
    int depth_ = 0;
};

}  // namespace

std::vector<AifsEntry> aifs_entries(const std::vector<AifsBlock>& blocks) {
    std::vector<AifsEntry> entries;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].text_of("$a") == "h") continue;
        AifsEntry entry;
        entry.block = i;
        entry.name = blocks[i].text_of("$n");
        if (entry.name.empty()) entry.name = blocks[i].id;
        if (entry.name.empty()) entry.name = fmt::format("block {}", i + 1);
        try {
            const AifsScope scope = aifs_scope(blocks, i);
            for (const AifsDefinition* definition : scope.definitions)
                if (scope.sets.contains(definition->name)) entry.sets.push_back(definition->name);
        } catch (const AifsMistake&) {  // told when the block is asked for
            entry.sets = {""};
        }
        if (!entry.sets.empty() || blocks[i].diagnostics.has_errors())
            entries.push_back(std::move(entry));
    }
    return entries;
}

AifsSystem evaluate_aifs(const std::vector<AifsBlock>& blocks, std::size_t block,
                         const std::optional<std::string>& set) {
    return Evaluator(blocks, block).system(set);
}

}  // namespace pxm::host
