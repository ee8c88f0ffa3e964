// The functions that a source of ours declares and defines, with their parameters and their length.
#pragma once

#include <string>
#include <vector>

namespace pxm::test {

struct SourceFunction {
    std::string name;  // "lambda" if it has none
    int line;
    int parameters;
    int lines;  // from its name to its closing brace; 0 of a declaration
};

/// In the order of their names in the text. It reads tokens, not types: comments, strings and
/// directives are passed over, and what stands between two parentheses is a list of parameters if a
/// body follows, or if each of its parts is a type with a name.
[[nodiscard]] std::vector<SourceFunction> functions_of(const std::string& text);

}  // namespace pxm::test
