// The expressions of scenes (host/scene/parse/expression.hpp) in exact numbers, or in balls.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "host/flint/scene_numbers.hpp"
#include "host/scene/parse/token_reader.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

template <class Numbers>
class ExactExpressions {
  public:
    using Value = typename Numbers::Value;
    explicit ExactExpressions(const Scene& scene);

    /// Reads one expression of a text that was parsed before. Throws NotExact.
    [[nodiscard]] Value read(TokenReader& tokens);
    [[nodiscard]] Numbers& numbers() { return numbers_; }

  private:
    struct Let {
        int file = 0;
        std::string_view text;  // from its expression on
    };
    [[nodiscard]] Value product(TokenReader& tokens);
    [[nodiscard]] Value operand(TokenReader& tokens);
    [[nodiscard]] Value named(TokenReader& tokens, const Token& word);
    [[nodiscard]] Value constant(const std::string& name);

    Numbers numbers_;
    std::map<std::string, Let> lets_;
    std::map<std::string, Value> known_;
    int depth_ = 0;
};

extern template class ExactExpressions<FieldNumbers>;
extern template class ExactExpressions<BallNumbers>;

}  // namespace pxm::host
