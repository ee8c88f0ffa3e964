#!/usr/bin/env bash
# libeigen3-dev 3.4.0-4 (Debian 12), g++ 12.
#
# Asked for the singular values of a matrix with a NaN in it, JacobiSVD computes none and leaves in place what it had: a
# solver that has done another matrix before returns that one's values, which are finite, positive and in order. Only
# info() says so (InvalidInput). A good engineer expects a NaN to come out where a NaN went in, as it does from
# arithmetic, and so takes a finite result for a computed one.
#
# For a program: ask info() after each compute(), and do not keep a solver whose values are read without it.
#
# Seen on 2026-11-30:
#   singular values of diag(3, 2)                                3 2, Success
#   then of the same with a NaN                                  3 2, InvalidInput
#   holds
# shellcheck source=findings/packages.sh
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

command -v g++ >/dev/null || { echo "not tried: no g++" >&2; exit 77; }
fetch libeigen3-dev=3.4.0-4
cat >"$work/values.cpp" <<'CPP'
#include <Eigen/SVD>
#include <iostream>
#include <limits>

void tell(const Eigen::JacobiSVD<Eigen::Matrix2d>& svd) {
    std::cout << svd.singularValues()(0) << ' ' << svd.singularValues()(1) << ", "
              << (svd.info() == Eigen::Success ? "Success" : svd.info() == Eigen::InvalidInput ? "InvalidInput" : "else")
              << '\n';
}

int main() {
    Eigen::Matrix2d matrix;
    matrix << 3, 0, 0, 2;
    Eigen::JacobiSVD<Eigen::Matrix2d> svd(matrix);
    tell(svd);
    matrix(0, 1) = std::numeric_limits<double>::quiet_NaN();
    svd.compute(matrix);
    tell(svd);
}
CPP
g++ -std=c++17 -isystem "$work/root/usr/include/eigen3" "$work/values.cpp" -o "$work/values"
mapfile -t said < <("$work/values")

same "singular values of diag(3, 2)" "${said[0]}" "3 2, Success"
same "then of the same with a NaN" "${said[1]}" "3 2, InvalidInput"
holds
