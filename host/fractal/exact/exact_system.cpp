#include "host/fractal/exact/exact_system.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/system/sensitivity.hpp"

namespace pxm::host::exact {

namespace {

using Vector = std::vector<Polynomial>;

/// Arithmetic on elements in the generator of now.
class Arithmetic {
  public:
    explicit Arithmetic(const NumberField& field) : field_(field) {}
    [[nodiscard]] Polynomial product(const Polynomial& a, const Polynomial& b) const {
        constexpr long longest = 100'000;  // bits
        Polynomial product = remainder(a * b, field_.minimal_polynomial());
        if (product.bits() > longest) throw NotExact{"its numbers have too many digits"};
        return product;
    }
    [[nodiscard]] Polynomial quotient(const Polynomial& a, const Polynomial& b) const {
        return product(a, inverse_modulo(b, field_.minimal_polynomial()));
    }

  private:
    const NumberField& field_;
};

struct Written {
    std::array<Vector, 3> linear;  // rows
    Vector translation;
};

Vector image(const Arithmetic& with, const std::array<Vector, 3>& linear, const Vector& v) {
    Vector result(3);
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            result[r] = result[r] + with.product(linear[r][c], v[c]);
    return result;
}

Vector sum(const Vector& a, const Vector& b) {
    Vector c(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) c[i] = a[i] + b[i];
    return c;
}

Vector difference(const Vector& a, const Vector& b) {
    Vector c(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) c[i] = a[i] - b[i];
    return c;
}

/// Rows in reduced echelon form with the column that each begins in.
struct Basis {
    std::vector<Vector> rows;
    std::vector<std::size_t> columns;

    /// False if it was in the span already.
    bool add(const Arithmetic& with, Vector v) {
        for (std::size_t i = 0; i < rows.size(); ++i) subtract(with, v, rows[i], columns[i]);
        const auto first =
            std::ranges::find_if(v, [](const Polynomial& p) { return !p.is_zero(); });
        if (first == v.end()) return false;
        const auto column = static_cast<std::size_t>(first - v.begin());
        const Polynomial lead = *first;
        for (Polynomial& p : v) p = with.quotient(p, lead);
        for (Vector& row : rows) subtract(with, row, v, column);
        rows.push_back(v);
        columns.push_back(column);
        return true;
    }

  private:
    static void subtract(const Arithmetic& with, Vector& from, const Vector& row,
                         std::size_t column) {
        const Polynomial times = from[column];
        if (times.is_zero()) return;
        for (std::size_t i = 0; i < from.size(); ++i)
            from[i] = from[i] - with.product(times, row[i]);
    }
};

/// The fixed point, or nothing if there is not one alone.
std::optional<Vector> fixed_point_of(const Arithmetic& with, const Written& map) {
    Basis equations;  // (1 - A | a)
    for (std::size_t r = 0; r < 3; ++r) {
        Vector row(4);
        for (std::size_t c = 0; c < 3; ++c) row[c] = Polynomial(r == c ? 1 : 0) - map.linear[r][c];
        row[3] = map.translation[r];
        equations.add(with, row);
    }
    Vector point(3);
    if (equations.rows.size() != 3) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        if (equations.columns[i] > 2) return std::nullopt;
        point[equations.columns[i]] = equations.rows[i][3];
    }
    return point;
}

struct Subspace {
    Vector origin;
    Basis basis;
};

Subspace subspace_of(const Arithmetic& with, const std::vector<Written>& maps) {
    Subspace space;
    for (const Written& map : maps) {
        const auto point = fixed_point_of(with, map);
        if (!point) continue;
        space.origin = *point;
        break;
    }
    if (space.origin.empty()) throw NotExact{"no map has a fixed point of its own"};
    std::vector<Vector> waiting;
    for (const Written& map : maps)
        waiting.push_back(
            difference(sum(image(with, map.linear, space.origin), map.translation), space.origin));
    while (!waiting.empty() && space.basis.rows.size() < 3) {
        const Vector v = waiting.back();
        waiting.pop_back();
        if (!space.basis.add(with, v)) continue;
        for (const Written& map : maps) waiting.push_back(image(with, map.linear, v));
    }
    return space;
}

/// The entries of a map in the subspace's coordinates, row by row, translations last.
Vector in_coordinates(const Arithmetic& with, const Subspace& space, const Written& map) {
    const Basis& basis = space.basis;
    const std::size_t n = basis.rows.size();
    Vector rest = space.origin;  // the subspace's point whose coordinates are all 0
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t c = 0; c < 3; ++c)
            rest[c] = rest[c] - with.product(space.origin[basis.columns[j]], basis.rows[j][c]);
    const Vector moved = sum(image(with, map.linear, rest), map.translation);
    Vector entries(n * (n + 1));
    for (std::size_t j = 0; j < n; ++j) {
        const Vector column = image(with, map.linear, basis.rows[j]);
        for (std::size_t i = 0; i < n; ++i) entries[i * (n + 1) + j] = column[basis.columns[i]];
    }
    for (std::size_t i = 0; i < n; ++i) entries[i * (n + 1) + n] = moved[basis.columns[i]];
    return entries;
}

Polynomial minor(const Arithmetic& with, const Vector& e, std::size_t n, std::size_t row,
                 std::size_t column) {
    const auto at = [&](std::size_t r, std::size_t c) { return e[(r % n) * (n + 1) + c % n]; };
    if (n == 1) return Polynomial(1);
    if (n == 2) {
        const Polynomial p = at(row + 1, column + 1);
        return (row + column) % 2 == 0 ? p : Polynomial(0) - p;
    }
    return with.product(at(row + 1, column + 1), at(row + 2, column + 2)) -
           with.product(at(row + 1, column + 2), at(row + 2, column + 1));
}

Polynomial determinant_of(const Arithmetic& with, const Vector& e, std::size_t n) {
    Polynomial total;
    for (std::size_t c = 0; c < n; ++c) total = total + with.product(e[c], minor(with, e, n, 0, c));
    return total;
}

Vector inverse_of(const Arithmetic& with, const Vector& e, std::size_t n, const Polynomial& det) {
    Vector result(n * (n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            result[i * (n + 1) + j] = with.quotient(minor(with, e, n, j, i), det);
        Polynomial moved;
        for (std::size_t j = 0; j < n; ++j)
            moved = moved - with.product(result[i * (n + 1) + j], e[j * (n + 1) + n]);
        result[i * (n + 1) + n] = moved;
    }
    return result;
}

/// c with L^T G L = c G, where G has the scalar products of the basis; nothing if there is none.
std::optional<Polynomial> squared_ratio_of(const Arithmetic& with, const Subspace& space,
                                           const Vector& e) {
    const std::size_t n = space.basis.rows.size();
    const auto scalar = [&](const Vector& a, const Vector& b) {
        Polynomial p;
        for (std::size_t i = 0; i < 3; ++i) p = p + with.product(a[i], b[i]);
        return p;
    };
    std::vector<Vector> columns;  // where the basis goes
    for (std::size_t j = 0; j < n; ++j) {
        Vector v(3);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                v[c] = v[c] + with.product(e[i * (n + 1) + j], space.basis.rows[i][c]);
        columns.push_back(v);
    }
    const auto& rows = space.basis.rows;
    const Polynomial ratio =
        with.quotient(scalar(columns[0], columns[0]), scalar(rows[0], rows[0]));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            if (!(scalar(columns[i], columns[j]) == with.product(ratio, scalar(rows[i], rows[j]))))
                return std::nullopt;
    return ratio;
}

FieldFacts facts_of(const NumberField& numbers, std::size_t dimensions, bool rational) {
    constexpr long largest = 1L << 62;
    FieldFacts facts;
    facts.dimensions = static_cast<int>(dimensions);
    facts.degree = rational ? 1 : static_cast<int>(numbers.degree());
    facts.modulus.assign(static_cast<std::size_t>(facts.degree), 0);
    if (!rational) {
        const fmpq_poly_struct* p = numbers.minimal_polynomial().get();
        for (std::size_t i = 0; i < facts.modulus.size(); ++i) {
            const fmpz* c = fmpq_poly_numref(p) + i;
            if (fmpz_cmp_si(c, largest) >= 0 || fmpz_cmp_si(c, -largest) <= 0)
                throw NotExact{"the number field's polynomial is too large"};
            facts.modulus[i] = fmpz_get_si(c);
        }
        Algebraic generator = numbers.lifted(whole(0));
        generator.value = remainder(Polynomial::unknown(), numbers.minimal_polynomial());
        facts.generator = numbers.approximate(generator);
    }
    double power = 1;
    for (int i = 0; i < facts.degree; ++i, power *= facts.generator)
        facts.generator_power.push_back(power);
    return facts;
}

/// How far the written maps are from the rounded ones, at most, on a set around the origin of that
/// radius.
double rounding_of(const NumberField& numbers, const Written& map, const Affine& rounded,
                   double radius) {
    constexpr double slack = 1e-15;
    double far = 0;
    for (int r = 0; r < 3; ++r) {
        const auto row = static_cast<std::size_t>(r);
        for (int c = 0; c < 4; ++c) {
            const Polynomial& p =
                c < 3 ? map.linear[row][static_cast<std::size_t>(c)] : map.translation[row];
            Algebraic a = numbers.lifted(whole(0));
            a.value = p;
            const double x = numbers.approximate(a);
            const double y = c < 3 ? rounded.linear[c][r] : rounded.translation[r];
            far += (std::abs(x - y) + slack * std::abs(x)) * (c < 3 ? radius : 1);
        }
    }
    return far;
}

std::vector<Written> lifted(const WrittenMaps& from) {
    std::vector<Written> maps;
    for (const Entries& entries : from.maps) {
        Written& map = maps.emplace_back();
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c)
                map.linear[r].push_back(from.field.lifted(entries[r][c]).value);
            map.translation.push_back(from.field.lifted(entries[r][3]).value);
        }
    }
    return maps;
}

bool all_rational(const std::vector<Written>& maps) {
    const auto rational = [](const Polynomial& p) { return p.is_rational(); };
    return std::ranges::all_of(maps, [&](const Written& map) {
        return std::ranges::all_of(map.translation, rational) &&
               std::ranges::all_of(map.linear, [&](const Vector& row) {
                   return std::ranges::all_of(row, rational);
               });
    });
}

}  // namespace

ExactSystem exact_system(WrittenMaps written, const Rifs& rifs) {
    constexpr double same = 1e-12;  // what rounding explains by far
    ExactSystem system;
    const std::vector<Written> maps = lifted(written);
    system.numbers = std::move(written.field);
    const Arithmetic with(system.numbers);
    double change = 0;
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const double size = glm::length(rifs.maps[m].translation) + 1;
        const double far = rounding_of(system.numbers, maps[m], rifs.maps[m], 1);
        if (!(far <= same * size)) throw NotExact{"the rounded maps do not agree with the text"};
        change = std::max(change, far);
    }
    system.offset = change * sensitivity(rifs).lipschitz;
    const Subspace space = subspace_of(with, maps);
    const std::size_t n = space.basis.rows.size();
    system.field = facts_of(system.numbers, n, all_rational(maps));
    for (std::size_t i = 0; i < n; ++i) system.axes[i] = static_cast<int>(space.basis.columns[i]);
    if (n == 0) return system;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (c != space.basis.columns[i] && !space.basis.rows[i][c].is_zero())
                system.along_axes = false;
    for (const Written& map : maps) {
        const Vector entries = in_coordinates(with, space, map);
        system.maps.emplace_back(system.field, entries);
        const Polynomial det = determinant_of(with, entries, n);
        system.volume_ratio.push_back(det);
        if (!det.is_zero())
            system.inverses.emplace_back(system.field, inverse_of(with, entries, n, det));
        if (const auto ratio = squared_ratio_of(with, space, entries))
            system.squared_ratio.push_back(*ratio);
    }
    if (system.inverses.size() != maps.size()) system.inverses.clear();
    if (system.squared_ratio.size() != maps.size()) system.squared_ratio.clear();
    system.equal_ratios = !system.squared_ratio.empty() &&
                          std::ranges::all_of(system.squared_ratio, [&](const Polynomial& p) {
                              return p == system.squared_ratio[0];
                          });
    return system;
}

std::optional<std::vector<Polynomial>> kernel_vector(
    const ExactSystem& system, const std::vector<std::vector<Polynomial>>& rows) {
    const Arithmetic with(system.numbers);
    Basis basis;
    for (const Vector& row : rows) basis.add(with, row);
    if (basis.rows.size() + 1 != rows.size()) return std::nullopt;
    std::size_t free = 0;  // the column that no row begins in
    while (std::ranges::find(basis.columns, free) != basis.columns.end()) ++free;
    std::vector<Polynomial> kernel(rows.size());
    kernel[free] = Polynomial(1);
    for (std::size_t i = 0; i < basis.rows.size(); ++i)
        kernel[basis.columns[i]] = Polynomial(0) - basis.rows[i][free];
    return kernel;
}

Polynomial determinant(const ExactSystem& system,
                       const std::vector<std::vector<Polynomial>>& rows) {
    Vector entries;
    for (const auto& row : rows) {
        entries.insert(entries.end(), row.begin(), row.end());
        entries.emplace_back();  // where a map has its translation
    }
    return determinant_of(Arithmetic(system.numbers), entries, rows.size());
}

std::optional<double> common_measure(const ExactSystem& system,
                                     const std::vector<Polynomial>& numbers) {
    const Arithmetic with(system.numbers);
    const Polynomial* unit = nullptr;
    Polynomial measure;  // in units of the first that is not 0
    for (const Polynomial& number : numbers) {
        if (number.is_zero()) continue;
        if (unit == nullptr) unit = &number;
        const Polynomial ratio = with.quotient(number, *unit);
        if (!ratio.is_rational()) return std::nullopt;
        measure = rational_common_divisor(measure, ratio);
    }
    if (unit == nullptr) return std::nullopt;
    Algebraic a = system.numbers.lifted(whole(0));
    a.value = with.product(*unit, measure);
    return std::abs(system.numbers.approximate(a));
}

}  // namespace pxm::host::exact
