// The expressions of scenes (host/scene/parse/expression.hpp) in exact numbers.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "host/fractal/exact/number_field.hpp"
#include "host/scene/parse/token_reader.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

class ExactExpressions {
  public:
    explicit ExactExpressions(const Scene& scene);

    /// Reads one expression of a text that was parsed before. Throws NotExact.
    [[nodiscard]] exact::Algebraic read(TokenReader& tokens);
    [[nodiscard]] exact::NumberField& field() { return field_; }

  private:
    struct Let {
        int file = 0;
        std::string_view text;  // from its expression on
    };
    [[nodiscard]] exact::Algebraic product(TokenReader& tokens);
    [[nodiscard]] exact::Algebraic operand(TokenReader& tokens);
    [[nodiscard]] exact::Algebraic named(TokenReader& tokens, const Token& word);
    [[nodiscard]] exact::Algebraic constant(const std::string& name);

    exact::NumberField field_;
    std::map<std::string, Let> lets_;
    std::map<std::string, exact::Algebraic> known_;
    int depth_ = 0;
};

}  // namespace pxm::host
