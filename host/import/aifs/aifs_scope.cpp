#include "host/import/aifs/aifs_scope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_parents = 100;

/// What a block does not inherit: its name, and whether it is hidden.
bool is_own(std::string_view name) { return name == "$n" || name == "$a"; }

void collect_names(const AifsExpression& expression, std::vector<const std::string*>& names) {
    if (expression.op == AifsOp::name || expression.op == AifsOp::call)
        names.push_back(&expression.name);
    for (const AifsExpression& part : expression.parts) collect_names(part, names);
}

/// Names that lead to themselves through what they are defined by, or to one that does: what is
/// left when all that only leads to what is known has been taken away.
void find_sets(AifsScope& scope) {
    const std::size_t count = scope.definitions.size();
    std::vector<std::vector<std::size_t>> users(count);
    std::vector<std::size_t> waits_for(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<const std::string*> names;
        collect_names(scope.definitions[i]->value, names);
        for (const std::string* name : names) {
            const auto found = scope.places.find(*name);
            if (found == scope.places.end()) continue;
            users[found->second].push_back(i);
            ++waits_for[i];
        }
    }
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < count; ++i)
        if (waits_for[i] == 0) known.push_back(i);
    for (std::size_t k = 0; k < known.size(); ++k)
        for (const std::size_t user : users[known[k]])
            if (--waits_for[user] == 0) known.push_back(user);
    for (std::size_t i = 0; i < count; ++i)
        if (waits_for[i] > 0) scope.sets.insert(scope.definitions[i]->name);
}

}  // namespace

int block_number(const std::vector<AifsBlock>& blocks, std::string_view id) {
    const auto found = std::ranges::find_if(
        blocks, [&](const AifsBlock& block) { return !id.empty() && block.id == id; });
    return found == blocks.end() ? -1 : static_cast<int>(found - blocks.begin());
}

AifsScope aifs_scope(const std::vector<AifsBlock>& blocks, std::size_t block) {
    std::vector<const AifsBlock*> line{&blocks[block]};  // the block and its parents
    while (!line.back()->parent.empty()) {
        const AifsBlock& child = *line.back();
        const int parent = block_number(blocks, child.parent);
        if (parent < 0)
            throw AifsMistake{child.position, fmt::format("there is no block '{}' to inherit from",
                                                          printable(child.parent))};
        line.push_back(&blocks[static_cast<std::size_t>(parent)]);
        if (line.size() > most_parents)
            throw AifsMistake{child.position,
                              fmt::format("more than {} parents, or a block that is its own parent",
                                          most_parents)};
    }
    AifsScope scope;
    scope.block = &blocks[block];
    for (const AifsBlock* one : line)
        if (one->diagnostics.has_errors())
            throw AifsMistake{one->position, "the block has mistakes of its own"};
    for (auto one = line.rbegin(); one != line.rend(); ++one) {
        for (const AifsDefinition& definition : (*one)->definitions) {
            if (*one != scope.block && is_own(definition.name)) continue;
            const auto [place, added] =
                scope.places.emplace(definition.name, scope.definitions.size());
            if (added) {
                scope.definitions.push_back(&definition);
            } else {
                scope.definitions[place->second] = &definition;
            }
        }
    }
    find_sets(scope);
    return scope;
}

}  // namespace pxm::host
